// One chart: title, plot, legend with read-outs. Shows the channels its specification names of all
// visible runs and follows them while they grow. Takes channels dropped from the signal tree.
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>
#include <vector>

#include "ui/charts/chart_frame.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/curves.h"
#include "ui/charts/plot_widget.h"
#include "ui/charts/run_set.h"

class QAction;
class QBoxLayout;
class QLineEdit;
class QMenu;
class QToolButton;

namespace rotorbench {

class ChartLegend;

class ChartPane : public QFrame {
  Q_OBJECT

 public:
  /// Rows one refresh reads that were not read before: keeps a refresh short when a long recording
  /// is opened.
  static constexpr std::size_t kRowsPerRefresh = 1'000'000;

  /// `runs` and `link` are shared with other panes and outlive this one.
  ChartPane(RunSet* runs, ChartLink* link, QWidget* parent = nullptr);
  ~ChartPane() override;

  /// Height in px from which curves and ticks of a pane this wide can be read.
  [[nodiscard]] static int readableHeight(int width);

  [[nodiscard]] const ChartSpec& spec() const { return spec_; }
  void setSpec(const ChartSpec& spec);
  void addChannel(const QString& channel);
  void removeChannel(const QString& channel);

  /// Shows rows that are new since the last call; reads at most `rowBudget` of them and counts it
  /// down. Cheap if nothing is new. Returns whether anything was drawn.
  bool refresh(std::size_t& rowBudget);
  bool refresh();

  [[nodiscard]] ChartView view() const;
  void setView(const ChartView& view);
  void fit();
  /// Forgets all of the view: zoom, its history and which curves are hidden.
  void resetView();
  /// Changes the view if nothing of a run that has come is seen in it; back() undoes that.
  void bringIn(const Recording& recording);
  /// Undoes the last zoom or pan; false if there is none.
  bool back();

  [[nodiscard]] const CurveList& curves() const { return curves_; }
  [[nodiscard]] const RunSet& runs() const { return *runs_; }
  [[nodiscard]] PlotWidget* plot() const { return plot_; }
  [[nodiscard]] ChartLegend* legend() const { return legend_; }
  [[nodiscard]] QMenu* menu() const { return menu_; }
  /// The frame of this view for a plot of another size, complete.
  [[nodiscard]] ChartFrame frameFor(QSizeF plotSize, double pixelRatio,
                                    const QLocale& locale) const;
  /// The pane a grid shows as the one that takes channels added by keyboard or double click.
  void setCurrent(bool current);
  void setMaximized(bool maximized);

 signals:
  /// A person changed the specification.
  void specChanged();
  void activated();
  void maximizeAsked();
  void closeAsked();
  void splitAsked(Qt::Orientation orientation);
  void exportAsked();
  void copyAsked();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build();
  void buildMenu();
  void fillRemoveMenu();
  void updateIcons();
  void edit(const ChartSpec& spec);
  void takeCurves();
  void updateHint();
  void updateMarks();
  void updateReadouts();
  void placeLegend();
  void viewChosen(const ChartView& view, bool continuous);
  void markStale();
  [[nodiscard]] std::size_t publishedRows() const;
  [[nodiscard]] bool sees(const Recording& recording, const ChartView& view) const;
  [[nodiscard]] std::vector<PlotWidget::Ring> rings() const;

  RunSet* runs_;
  ChartLink* link_;
  ChartSpec spec_;
  HiddenCurves hidden_;
  CurveList curves_;
  mutable FrameBuilder builder_;
  std::optional<Span> x_;  ///< of an xy chart; a time chart shares it through the link
  std::map<std::string, Span> y_;
  std::vector<ChartView> history_;
  QElapsedTimer gestureClock_;
  bool stale_ = true;
  bool dropHere_ = false;
  bool current_ = false;
  bool maximized_ = false;
  std::size_t rowsShown_ = 0;
  bool growingShown_ = false;

  QLineEdit* title_ = nullptr;
  QToolButton* maximizeButton_ = nullptr;
  QToolButton* menuButton_ = nullptr;
  PlotWidget* plot_ = nullptr;
  ChartLegend* legend_ = nullptr;
  QBoxLayout* content_ = nullptr;  ///< plot and legend, below or beside each other
  QMenu* menu_ = nullptr;
  QMenu* removeMenu_ = nullptr;
  QTimer pending_;
};

}  // namespace rotorbench
