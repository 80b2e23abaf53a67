// The part of PlotWidget that listens: wheel, mouse and keys.
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/charts/plot_widget.h"

namespace rotorbench {
namespace {

constexpr qreal kCursorReach = 4;
constexpr qreal kClickReach = 3;
constexpr qreal kThinBand = 8;
constexpr double kWheelStep = 0.8;  // width of the range after one notch
constexpr double kKeyPan = 0.1;

void chooseX(ChartView& view, const FrameAxis& axis, Span span) {
  if (isUsable(span, axis.scale.log)) view.x = span;
}

void chooseY(ChartView& view, const FrameAxis& axis, Span span) {
  if (isUsable(span, axis.scale.log)) view.y[axis.unit] = span;
}

}  // namespace

QPointF PlotWidget::toUnit(QPointF pixel) const {
  const QRectF& plot = layout_.plot;
  return {(pixel.x() - plot.left()) / plot.width(), (plot.bottom() - pixel.y()) / plot.height()};
}

std::optional<Cursor> PlotWidget::cursorNear(QPointF pixel) const {
  if (content_.kind != ChartKind::Time || !layout_.plot.contains(pixel)) return std::nullopt;
  for (const Cursor which : {Cursor::A, Cursor::B}) {
    const auto time = link_->cursor(which);
    if (!time) continue;
    const qreal x =
        layout_.plot.left() + content_.frame.x.scale.toUnit(*time) * layout_.plot.width();
    if (std::abs(x - pixel.x()) <= kCursorReach) return which;
  }
  return std::nullopt;
}

/// Over an axis that axis; inside, the time of a time chart (its values fit themselves) or all of
/// an xy chart.
void PlotWidget::zoomAt(QPointF pixel, double factor, bool onlyY) {
  const QPointF unit = toUnit(pixel);
  const int overY = layout_.yAxisAt(pixel);
  const bool inside = layout_.plot.contains(pixel);
  if (!inside && overY < 0 && !layout_.xStrip.contains(pixel)) return;
  ChartView view = content_.view;
  const auto& frame = content_.frame;
  if (overY < 0 && !(inside && onlyY)) {
    chooseX(view, frame.x, zoomed(frame.x.scale, std::clamp(unit.x(), 0.0, 1.0), factor));
  }
  const bool allY = inside && (onlyY || content_.kind == ChartKind::XY);
  for (std::size_t i = 0; i < frame.y.size(); ++i) {
    if (allY || overY == static_cast<int>(i))
      chooseY(view, frame.y[i], zoomed(frame.y[i].scale, unit.y(), factor));
  }
  emit viewChosen(view, true);
}

void PlotWidget::panBy(QPointF unitShift, const ChartView& from, const ChartFrame& frame) {
  ChartView view = from;
  chooseX(view, frame.x, panned(frame.x.scale, unitShift.x()));
  for (const auto& axis : frame.y) {
    const bool chosen = from.y.contains(axis.unit) || content_.kind == ChartKind::XY;
    if (chosen) chooseY(view, axis, panned(axis.scale, unitShift.y()));
  }
  emit viewChosen(view, true);
}

void PlotWidget::chooseBand() {
  const QRectF band = QRectF(press_, last_).normalized();
  const bool wide = band.width() >= kThinBand;
  const bool tall = band.height() >= kThinBand;
  if (!wide && !tall) return;
  const auto inside = [this](QPointF pixel) {
    const QPointF unit = toUnit(pixel);
    return QPointF(std::clamp(unit.x(), 0.0, 1.0), std::clamp(unit.y(), 0.0, 1.0));
  };
  const QPointF low = inside(band.bottomLeft());
  const QPointF high = inside(band.topRight());
  ChartView view = content_.view;
  const auto& frame = content_.frame;
  if (wide) chooseX(view, frame.x, part(frame.x.scale, low.x(), high.x()));
  for (const auto& axis : frame.y) {
    if (tall) chooseY(view, axis, part(axis.scale, low.y(), high.y()));
  }
  emit viewChosen(view, false);
}

void PlotWidget::placeCursor(Cursor which, QPointF pixel) {
  if (content_.kind != ChartKind::Time) return;
  link_->moveCursor(which,
                    content_.frame.x.scale.fromUnit(std::clamp(toUnit(pixel).x(), 0.0, 1.0)));
}

bool PlotWidget::moveCursorByKey(int direction, Cursor which) {
  const auto time = link_->cursor(which);
  if (!time || content_.kind != ChartKind::Time) return false;
  const double unit = content_.frame.x.scale.toUnit(*time) + direction / layout_.plot.width();
  link_->moveCursor(which, content_.frame.x.scale.fromUnit(std::clamp(unit, 0.0, 1.0)));
  return true;
}

void PlotWidget::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches == 0 || content_.frame.y.empty()) return event->ignore();
  zoomAt(event->position(), std::pow(kWheelStep, notches),
         event->modifiers() & Qt::ControlModifier);
  event->accept();
}

