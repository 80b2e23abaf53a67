#include "ui/charts/signal_tree.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTreeView>
#include <QVBoxLayout>
#include <functional>
#include <set>

#include "sim/core/unit_text.h"
#include "ui/charts/channel_mime.h"
#include "ui/charts/run_set.h"

namespace rotorbench {
namespace {

constexpr int kPathRole = Qt::UserRole + 1;
constexpr int kIsChannelRole = Qt::UserRole + 2;

void collectChannels(const QModelIndex& index, QStringList& channels) {
  const QModelIndex first = index.siblingAtColumn(0);
  if (first.data(kIsChannelRole).toBool()) {
    const QString path = first.data(kPathRole).toString();
    if (!channels.contains(path)) channels += path;
  }
  for (int row = 0; row < first.model()->rowCount(first); ++row) {
    collectChannels(first.model()->index(row, 0, first), channels);
  }
}

QStringList channelsOf(const QModelIndexList& indexes) {
  QStringList channels;
  for (const QModelIndex& index : indexes) collectChannels(index, channels);
  return channels;
}

class ChannelModel : public QStandardItemModel {
 public:
  using QStandardItemModel::QStandardItemModel;
  QStringList mimeTypes() const override { return {QLatin1String(kChannelMimeType)}; }
  QMimeData* mimeData(const QModelIndexList& indexes) const override {
    return channelMimeData(channelsOf(indexes)).release();
  }
};

/// Removes what `keep` does not hold; a group without members goes too.
void prune(QStandardItem* parent, const QSet<QString>& keep) {
  for (int row = parent->rowCount() - 1; row >= 0; --row) {
    QStandardItem* item = parent->child(row);
    prune(item, keep);
    const bool channel = keep.contains(item->data(kPathRole).toString());
    item->setData(channel, kIsChannelRole);
    if (!channel && item->rowCount() == 0) parent->removeRow(row);
  }
}

}  // namespace

SignalTree::SignalTree(RunSet* runs, QWidget* parent) : QWidget(parent), runs_(runs) {
  build();
  connect(runs_, &RunSet::changed, this, &SignalTree::takeChannels);
  connect(search_, &QLineEdit::textChanged, this, &SignalTree::filter);
  connect(view_, &QTreeView::activated, this, [this](const QModelIndex& index) {
    if (index.siblingAtColumn(0).data(kIsChannelRole).toBool())
      emit channelsActivated(selectedChannels());
  });
  const auto remember = [this](const QModelIndex& index, bool open) {
    if (!remembering_) return;
    const QString path = index.data(kPathRole).toString();
    open ? (void)expanded_.insert(path) : (void)expanded_.remove(path);
  };
  connect(view_, &QTreeView::expanded, this,
          [remember](const QModelIndex& i) { remember(i, true); });
  connect(view_, &QTreeView::collapsed, this,
          [remember](const QModelIndex& i) { remember(i, false); });
  takeChannels();
}

void SignalTree::build() {
  setObjectName(QStringLiteral("signalTree"));
  setAccessibleName(tr("Signals"));
  search_ = new QLineEdit(this);
  search_->setObjectName(QStringLiteral("signalSearch"));
  search_->setAccessibleName(tr("Search signals"));
  search_->setPlaceholderText(tr("Search signals"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  model_ = new ChannelModel(this);
  model_->setColumnCount(2);
  model_->setHorizontalHeaderLabels({tr("Signal"), tr("Unit")});
  proxy_ = new QSortFilterProxyModel(this);
  proxy_->setSourceModel(model_);
  proxy_->setFilterRole(kPathRole);
  proxy_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  proxy_->setRecursiveFilteringEnabled(true);
  view_ = new QTreeView(this);
  view_->setObjectName(QStringLiteral("signalView"));
  view_->setAccessibleName(tr("Signals of the shown runs"));
  view_->setModel(proxy_);
  view_->setUniformRowHeights(true);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setDragEnabled(true);
  view_->setDragDropMode(QAbstractItemView::DragOnly);
  view_->setDefaultDropAction(Qt::CopyAction);
  view_->header()->setStretchLastSection(false);
  view_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  view_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  auto* hint = new QLabel(tr("Press Run (F5) to see the signals of a run here."), this);
  hint->setObjectName(QStringLiteral("signalHint"));
  hint->setWordWrap(true);
  hint->setAlignment(Qt::AlignCenter);
  hint->setForegroundRole(QPalette::PlaceholderText);
  hint_ = hint;
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(search_);
  column->addWidget(hint_);
  column->addWidget(view_, 1);
}

QStandardItem* SignalTree::group(const QString& path) {
  QStandardItem* parent = model_->invisibleRootItem();
  if (!path.isEmpty() && path.contains(u'.')) parent = group(path.section(u'.', 0, -2));
  const QString name = path.section(u'.', -1);
  for (int row = 0; row < parent->rowCount(); ++row) {
    if (parent->child(row)->data(kPathRole).toString() == path) return parent->child(row);
  }
  auto* item = new QStandardItem(name);
  item->setData(path, kPathRole);
  auto* unit = new QStandardItem;
  unit->setForeground(palette().color(QPalette::PlaceholderText));
  unit->setData(path, kPathRole);
  for (auto* cell : {item, unit}) cell->setFlags(cell->flags() & ~Qt::ItemIsDropEnabled);
  parent->appendRow({item, unit});
  return item;
}

void SignalTree::setPlanned(std::vector<Channel> channels) {
  planned_ = std::move(channels);
  takeChannels();
}

std::vector<Channel> SignalTree::offered() const {
  std::vector<Channel> all = runs_->channels();
  std::set<std::string> seen;
  for (const Channel& channel : all) seen.insert(channel.name);
  for (const Channel& channel : planned_) {
    if (seen.insert(channel.name).second) all.push_back(channel);
  }
  return all;
}

void SignalTree::takeChannels() {
  const auto channels = offered();
  QSet<QString> keep;
  for (const auto& channel : channels) keep.insert(QString::fromStdString(channel.name));
  for (const auto& channel : channels) {
    QStandardItem* item = group(QString::fromStdString(channel.name));
    const QString unit = QString::fromStdString(prettyUnit(channel.unit));
    auto* parent = item->parent() ? item->parent() : model_->invisibleRootItem();
    parent->child(item->row(), 1)->setText(unit);
    const QString tip = QString::fromStdString(channel.description);
    item->setToolTip(unit.isEmpty() ? tip : QStringLiteral("%1 [%2]").arg(tip, unit));
    item->setAccessibleDescription(item->toolTip());
  }
  remembering_ = false;
  prune(model_->invisibleRootItem(), keep);
  remembering_ = true;
  hint_->setVisible(channels.empty());
  view_->setVisible(!channels.empty());
  expandRemembered();
}

void SignalTree::expandRemembered() {
  remembering_ = false;
  const std::function<void(const QModelIndex&)> visit = [&](const QModelIndex& parent) {
    for (int row = 0; row < proxy_->rowCount(parent); ++row) {
      const QModelIndex index = proxy_->index(row, 0, parent);
      const bool open =
          !search_->text().isEmpty() || expanded_.contains(index.data(kPathRole).toString());
      view_->setExpanded(index, open);
      visit(index);
    }
  };
  visit({});
  remembering_ = true;
}

void SignalTree::filter(const QString& text) {
  proxy_->setFilterFixedString(text.trimmed());
  expandRemembered();
}

void SignalTree::resetView() {
  expanded_.clear();
  search_->clear();
  view_->setCurrentIndex({});
  view_->clearSelection();
  expandRemembered();
}

QStringList SignalTree::selectedChannels() const {
  return channelsOf(view_->selectionModel()->selectedRows());
}

bool SignalTree::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down) {
    view_->setFocus();
    if (!view_->currentIndex().isValid()) view_->setCurrentIndex(proxy_->index(0, 0));
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace rotorbench
