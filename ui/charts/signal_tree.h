// All channels of the shown runs, and those the open experiment will record, as a tree, split at
// the dots of their names, with a search field. Channels are dragged to charts or added by double
// click or Enter. Running again changes nothing but what is new or gone.
#pragma once

#include <QSet>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "sim/core/channel.h"

class QLineEdit;
class QSortFilterProxyModel;
class QStandardItem;
class QStandardItemModel;
class QTreeView;

namespace rotorbench {

class RunSet;

class SignalTree : public QWidget {
  Q_OBJECT

 public:
  /// `runs` outlives the tree.
  explicit SignalTree(RunSet* runs, QWidget* parent = nullptr);

  [[nodiscard]] QTreeView* view() const { return view_; }
  [[nodiscard]] QLineEdit* search() const { return search_; }
  /// Channels the experiment will record, to choose from before its first run.
  void setPlanned(std::vector<Channel> channels);
  /// Channels of the visible runs, then those planned; each name once.
  [[nodiscard]] std::vector<Channel> offered() const;
  /// Selected channels; a group stands for all channels in it.
  [[nodiscard]] QStringList selectedChannels() const;
  /// As a document begins: no search, nothing selected, groups closed.
  void resetView();

 signals:
  /// By double click or Enter.
  void channelsActivated(const QStringList& channels);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build();
  void takeChannels();
  void filter(const QString& text);
  void expandRemembered();
  QStandardItem* group(const QString& path);

  RunSet* runs_;
  std::vector<Channel> planned_;
  QLineEdit* search_;
  QTreeView* view_;
  QWidget* hint_;
  QStandardItemModel* model_;
  QSortFilterProxyModel* proxy_;
  QSet<QString> expanded_;
  bool remembering_ = true;
};

}  // namespace rotorbench
