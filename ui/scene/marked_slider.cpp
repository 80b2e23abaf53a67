#include "ui/scene/marked_slider.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>
#include <cmath>
#include <utility>

namespace rotorbench {

void MarkedSlider::setMarks(std::vector<double> places) {
  if (places == marks_) return;
  marks_ = std::move(places);
  update();
}

void MarkedSlider::paintEvent(QPaintEvent* event) {
  QSlider::paintEvent(event);
  if (marks_.empty()) return;
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect groove =
      style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
  constexpr qreal kHeight = 4;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  for (const double place : marks_) {
    // The middle of the handle runs from half its length to half its length before the end.
    const qreal x = std::floor(groove.left() + handle / 2.0 + place * (groove.width() - handle));
    painter.drawLine(QPointF(x + 0.5, 0), QPointF(x + 0.5, kHeight));
    painter.drawLine(QPointF(x + 0.5, height() - kHeight), QPointF(x + 0.5, height()));
  }
}

}  // namespace rotorbench
