#include "ui/propeller/blade_curves.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"

namespace rotorbench {

namespace {

constexpr double kReach = 12;                           // pixels within which a handle is meant
constexpr double kChordStep = 0.002, kTwistStep = 0.1;  // c/R and degrees, by one key press
constexpr int kTicks = 6;

CurveStyle styleOf(BladeCurves::Quantity quantity) {
  // Blue and vermillion of Okabe and Ito.
  return quantity == BladeCurves::Quantity::Chord ? CurveStyle{QColor(0, 114, 178), 0, true}
                                                  : CurveStyle{QColor(213, 94, 0), 1, true};
}

}  // namespace

BladeCurves::BladeCurves(QWidget* parent) : QWidget(parent) {
  setObjectName("bladeCurves");
  setAccessibleName(tr("Chord and twist over the radius"));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setToolTip(tr("Drag a point up or down. Double click adds a station, Delete removes one."));
}

double BladeCurves::valueOf(const BladeStation& station, Quantity quantity) const {
  return quantity == Quantity::Chord ? station.chord : station.twist / kDegree;
}

void BladeCurves::setStations(std::vector<BladeStation> stations) {
  stations_ = std::move(stations);
  station_ = std::clamp(station_, 0, std::max(0, static_cast<int>(stations_.size()) - 1));
  layOut();
  update();
}

void BladeCurves::layOut() {
  // While a point is dragged the axes hold still, or it would run away from the pointer.
  if (dragging_) return;
  Span chord{0, 0.1}, twist{0, 10};
  for (const BladeStation& s : stations_) {
    chord.high = std::max(chord.high, s.chord);
    twist.low = std::min(twist.low, s.twist / kDegree);
    twist.high = std::max(twist.high, s.twist / kDegree);
  }
  const auto axis = [&](const std::string& unit, const QString& title, Span span) {
    FrameAxis a{unit, title, {niceSpan(span, false, kTicks), false}, {}};
    a.ticks = niceTicks(a.scale, kTicks, locale());
    return a;
  };
  frame_ = {};
  frame_.x = axis("1", tr("radius r/R"), {0, 1});
  frame_.y = {axis("1", tr("chord c/R"), chord), axis("deg", tr("twist [°]"), twist)};
  layout_ = layoutPlot(frame_, QRectF(rect()).adjusted(2, 12 + fontMetrics().height(), -2, -2),
                       font(), labelWidths_);
}

QPointF BladeCurves::handle(int station, Quantity quantity) const {
  const BladeStation& s = stations_[static_cast<std::size_t>(station)];
  const AxisScale& y = frame_.y[quantity == Quantity::Chord ? 0 : 1].scale;
  return {layout_.plot.left() + frame_.x.scale.toUnit(s.radius) * layout_.plot.width(),
          layout_.plot.bottom() - y.toUnit(valueOf(s, quantity)) * layout_.plot.height()};
}

void BladeCurves::paintCurve(QPainter& painter, Quantity quantity, const ChartTheme& theme) const {
  const CurveStyle style = styleOf(quantity);
  QPolygonF line;
  for (int i = 0; i < static_cast<int>(stations_.size()); ++i) line << handle(i, quantity);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(curvePen(style, theme, 1.8));
  painter.drawPolyline(line);
  const QColor color = theme.readable(style.color);
  for (int i = 0; i < line.size(); ++i) {
    const bool chosen = i == station_ && quantity == quantity_;
    painter.setPen(QPen(color, chosen ? 2.4 : 1.2));
    painter.setBrush(chosen && hasFocus() ? color : theme.ground);
    painter.drawEllipse(line[i], chosen ? 5.5 : 3.5, chosen ? 5.5 : 3.5);
  }
}

void BladeCurves::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const ChartTheme theme = ChartTheme::of(palette());
  paintGround(painter, frame_, layout_, theme);
  paintAxes(painter, frame_, layout_, theme, font());
  if (stations_.empty()) return;
  paintCurve(painter, Quantity::Chord, theme);
  paintCurve(painter, Quantity::Twist, theme);
  const BladeStation& s = stations_[static_cast<std::size_t>(station_)];
  painter.setPen(theme.dimText);
  painter.drawText(
      QRectF(layout_.plot.left(), 4, width() - layout_.plot.left(), layout_.plot.top() - 8),
      Qt::AlignVCenter | Qt::AlignLeft,
      tr("r/R %1:  chord %2,  twist %3°")
          .arg(locale().toString(s.radius, 'g', 4), locale().toString(s.chord, 'g', 4),
               locale().toString(s.twist / kDegree, 'f', 2)));
}

