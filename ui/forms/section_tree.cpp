#include "ui/forms/section_tree.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/forms/default_values.h"
#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/forms/sections.h"

namespace rotorbench {

using form_style::Severity;
using schema::Kind;

namespace {

enum Role { kPathRole = Qt::UserRole, kParameterRole };

/// A drawing of our own for the struct's key, else nothing: a row of equal folder icons says
/// nothing.
QIcon sectionIcon(const QString& typeKey) {
  const QString file = QStringLiteral(":/icons/sections/%1.svg").arg(typeKey);
  return QFile::exists(file) ? QIcon(file) : QIcon();
}

bool matches(const schema::Field& field, const QStringList& words) {
  const QString text =
      QStringList{toQString(field.label), toQString(field.key), toQString(field.symbol)}.join(
          QLatin1Char('\n'));
  for (const QString& word : words) {
    if (!text.contains(word, Qt::CaseInsensitive)) return false;
  }
  return true;
}

void collect(schema::ConstRef object, const QString& path, const QStringList& words,
             const std::function<void(const QString&, const schema::Field&)>& hit) {
  for (const auto& field : object.type->fields) {
    const QString place = joinPath(path, toQString(field.key));
    if (matches(field, words)) hit(place, field);
    if (field.isLeaf()) continue;
    if (field.kind != Kind::List) {
      collect({&field.childType(object.object, 0), field.constChild(object.object, 0)}, place,
              words, hit);
    } else if (field.asTable) {
      for (const auto& column : field.childType(object.object, 0).fields) {
        if (matches(column, words)) hit(place, column);
      }
    } else {
      for (std::size_t i = 0; i < field.count(object.object); ++i) {
        collect({&field.childType(object.object, i), field.constChild(object.object, i)},
                elementPath(place, i), words, hit);
      }
    }
  }
}

}  // namespace

SectionTree::SectionTree(const FormContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      search_(new QLineEdit(this)),
      tree_(new QTreeWidget(this)) {
  setObjectName(QStringLiteral("sectionTree"));
  search_->setObjectName(QStringLiteral("parameterSearch"));
  search_->setPlaceholderText(tr("Find a parameter"));
  search_->setAccessibleName(tr("Find a parameter by name, key or symbol"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  tree_->setObjectName(QStringLiteral("sections"));
  tree_->setAccessibleName(tr("Sections of the experiment"));
  tree_->setColumnCount(2);
  tree_->setHeaderHidden(true);
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setMinimumSectionSize(22);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
  tree_->header()->resizeSection(1, 22);
  tree_->setIndentation(14);
  tree_->setUniformRowHeights(true);
  tree_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(form_style::kGrid);
  column->addWidget(search_);
  column->addWidget(tree_, 1);
  later_.setSingleShot(true);
  connect(&later_, &QTimer::timeout, this, [this] {
    if (shapeChanged_) return rebuild();
    updateMarks();
  });
  const auto shape = [this] {
    shapeChanged_ = true;
    later_.start(0);
  };
  DocumentModel* model = context.model;
  connect(model, &DocumentModel::structureChanged, this, shape);
  connect(model, &DocumentModel::documentReplaced, this, [this] {
    section_.clear();
    collapsed_.clear();
    search_->clear();
    rebuild();
  });
  connect(model, &DocumentModel::valueChanged, this, [this, shape](const QString& path) {
    // A text may be the name of a list element.
    const auto at = context_.model->find(path);
    at && at->field->kind == Kind::Text ? shape() : later_.start(0);
  });
  connect(model, &DocumentModel::problemsChanged, this, [this] { later_.start(0); });
  connect(search_, &QLineEdit::textChanged, this, &SectionTree::rebuild);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &SectionTree::onCurrentChanged);
  connect(tree_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
    if (item->data(0, kParameterRole).toBool()) {
      emit placeChosen(item->data(0, kPathRole).toString());
    }
  });
  connect(tree_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
    if (item->data(0, kParameterRole).toBool()) {
      emit placeChosen(item->data(0, kPathRole).toString());
    }
  });
  connect(tree_, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* item) {
    if (!building_) collapsed_.insert(item->data(0, kPathRole).toString());
  });
  connect(tree_, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) {
    if (!building_) collapsed_.remove(item->data(0, kPathRole).toString());
  });
  rebuild();
}

QString SectionTree::currentSection() const {
  return section_;
}

