// Windows no larger than the screen they come up on: laptops are 1366 x 768 and less, and a scale
// factor makes any screen smaller. Sizes in device-independent pixels.
#pragma once

#include <QObject>
#include <QSize>

class QWidget;

namespace rotorbench {

/// `wanted`, or what a screen with this room has left beside the frame and title of a window.
QSize fittedSize(QSize wanted, QSize available);

/// Watches all dialogs and other windows that belong to `window` and fits each when it comes up.
class ScreenFit : public QObject {
 public:
  explicit ScreenFit(QWidget* window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* window_;
};

}  // namespace rotorbench
