#include "ui/shell/screen_fit.h"

#include <QApplication>
#include <QEvent>
#include <QScreen>
#include <QWidget>

namespace rotorbench {

namespace {

/// Not known before a window is on the screen; desktops take about this.
constexpr QSize kFrame{8, 36};

bool belongsTo(const QWidget& window, const QWidget& widget) {
  const QWidget* owner = widget.parentWidget();
  while (owner != nullptr && owner != &window) owner = owner->parentWidget();
  return owner != nullptr;
}

/// Menus and hints place themselves.
bool isDialogLike(const QWidget& widget) {
  const Qt::WindowType type = widget.windowType();
  return type == Qt::Dialog || type == Qt::Sheet || type == Qt::Window;
}

}  // namespace

QSize fittedSize(QSize wanted, QSize available) {
  return wanted.boundedTo(available - kFrame);
}

ScreenFit::ScreenFit(QWidget* window) : QObject(window), window_(window) {
  qApp->installEventFilter(this);
}

bool ScreenFit::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Show || event->spontaneous()) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr || !isDialogLike(*widget) || !belongsTo(*window_, *widget)) return false;
  const QSize fitted = fittedSize(widget->size(), widget->screen()->availableSize());
  if (fitted != widget->size()) widget->resize(fitted);
  return false;
}

}  // namespace rotorbench
