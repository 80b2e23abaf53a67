#include "ui/scene/playback_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/scene/marked_slider.h"

namespace rotorbench {
namespace {

constexpr int kStepMs = 33;
constexpr int kSliderSteps = 10000;
constexpr std::array<double, 8> kSpeeds{0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0};

QIcon icon(const QWidget& widget, const char* name, QStyle::StandardPixmap fallback) {
  return QIcon::fromTheme(QLatin1String(name), widget.style()->standardIcon(fallback));
}

}  // namespace

PlaybackBar::PlaybackBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("playbackBar"));
  setAccessibleName(tr("Playback"));
  playTimer_.setInterval(kStepMs);
  connect(&playTimer_, &QTimer::timeout, this, &PlaybackBar::advance);
  build();
  updateWidgets();
}

QToolButton* PlaybackBar::makeButton(const char* name, const QString& text, bool checkable) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setAccessibleName(text);
  button->setToolTip(text);
  button->setCheckable(checkable);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void PlaybackBar::build() {
  play_ = makeButton("playButton", tr("Play"), false);
  connect(play_, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });

  slider_ = new MarkedSlider(this);
  slider_->setObjectName(QStringLiteral("timeSlider"));
  slider_->setAccessibleName(tr("Time"));
  slider_->setToolTip(tr("Time shown. Arrow keys step, Page Up and Page Down leap."));
  slider_->setRange(0, kSliderSteps);
  slider_->setSingleStep(kSliderSteps / 200);
  slider_->setPageStep(kSliderSteps / 20);
  slider_->setMinimumWidth(60);
  connect(slider_, &MarkedSlider::valueChanged, this, &PlaybackBar::sliderMoved);

  label_ = new QLabel(this);
  label_->setObjectName(QStringLiteral("timeLabel"));
  label_->setAccessibleName(tr("Time shown and length of the run"));
  label_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);

  speed_ = new QComboBox(this);
  speed_->setObjectName(QStringLiteral("speedBox"));
  speed_->setAccessibleName(tr("Playback speed"));
  speed_->setToolTip(tr("Playback speed; 1 is real time."));
  for (const double s : kSpeeds) speed_->addItem(QLocale().toString(s) + QChar(0x00D7), s);
  setSpeed(1.0);

  loop_ = makeButton("loopButton", tr("Play again from the start at the end"), true);
  loop_->setIcon(icon(*this, "media-playlist-repeat", QStyle::SP_BrowserReload));
  follow_ = makeButton("followButton", tr("Follow the run as it is computed"), true);
  follow_->setIcon(icon(*this, "media-skip-forward", QStyle::SP_MediaSkipForward));
  connect(follow_, &QToolButton::toggled, this, [this](bool on) {
    if (on) {
      setPlaying(false);
      moveTo(end_);
    }
    emit followingChanged(on);
  });

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->setSpacing(4);
  row->addWidget(play_);
  row->addWidget(slider_, 1);
  row->addWidget(label_);
  row->addWidget(speed_);
  row->addWidget(loop_);
  row->addWidget(follow_);
}

void PlaybackBar::setRange(double start, double end, bool live) {
  start_ = start;
  const bool longer = end_ != std::max(start, end);
  end_ = std::max(start, end);
  live_ = live;
  if (longer) placeMarks();
  moveTo(isFollowing() ? end_ : time_);
  updateWidgets();
}

void PlaybackBar::setTime(double time) {
  if (!std::isfinite(time)) return;
  // The end itself while following is an echo of our own signal, not a wish to look elsewhere.
  if (isFollowing() && time != end_) setFollowing(false);
  moveTo(time);
}

void PlaybackBar::moveTo(double time) {
  const double bounded = std::clamp(time, start_, end_);
  const bool changed = bounded != time_;
  time_ = bounded;
  updateWidgets();
  if (changed) emit timeChanged(time_);
}

void PlaybackBar::setPlaying(bool playing) {
  if (playing == isPlaying()) return;
  if (playing) {
    if (end_ <= start_) return;
    setFollowing(false);
    if (time_ >= end_ && !live_) moveTo(start_);
    sinceStep_.start();
    playTimer_.start();
  } else {
    playTimer_.stop();
  }
  updateWidgets();
  emit playingChanged(playing);
}

void PlaybackBar::setFollowing(bool following) {
  follow_->setChecked(following);
}

void PlaybackBar::setLooping(bool looping) {
  loop_->setChecked(looping);
}

void PlaybackBar::setSpeed(double speed) {
  const auto nearest = std::min_element(kSpeeds.begin(), kSpeeds.end(), [&](double a, double b) {
    return std::abs(a - speed) < std::abs(b - speed);
  });
  speed_->setCurrentIndex(static_cast<int>(nearest - kSpeeds.begin()));
}

void PlaybackBar::setMarks(std::vector<double> times) {
  marks_ = std::move(times);
  placeMarks();
}

void PlaybackBar::placeMarks() {
  std::vector<double> places;
  for (const double time : marks_)
    if (end_ > start_ && time >= start_ && time <= end_)
      places.push_back((time - start_) / (end_ - start_));
  slider_->setMarks(std::move(places));
}

bool PlaybackBar::isFollowing() const {
  return follow_->isChecked();
}

bool PlaybackBar::isLooping() const {
  return loop_->isChecked();
}

double PlaybackBar::speed() const {
  return speed_->currentData().toDouble();
}

void PlaybackBar::advance() {
  const double elapsed = 1e-3 * static_cast<double>(sinceStep_.restart());
  const double next = time_ + elapsed * speed();
  if (next < end_) {
    moveTo(next);
  } else if (isLooping()) {
    moveTo(start_);
  } else {
    moveTo(end_);
    // A run that is still going on has more to come.
    if (!live_) setPlaying(false);
  }
}

void PlaybackBar::sliderMoved(int position) {
  setFollowing(false);
  moveTo(start_ + (end_ - start_) * position / kSliderSteps);
}

int PlaybackBar::toSlider(double time) const {
  if (end_ <= start_) return 0;
  return static_cast<int>(std::lround(kSliderSteps * (time - start_) / (end_ - start_)));
}

void PlaybackBar::updateWidgets() {
  const QSignalBlocker quiet(slider_);
  // While it is held, the handle belongs to the hand.
  if (!slider_->isSliderDown()) slider_->setValue(toSlider(time_));
  const bool any = end_ > start_;
  slider_->setEnabled(any);
  play_->setEnabled(any);
  follow_->setEnabled(live_ || isFollowing());
  const QString text = isPlaying() ? tr("Pause") : tr("Play");
  if (play_->accessibleName() != text || play_->icon().isNull()) {
    play_->setIcon(isPlaying() ? icon(*this, "media-playback-pause", QStyle::SP_MediaPause)
                               : icon(*this, "media-playback-start", QStyle::SP_MediaPlay));
    play_->setAccessibleName(text);
    play_->setToolTip(text);
  }
  const QLocale locale;
  label_->setText(
      tr("%1 / %2 s").arg(locale.toString(time_, 'f', 2), locale.toString(end_, 'f', 2)));
  // The widest text keeps its room, so that nothing moves while the numbers run.
  const QString widest = tr("%1 / %1 s").arg(locale.toString(std::max(end_, 10.0), 'f', 2));
  label_->setMinimumWidth(label_->fontMetrics().horizontalAdvance(widest) + 4);
}

}  // namespace rotorbench