void PlotWidget::mousePressEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  press_ = last_ = at;
  moved_ = false;
  const bool pan = event->button() == Qt::MiddleButton ||
                   (event->button() == Qt::LeftButton && event->modifiers() & Qt::ShiftModifier);
  if (pan) {
    gesture_ = Gesture::Pan;
    contentAtPress_ = {content_.frame, content_.kind, content_.view, {}};
    contentAtPress_.frame.curves.clear();
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() == Qt::LeftButton && layout_.plot.contains(at)) {
    const auto near = cursorNear(at);
    gesture_ = !near ? Gesture::Band : *near == Cursor::A ? Gesture::CursorA : Gesture::CursorB;
  } else if (event->button() == Qt::RightButton) {
    emit rightClicked(event->globalPosition().toPoint());
  }
}

void PlotWidget::dragTo(QPointF pixel) {
  if (gesture_ == Gesture::Pan) {
    const QPointF by = toUnit(press_) - toUnit(pixel);
    panBy(by, contentAtPress_.view, contentAtPress_.frame);
  } else if (gesture_ == Gesture::Band) {
    update();
  } else {
    placeCursor(gesture_ == Gesture::CursorA ? Cursor::A : Cursor::B, pixel);
  }
}

void PlotWidget::mouseMoveEvent(QMouseEvent* event) {
  last_ = event->position();
  if (gesture_ == Gesture::None) {
    if (cursorNear(last_)) {
      setCursor(Qt::SplitHCursor);
    } else {
      unsetCursor();
    }
    return;
  }
  moved_ = moved_ || (last_ - press_).manhattanLength() > kClickReach;
  if (moved_) dragTo(last_);
}

void PlotWidget::mouseReleaseEvent(QMouseEvent* event) {
  last_ = event->position();
  const Gesture gesture = std::exchange(gesture_, Gesture::None);
  if (gesture == Gesture::Band && moved_) {
    chooseBand();
  } else if (gesture == Gesture::Band) {
    const Cursor which = event->modifiers() & Qt::ControlModifier ? Cursor::B : Cursor::A;
    cursorBeforeClick_ = link_->cursor(Cursor::A);
    placeCursor(which, last_);
  }
  unsetCursor();
  update();
}

/// The first click of the two has moved cursor A; that is taken back.
void PlotWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (layout_.plot.contains(event->position())) link_->moveCursor(Cursor::A, cursorBeforeClick_);
  emit fitAsked();
}

void PlotWidget::keyPressEvent(QKeyEvent* event) {
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  const Cursor which = shift ? Cursor::B : Cursor::A;
  const QPointF middle = layout_.plot.center();
  const auto pan = [this](double x, double y) { panBy({x, y}, content_.view, content_.frame); };
  switch (event->key()) {
    case Qt::Key_Plus:
      return zoomAt(middle, kWheelStep, false);
    case Qt::Key_Minus:
      return zoomAt(middle, 1 / kWheelStep, false);
    case Qt::Key_A:
      return placeCursor(Cursor::A, middle);
    case Qt::Key_B:
      return placeCursor(Cursor::B, middle);
    case Qt::Key_Up:
      return pan(0, kKeyPan);
    case Qt::Key_Down:
      return pan(0, -kKeyPan);
    case Qt::Key_Left:
      if (!moveCursorByKey(-1, which)) pan(-kKeyPan, 0);
      return;
    case Qt::Key_Right:
      if (!moveCursorByKey(1, which)) pan(kKeyPan, 0);
      return;
    case Qt::Key_Escape:
      if (!link_->cursor(Cursor::A) && !link_->cursor(Cursor::B)) break;
      link_->moveCursor(Cursor::B, std::nullopt);
      link_->moveCursor(Cursor::A, std::nullopt);
      return;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void PlotWidget::contextMenuEvent(QContextMenuEvent* event) {
  // A right click has its own signal.
  if (event->reason() != QContextMenuEvent::Mouse) emit menuAsked(event->globalPos());
  event->accept();
}

}  // namespace rotorbench
