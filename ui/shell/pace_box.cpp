#include "ui/shell/pace_box.h"

#include <QLocale>
#include <QSettings>
#include <QWheelEvent>

namespace rotorbench {

namespace {
constexpr auto kPaceKey = "run/pace";
}

PaceBox::PaceBox(QWidget* parent) : QComboBox(parent) {
  setObjectName("paceBox");
  setAccessibleName(tr("Speed of the run"));
  setToolTip(tr("Speed of the run"));
  setFocusPolicy(Qt::StrongFocus);
  for (const double factor : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0}) {
    addItem(factor == 1.0 ? tr("Real time") : tr("%1 ×").arg(QLocale().toString(factor)), factor);
  }
  addItem(tr("As fast as possible"), 0.0);
  setPace({QSettings().value(kPaceKey, 1.0).toDouble()});
  connect(this, &QComboBox::currentIndexChanged, this, [this] {
    QSettings().setValue(kPaceKey, currentData());
    emit paceChanged(pace());
  });
}

Pace PaceBox::pace() const {
  return {currentData().toDouble()};
}

void PaceBox::setPace(Pace pace) {
  const int index = findData(pace.unlimited() ? 0.0 : pace.factor);
  setCurrentIndex(index >= 0 ? index : findData(1.0));
}

// A wheel that only passes over the tool bar must not change the speed.
void PaceBox::wheelEvent(QWheelEvent* event) {
  hasFocus() ? QComboBox::wheelEvent(event) : event->ignore();
}

}  // namespace rotorbench
