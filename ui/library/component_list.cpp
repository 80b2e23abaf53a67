#include "ui/library/component_list.h"

#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/library/component_text.h"

namespace rotorbench {

namespace {

constexpr int kFileRole = Qt::UserRole;
enum Column { kName, kKind, kFigures };

QString fileOf(const LibraryEntry& entry) {
  return QString::fromStdString(entry.file.string());
}

}  // namespace

ComponentList::ComponentList(const ComponentLibrary& library, const UnitPreferences& units,
                             std::vector<const ComponentKind*> kinds, QWidget* parent)
    : QWidget(parent),
      library_(library),
      units_(units),
      kinds_(std::move(kinds)),
      search_(new QLineEdit(this)),
      kind_(new QComboBox(this)),
      tree_(new QTreeWidget(this)) {
  search_->setObjectName(QStringLiteral("librarySearch"));
  search_->setPlaceholderText(tr("Search"));
  search_->setAccessibleName(tr("Search in names and summaries"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  kind_->setObjectName(QStringLiteral("libraryKind"));
  kind_->setAccessibleName(tr("Kind of component"));
  kind_->addItem(tr("All kinds"));
  for (const auto* kind : kinds_) kind_->addItem(toQString(kind->label));
  kind_->setVisible(kinds_.size() > 1);
  buildTree();
  auto* top = new QHBoxLayout;
  top->addWidget(search_, 1);
  top->addWidget(kind_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(form_style::kGrid);
  column->addLayout(top);
  column->addWidget(tree_, 1);
  const auto again = [this] { reload(); };
  connect(search_, &QLineEdit::textChanged, this, again);
  connect(kind_, &QComboBox::currentIndexChanged, this, again);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &ComponentList::currentChanged);
  connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this] {
    if (current() != nullptr) emit activated();
  });
  fill();
  choose({});
}

void ComponentList::buildTree() {
  tree_->setObjectName(QStringLiteral("libraryList"));
  tree_->setAccessibleName(tr("Components"));
  tree_->setHeaderLabels({tr("Name"), tr("Kind"), tr("Key figures")});
  tree_->setColumnHidden(kKind, kinds_.size() < 2);
  tree_->installEventFilter(this);
  tree_->setRootIsDecorated(false);
  tree_->setIndentation(form_style::kMargin);
  tree_->setUniformRowHeights(true);
  tree_->setAllColumnsShowFocus(true);
  tree_->setTextElideMode(Qt::ElideRight);
  tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  tree_->header()->setStretchLastSection(true);
}

const LibraryEntry* ComponentList::current() const {
  const QTreeWidgetItem* item = tree_->currentItem();
  const QString file = item == nullptr ? QString() : item->data(kName, kFileRole).toString();
  if (file.isEmpty()) return nullptr;
  const auto& entries = library_.entries();
  const auto found = std::ranges::find_if(
      entries, [&file](const LibraryEntry& entry) { return fileOf(entry) == file; });
  return found == entries.end() ? nullptr : &*found;
}

bool ComponentList::isShown(const LibraryEntry& entry, const QStringList& words) const {
  const ComponentKind* kind = kindOf(*entry.component.type);
  if (std::ranges::find(kinds_, kind) == kinds_.end()) return false;
  const int chosen = kind_->currentIndex();
  if (chosen > 0 && kinds_[static_cast<std::size_t>(chosen - 1)] != kind) return false;
  const ComponentInfo& info = entry.component.info;
  const QString text = toQString(info.name + '\n' + info.summary + '\n' + kind->label);
  return std::ranges::all_of(
      words, [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

QTreeWidgetItem* ComponentList::addGroup(const QString& title) {
  auto* group = new QTreeWidgetItem(tree_, {title});
  group->setFlags(Qt::ItemIsEnabled);
  QFont font = tree_->font();
  font.setBold(true);
  group->setFont(kName, font);
  group->setFirstColumnSpanned(true);
  return group;
}

void ComponentList::addEntry(QTreeWidgetItem* group, const LibraryEntry& entry) {
  const ComponentInfo& info = entry.component.info;
  const QString figures = keyFiguresText(entry.component, units_, locale_);
  auto* item = new QTreeWidgetItem(
      group, {toQString(info.name), toQString(kindOf(*entry.component.type)->label), figures});
  item->setData(kName, kFileRole, fileOf(entry));
  item->setToolTip(kName, toQString(info.name));
  item->setToolTip(kFigures, figures);
  const bool warned = !info.warning.empty();
  // Those without a warning have an invisible sign, so that all names stand in line.
  item->setIcon(kName, form_style::discIcon(warned ? form_style::severityColour(
                                                         form_style::Severity::Warning, palette())
                                                   : QColor(Qt::transparent)));
  if (warned) item->setData(kName, Qt::AccessibleDescriptionRole, toQString(info.warning));
}

void ComponentList::fill() {
  const QStringList words = search_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  tree_->clear();
  for (const bool own : {true, false}) {
    QTreeWidgetItem* group = nullptr;
    for (const LibraryEntry& entry : library_.entries()) {
      if (entry.own != own || !isShown(entry, words)) continue;
      if (group == nullptr) group = addGroup(own ? tr("Your components") : tr("Shipped"));
      addEntry(group, entry);
    }
  }
  if (tree_->topLevelItemCount() == 0) {
    auto* none = addGroup(words.isEmpty() ? tr("There are no components of this kind.")
                                          : tr("No component is called that."));
    none->setFlags(Qt::NoItemFlags);
  }
  tree_->expandAll();
  tree_->resizeColumnToContents(kName);
  tree_->resizeColumnToContents(kKind);
  constexpr int kWidestName = 240;
  tree_->setColumnWidth(kName, std::min(kWidestName, tree_->columnWidth(kName)));
}

void ComponentList::choose(const std::filesystem::path& file) {
  const QString wanted = QString::fromStdString(file.string());
  QTreeWidgetItem* best = nullptr;
  for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it) {
    const QString at = (*it)->data(kName, kFileRole).toString();
    if (at.isEmpty()) continue;
    if (best == nullptr || at == wanted) best = *it;
  }
  tree_->setCurrentItem(best);
  if (best != nullptr) tree_->scrollToItem(best);
  const bool first = best != nullptr && tree_->topLevelItem(0)->child(0) == best;
  if (first) tree_->scrollToTop();  // with its heading
  emit currentChanged();
}

void ComponentList::reload(const std::filesystem::path& wanted) {
  const QTreeWidgetItem* item = tree_->currentItem();
  const QString kept = item == nullptr ? QString() : item->data(kName, kFileRole).toString();
  fill();
  choose(wanted.empty() ? std::filesystem::path(kept.toStdString()) : wanted);
}

void ComponentList::focusSearch() {
  search_->setFocus(Qt::OtherFocusReason);
}

bool ComponentList::eventFilter(QObject* watched, QEvent* event) {
  if (watched == tree_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && current() != nullptr) {
      emit activated();
      return true;
    }
  }
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    // The list answers to the keys that move, while the text is still being typed.
    if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up || key->key() == Qt::Key_PageDown ||
        key->key() == Qt::Key_PageUp) {
      QKeyEvent copy(key->type(), key->key(), key->modifiers());
      tree_->setFocus(Qt::OtherFocusReason);
      QCoreApplication::sendEvent(tree_, &copy);
      return true;
    }
    if (key->key() == Qt::Key_Escape && !search_->text().isEmpty()) {
      search_->clear();
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace rotorbench