void BladeCurves::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layOut();
}

bool BladeCurves::pick(QPointF place) {
  double nearest = kReach;
  bool found = false;
  for (int i = 0; i < static_cast<int>(stations_.size()); ++i) {
    for (const Quantity quantity : {Quantity::Chord, Quantity::Twist}) {
      const QPointF d = handle(i, quantity) - place;
      const double distance = std::hypot(d.x(), d.y());
      if (distance >= nearest) continue;
      nearest = distance;
      found = true;
      station_ = i;
      quantity_ = quantity;
    }
  }
  return found;
}

void BladeCurves::choose(int station, Quantity quantity) {
  station_ = std::clamp(station, 0, std::max(0, static_cast<int>(stations_.size()) - 1));
  quantity_ = quantity;
  update();
}

/// Asks for the chosen station's quantity to become `value`, in the units of the axis.
void BladeCurves::offer(double value) {
  if (!std::isfinite(value)) return;
  if (quantity_ == Quantity::Chord) {
    emit chordChosen(station_, std::max(0.0, value));
  } else {
    emit twistChosen(station_, value * kDegree);
  }
}

void BladeCurves::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) dragging_ = pick(event->position());
  update();
}

void BladeCurves::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) return;
  const double unit = (layout_.plot.bottom() - event->position().y()) / layout_.plot.height();
  const AxisScale& y = frame_.y[quantity_ == Quantity::Chord ? 0 : 1].scale;
  // The axis resolves no more than a pixel; digits beyond it would be noise in the table.
  const double grain = quantity_ == Quantity::Chord ? 1e-4 : 0.01;
  offer(std::round(y.fromUnit(std::clamp(unit, 0.0, 1.0)) / grain) * grain);
}

void BladeCurves::mouseReleaseEvent(QMouseEvent* /*event*/) {
  dragging_ = false;
  layOut();
  update();
}

void BladeCurves::mouseDoubleClickEvent(QMouseEvent* event) {
  if (pick(event->position()) || !layout_.plot.contains(event->position())) return;
  emit insertAsked(frame_.x.scale.fromUnit((event->position().x() - layout_.plot.left()) /
                                           layout_.plot.width()));
}

void BladeCurves::keyPressEvent(QKeyEvent* event) {
  if (stations_.empty()) return QWidget::keyPressEvent(event);
  const BladeStation& s = stations_[static_cast<std::size_t>(station_)];
  const double step = (quantity_ == Quantity::Chord ? kChordStep : kTwistStep) *
                      (event->modifiers() & Qt::ShiftModifier ? 10 : 1);
  const bool last = station_ + 1 == static_cast<int>(stations_.size());
  switch (event->key()) {
    case Qt::Key_Left:
      return choose(station_ - 1, quantity_);
    case Qt::Key_Right:
      return choose(station_ + 1, quantity_);
    case Qt::Key_Space:
      return choose(station_, quantity_ == Quantity::Chord ? Quantity::Twist : Quantity::Chord);
    case Qt::Key_Up:
      return offer(valueOf(s, quantity_) + step);
    case Qt::Key_Down:
      return offer(valueOf(s, quantity_) - step);
    case Qt::Key_Insert:
      if (!last)
        emit insertAsked(0.5 *
                         (s.radius + stations_[static_cast<std::size_t>(station_) + 1].radius));
      return;
    case Qt::Key_Delete:
      emit removeAsked(station_);
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace rotorbench
