// Plays a recording: play and pause, speed, scrubbing, loop, and following a run that is still
// going on. Knows only times in s; what is shown at a time is up to the listener of timeChanged().
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace rotorbench {

class MarkedSlider;

class PlaybackBar : public QWidget {
  Q_OBJECT
 public:
  explicit PlaybackBar(QWidget* parent = nullptr);

  /// The times that can be shown, s. Following, the time moves to `end`; else it stays where it
  /// was, within the range. `live`: the range still grows.
  void setRange(double start, double end, bool live);
  /// Clamped to the range; timeChanged() tells if that is another time. Not following any more.
  void setTime(double time);
  void setPlaying(bool playing);
  void setFollowing(bool following);
  void setLooping(bool looping);
  /// Times, s, that get a tick on the slider.
  void setMarks(std::vector<double> times);
  /// Times real time; the nearest of the speeds offered is taken.
  void setSpeed(double speed);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] double start() const { return start_; }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] bool isPlaying() const { return playTimer_.isActive(); }
  [[nodiscard]] bool isFollowing() const;
  [[nodiscard]] bool isLooping() const;
  [[nodiscard]] double speed() const;

 signals:
  void timeChanged(double time);
  void playingChanged(bool playing);
  void followingChanged(bool following);

 private:
  void build();
  QToolButton* makeButton(const char* name, const QString& text, bool checkable);
  void moveTo(double time);
  void advance();
  void sliderMoved(int position);
  void updateWidgets();
  void placeMarks();
  [[nodiscard]] int toSlider(double time) const;

  double start_ = 0, end_ = 0, time_ = 0;
  bool live_ = false;
  QTimer playTimer_;
  QElapsedTimer sinceStep_;
  QToolButton* play_ = nullptr;
  QToolButton* loop_ = nullptr;
  QToolButton* follow_ = nullptr;
  QComboBox* speed_ = nullptr;
  MarkedSlider* slider_ = nullptr;
  std::vector<double> marks_;
  QLabel* label_ = nullptr;
};

}  // namespace rotorbench
