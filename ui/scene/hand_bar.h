// Flying by hand: a bar below the scene and the keys of the 3D view. While it is switched on and a
// flight goes on, keys take set-points from the timeline: arrows tilt as long as they are held, W
// and S move the height, A and D turn; Home gives all back.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "sim/document/changes.h"

class QLabel;
class QToolButton;

namespace rotorbench {

class HandBar : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kTilt = 0.17453292519943295;  ///< rad, 10 degrees, while a key is held
  static constexpr double kTurn = 0.26179938779914941;  ///< rad, 15 degrees a stroke
  static constexpr double kClimb = 0.25;                ///< m a stroke

  /// Reads the keys of `view`.
  explicit HandBar(QWidget* view, QWidget* parent = nullptr);

  /// A flight that takes set-points goes on; else keys do nothing here. All is given back with its
  /// end.
  void setFlying(bool flying);
  /// Set-points as they are, for those that are not in the hand: height, roll, pitch, yaw.
  void setAsked(const std::array<double, 4>& asked) { asked_ = asked; }

  [[nodiscard]] bool isOn() const;
  void setOn(bool on);
  /// What hands hold of an axis.
  [[nodiscard]] std::optional<double> held(HandAxis axis) const;

 signals:
  void taken(rotorbench::HandAxis axis, double value);
  void givenBack(rotorbench::HandAxis axis);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool press(int key, bool repeated);
  bool release(int key);
  void take(HandAxis axis, double value);
  void move(HandAxis axis, double by);
  void giveAllBack();
  void level();
  void showState();

  QWidget* view_;
  QToolButton* on_;
  QToolButton* back_;
  QLabel* label_;
  bool flying_ = false;
  std::array<double, 4> asked_{};
  std::array<std::optional<double>, 4> hand_;
};

}  // namespace rotorbench