void SectionTree::focusSearch() {
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

QTreeWidgetItem* SectionTree::makeItem(const QString& path, const QString& title, bool parameter) {
  auto* item = new QTreeWidgetItem(QStringList{title});
  item->setData(0, kPathRole, path);
  item->setData(0, kParameterRole, parameter);
  item->setToolTip(0, placeText(context_.model->root(), path));
  if (parameter) {
    item->setForeground(0, palette().color(QPalette::Link));
    return item;
  }
  if (const auto object = context_.model->object(path)) {
    item->setIcon(0, sectionIcon(toQString(object->type->key)));
  }
  items_[path] = item;
  return item;
}

void SectionTree::addChildren(QTreeWidgetItem* parent, const QString& section, const Found* found) {
  if (found != nullptr) {
    for (const auto& [path, label] : found->value(section)) {
      parent->addChild(makeItem(path, label, true));
    }
  }
  forEachSubsection(context_.model->root(), section,
                    [&](const QString& path, const QString& title) {
                      auto* item = makeItem(path, title, false);
                      addChildren(item, path, found);
                      if (found != nullptr && item->childCount() == 0) {
                        items_.remove(path);
                        delete item;
                        return;
                      }
                      parent->addChild(item);
                    });
}

SectionTree::Found SectionTree::search(const QString& words) const {
  Found found;
  const auto root = context_.model->root();
  collect(root, {}, words.split(QLatin1Char(' '), Qt::SkipEmptyParts),
          [&](const QString& path, const schema::Field& field) {
            auto& places = found[sectionOf(root, path)];
            const QPair<QString, QString> place{path, toQString(field.label)};
            if (!places.contains(place)) places += place;
          });
  return found;
}

void SectionTree::rebuild() {
  shapeChanged_ = false;
  building_ = true;
  tree_->clear();
  items_.clear();
  const QString words = search_->text().trimmed();
  const Found found = words.isEmpty() ? Found() : search(words);
  auto* top = makeItem({}, toQString(context_.model->root().type->label), false);
  addChildren(top, {}, words.isEmpty() ? nullptr : &found);
  tree_->addTopLevelItem(top);
  for (auto it = items_.constBegin(); it != items_.constEnd(); ++it) {
    it.value()->setExpanded(!words.isEmpty() || !collapsed_.contains(it.key()));
  }
  if (!words.isEmpty() && top->childCount() == 0) {
    auto* none = new QTreeWidgetItem(top, {tr("No parameter is called that.")});
    none->setFlags(Qt::NoItemFlags);
    top->setExpanded(true);
  }
  building_ = false;
  showSection(section_);
  updateMarks();
}

void SectionTree::showSection(const QString& path) {
  section_ = path;
  QTreeWidgetItem* item = items_.value(path, nullptr);
  if (item == nullptr && search_->text().isEmpty()) item = items_.value({}, nullptr);
  building_ = true;
  if (item != nullptr) {
    tree_->setCurrentItem(item);
    tree_->scrollToItem(item);
  }
  building_ = false;
}

void SectionTree::onCurrentChanged() {
  const QTreeWidgetItem* item = tree_->currentItem();
  if (building_ || item == nullptr) return;
  if (item->data(0, kParameterRole).toBool()) return;
  section_ = item->data(0, kPathRole).toString();
  emit sectionSelected(section_);
}

void SectionTree::updateMarks() {
  for (auto* item : std::as_const(items_)) updateMark(item);
}

void SectionTree::updateMark(QTreeWidgetItem* item) {
  const QString path = item->data(0, kPathRole).toString();
  Severity severity = Severity::None;
  QString sentence;
  for (const Problem& problem : context_.model->problems()) {
    if (!isAtOrBelow(toQString(problem.path), path)) continue;
    if (sentence.isEmpty() || !problem.warning) sentence = problemSentence(problem);
    severity = problem.warning && severity != Severity::Error ? Severity::Warning : Severity::Error;
  }
  DefaultsCursor cursor(context_.model->root(), context_.model->defaults());
  const bool changed =
      cursor.descend(path) && differsFromDefault(cursor.object(), cursor.defaultObject());
  QString state;
  if (severity != Severity::None) {
    item->setIcon(1, form_style::severityIcon(severity, palette()));
    state = sentence;
  } else if (changed) {
    item->setIcon(1, form_style::discIcon(palette().color(QPalette::Highlight)));
    state = tr("Changed from the default.");
  } else {
    item->setIcon(1, QIcon());
  }
  item->setToolTip(1, state);
  item->setData(0, Qt::AccessibleDescriptionRole, state);
}

void SectionTree::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) later_.start(0);
}

bool SectionTree::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape && !search_->text().isEmpty()) {
      search_->clear();
      return true;
    }
    if (key->key() == Qt::Key_Down) {
      tree_->setFocus(Qt::OtherFocusReason);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace rotorbench
