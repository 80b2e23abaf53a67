#include "ui/scene/hand_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QToolButton>

#include "sim/core/constants.h"

namespace rotorbench {

namespace {

std::size_t at(HandAxis axis) {
  return static_cast<std::size_t>(axis);
}

struct Tilt {
  int key;
  HandAxis axis;
  double sign;
};
// Roll moves the vehicle to the right, pitch forward.
constexpr Tilt kTilts[] = {{Qt::Key_Up, HandAxis::Pitch, 1},
                           {Qt::Key_Down, HandAxis::Pitch, -1},
                           {Qt::Key_Left, HandAxis::Roll, -1},
                           {Qt::Key_Right, HandAxis::Roll, 1}};

QToolButton* textButton(QWidget* parent, const char* name, const QString& text) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setAccessibleName(text);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

}  // namespace

HandBar::HandBar(QWidget* view, QWidget* parent)
    : QWidget(parent),
      view_(view),
      on_(textButton(this, "flyByHand", tr("Fly by hand"))),
      back_(textButton(this, "backToTimeline", tr("Give back"))),
      label_(new QLabel(this)) {
  setObjectName(QStringLiteral("handBar"));
  setAccessibleName(tr("Flying by hand"));
  on_->setCheckable(true);
  on_->setToolTip(
      tr("While a flight goes on, the keys of the 3D view take its set-points: arrows tilt as long "
         "as they are held, W and S (or Page Up and Page Down) move the height, A and D turn, Home "
         "gives all back to the timeline."));
  back_->setToolTip(tr("Give all set-points back to the timeline (Home)"));
  label_->setObjectName(QStringLiteral("handLabel"));
  label_->setMinimumWidth(40);
  label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 0, 4, 2);
  row->setSpacing(6);
  row->addWidget(on_);
  row->addWidget(label_, 1);
  row->addWidget(back_);
  connect(on_, &QToolButton::toggled, this, [this](bool on) {
    if (on) {
      view_->setFocus(Qt::OtherFocusReason);
    } else {
      giveAllBack();
    }
    showState();
  });
  connect(back_, &QToolButton::clicked, this, [this] {
    giveAllBack();
    if (isOn()) view_->setFocus(Qt::OtherFocusReason);
  });
  view_->installEventFilter(this);
  showState();
}

bool HandBar::isOn() const {
  return on_->isChecked();
}

void HandBar::setOn(bool on) {
  on_->setChecked(on);
}

std::optional<double> HandBar::held(HandAxis axis) const {
  return hand_[at(axis)];
}

void HandBar::setFlying(bool flying) {
  if (flying == flying_) return;
  flying_ = flying;
  // What was held belongs to the flight that has ended.
  hand_.fill(std::nullopt);
  showState();
}

bool HandBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched != view_ || !flying_ || !isOn()) return false;
  if (event->type() == QEvent::FocusOut) level();  // the key's release would not be seen
  const bool press = event->type() == QEvent::KeyPress;
  if (!press && event->type() != QEvent::KeyRelease) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if ((key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) != 0) return false;
  if (press) return this->press(key->key(), key->isAutoRepeat());
  return !key->isAutoRepeat() && release(key->key());
}

bool HandBar::press(int key, bool repeated) {
  for (const Tilt& tilt : kTilts) {
    if (tilt.key != key) continue;
    if (!repeated) take(tilt.axis, tilt.sign * kTilt);
    return true;
  }
  switch (key) {
    case Qt::Key_W:
    case Qt::Key_PageUp:
      move(HandAxis::Height, kClimb);
      return true;
    case Qt::Key_S:
    case Qt::Key_PageDown:
      move(HandAxis::Height, -kClimb);
      return true;
    case Qt::Key_A:
      move(HandAxis::Yaw, kTurn);
      return true;
    case Qt::Key_D:
      move(HandAxis::Yaw, -kTurn);
      return true;
    case Qt::Key_Home:
      giveAllBack();
      return true;
    default:
      return false;
  }
}

bool HandBar::release(int key) {
  for (const Tilt& tilt : kTilts) {
    if (tilt.key != key) continue;
    // The other way may be held already.
    if (hand_[at(tilt.axis)] == tilt.sign * kTilt) take(tilt.axis, 0);
    return true;
  }
  return false;
}

void HandBar::take(HandAxis axis, double value) {
  hand_[at(axis)] = value;
  emit taken(axis, value);
  showState();
}

void HandBar::move(HandAxis axis, double by) {
  take(axis, hand_[at(axis)].value_or(asked_[at(axis)]) + by);
}

void HandBar::level() {
  for (const HandAxis axis : {HandAxis::Roll, HandAxis::Pitch})
    if (hand_[at(axis)].value_or(0) != 0) take(axis, 0);
}

void HandBar::giveAllBack() {
  for (const HandAxis axis : {HandAxis::Height, HandAxis::Roll, HandAxis::Pitch, HandAxis::Yaw}) {
    if (!hand_[at(axis)]) continue;
    hand_[at(axis)].reset();
    emit givenBack(axis);
  }
  showState();
}

void HandBar::showState() {
  const QLocale locale;
  const auto degrees = [&](double angle) {
    return locale.toString(angle * 180 / kPi, 'f', 0) + QChar(0x00B0);
  };
  QStringList parts;
  if (const auto& height = hand_[at(HandAxis::Height)])
    parts << tr("z %1 m").arg(locale.toString(*height, 'f', 2));
  if (const auto& roll = hand_[at(HandAxis::Roll)]) parts << tr("roll %1").arg(degrees(*roll));
  if (const auto& pitch = hand_[at(HandAxis::Pitch)]) parts << tr("pitch %1").arg(degrees(*pitch));
  if (const auto& yaw = hand_[at(HandAxis::Yaw)]) parts << tr("yaw %1").arg(degrees(*yaw));
  back_->setEnabled(!parts.isEmpty());
  QString text;
  if (!parts.isEmpty()) {
    text = parts.join(QStringLiteral(", "));
  } else if (isOn()) {
    text = flying_ ? tr("Arrows tilt, W S climb and sink, A D turn, Home: back")
                   : tr("Keys act while a flight goes on.");
  }
  label_->setText(text);
  label_->setToolTip(parts.isEmpty() ? text : tr("In the hand: %1").arg(text));
}

}  // namespace rotorbench
