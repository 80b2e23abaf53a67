// The charts of an experiment side by side: panes in rows that can be added, removed, split and
// shown alone; one shared time axis, shared cursors, and one clock that keeps the visible panes up
// to date while runs grow.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "sim/document/chart_spec.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/pane_area.h"
#include "ui/charts/run_arrivals.h"
#include "ui/charts/run_set.h"

class QStackedLayout;

namespace rotorbench {

class ChartPane;

class ChartGrid : public QWidget {
  Q_OBJECT

 public:
  /// `runs` outlives the grid.
  explicit ChartGrid(RunSet* runs, QWidget* parent = nullptr);
  ~ChartGrid() override;

  /// Shows these charts; panes that are already there keep their zoom and hidden curves.
  void setSpecs(const std::vector<ChartSpec>& specs);
  [[nodiscard]] std::vector<ChartSpec> specs() const;
  /// As a document begins: all fitted, nothing hidden, no cursors, panes where they are at first.
  void resetView();

  [[nodiscard]] const std::vector<ChartPane*>& panes() const { return panes_; }
  /// The pane that takes channels from the signal tree; null without panes.
  [[nodiscard]] ChartPane* currentPane() const { return current_; }
  void setCurrentPane(ChartPane* pane);
  [[nodiscard]] ChartLink* link() { return &link_; }

  ChartPane* addPane(const ChartSpec& spec = {});
  /// A new empty pane beside (Qt::Horizontal) or below the given one.
  ChartPane* splitPane(ChartPane* pane, Qt::Orientation orientation);
  void removePane(ChartPane* pane);
  /// Shows one pane alone, or all of them (null).
  void maximize(ChartPane* pane);
  [[nodiscard]] ChartPane* maximizedPane() const { return maximized_; }
  /// Adds to the current pane, or to a new one if there is none.
  void addChannels(const QStringList& channels);

  /// Brings visible panes up to date within the time of a frame; the grid calls it itself while
  /// runs grow.
  void refresh();
  /// Cursor A of all charts, in s, as the 3D scene sets it.
  void setTimeCursor(std::optional<double> time);
  /// Asks for a file and exports the pane to it.
  void exportByDialog(ChartPane* pane);

 signals:
  /// A person changed, added or removed a chart.
  void specsChanged();
  void timeCursorMoved(double time);
  /// One sentence for the status bar.
  void message(const QString& sentence);

 protected:
  void showEvent(QShowEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildEmptyState();
  ChartPane* makePane(const ChartSpec& spec);
  void place(const PaneRows& rows);
  void startClock();
  void setEdited();

  RunSet* runs_;
  ChartLink link_;
  std::vector<ChartPane*> panes_;
  PaneRows rows_;
  ChartPane* current_ = nullptr;
  ChartPane* maximized_ = nullptr;
  QStackedLayout* pages_;
  QWidget* empty_;
  PaneArea* area_;
  RunArrivals arrivals_;
  QTimer clock_;
  std::size_t nextToRefresh_ = 0;
};

}  // namespace rotorbench
