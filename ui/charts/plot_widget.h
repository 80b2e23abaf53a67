// The plot of a chart on the screen: paints a frame and the cursors, and turns wheel, mouse and
// keys into the view a person asks for. It changes nothing by itself; the pane decides.
#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>

#include "ui/charts/chart_frame.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/curve_layer.h"
#include "ui/charts/plot_marks.h"
#include "ui/charts/plot_painter.h"

namespace rotorbench {

class PlotWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PlotWidget(ChartLink* link, QWidget* parent = nullptr);

  /// A place (data units and axis) that an xy chart marks for a time cursor.
  struct Ring {
    QPointF place;
    std::size_t axis = 0;
  };
  struct Content {
    ChartFrame frame;
    ChartKind kind = ChartKind::Time;  ///< tells whether the horizontal axis is the shared time
    ChartView view;                    ///< what a person chose; the frame has what came of it
    std::vector<Ring> rings;
  };
  void setContent(Content content);
  void setRings(std::vector<Ring> rings);
  /// What happened to the runs, shown on a time axis.
  void setMarks(std::vector<PlotMark> marks);
  [[nodiscard]] const std::vector<PlotMark>& marks() const { return marks_; }
  [[nodiscard]] const ChartFrame& frame() const { return content_.frame; }
  [[nodiscard]] qsizetype pointCount() const { return layer_.pointCount(); }
  /// A sentence in the middle of the plot; empty for none.
  void setHint(const QString& hint);
  [[nodiscard]] QString hint() const { return hint_; }
  [[nodiscard]] const PlotLayout& plotLayout() const { return layout_; }
  /// Size of the plot inside the axes for which the next frame should be made.
  [[nodiscard]] QSizeF plotSize() const;
  /// Forgets label widths kept so that nothing moves.
  void relayout();

  QSize minimumSizeHint() const override { return {160, 100}; }

 signals:
  /// A person chose this view; `continuous` while a gesture (wheel, pan) goes on.
  void viewChosen(const rotorbench::ChartView& view, bool continuous);
  void fitAsked();
  void rightClicked(QPoint globalPosition);
  /// By the keyboard.
  void menuAsked(QPoint globalPosition);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  enum class Gesture { None, Band, Pan, CursorA, CursorB };

  void takeContent();
  [[nodiscard]] QPointF toUnit(QPointF pixel) const;
  [[nodiscard]] std::optional<Cursor> cursorNear(QPointF pixel) const;
  void zoomAt(QPointF pixel, double factor, bool onlyY);
  /// Moves the ranges of `from` by parts of the axes.
  void panBy(QPointF unitShift, const ChartView& from, const ChartFrame& frame);
  void chooseBand();
  void placeCursor(Cursor which, QPointF pixel);
  void dragTo(QPointF pixel);
  bool moveCursorByKey(int direction, Cursor which);
  void renderStatic();
  void paintCursors(QPainter& painter);
  void paintHint(QPainter& painter);

  ChartLink* link_;
  Content content_;
  QString hint_;
  std::vector<PlotMark> marks_;
  PlotLayout layout_;
  LabelWidths labelWidths_;
  CurveLayer layer_;
  QPixmap pixmap_;
  bool stale_ = true;

  Gesture gesture_ = Gesture::None;
  QPointF press_, last_;
  bool moved_ = false;
  std::optional<double> cursorBeforeClick_;
  Content contentAtPress_;  ///< without curves
};

}  // namespace rotorbench
