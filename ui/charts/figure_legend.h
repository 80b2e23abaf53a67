// The legend of a figure on paper: samples and names in rows no wider than the figure; a name that
// is wider by itself goes on in lines below. Lengths in the figure's units.
#pragma once

#include <QFont>
#include <QPainter>
#include <vector>

#include "ui/charts/chart_frame.h"

namespace rotorbench {

class FigureLegend {
 public:
  /// Of the curves that are shown, in their order.
  FigureLegend(const ChartFrame& frame, const QFont& font, qreal width);
  [[nodiscard]] qreal height() const { return height_; }
  /// `at`: the upper left corner.
  void paint(QPainter& painter, QPointF at, qreal lineWidth) const;

 private:
  struct Entry {
    CurveStyle style;
    bool mark = false;
    QStringList lines;
    QPointF at;  ///< left end of the sample, middle of the first line
  };

  QFont font_;
  std::vector<Entry> entries_;
  qreal height_ = 0;
};

}  // namespace rotorbench
