// The 3D panel of the window: tool bar (cameras, what is shown), the view, the playback bar. Give
// it the drawing of the vehicle and a recording (which may still be growing); tie setTime() and
// timeChanged() to the chart cursor. GUI thread only.
#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "sim/scene/scene_model.h"

class QAction;
class QToolBar;

namespace rotorbench {

class HandBar;
class PlaybackBar;
class SceneView;
enum class CameraMode;
struct SceneOptions;

class ScenePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ScenePanel(QWidget* parent = nullptr);

  /// Empty: the experiment has no vehicle.
  void setModel(std::optional<SceneModel> model);
  /// Null: nothing has run. A recording that is not finished is followed as it grows.
  void setRecording(std::shared_ptr<const Recording> recording);
  /// Shows this instant, s; timeChanged() follows if it is another one.
  void setTime(double time);
  /// Keeps the newest sample in view while the run goes on.
  void followLive(bool follow);
  /// As a document begins: the first of the cameras where it is at first, played at real time.
  void resetView();
  /// The view as a picture of this size in pixels, with its writing; works hidden and without
  /// OpenGL.
  [[nodiscard]] QImage snapshot(const QSize& size);

  [[nodiscard]] double time() const;
  [[nodiscard]] SceneView& view() { return *view_; }
  [[nodiscard]] PlaybackBar& playback() { return *playback_; }
  [[nodiscard]] HandBar& hand() { return *hand_; }

 signals:
  /// The user scrubbed, playback went on, or a followed run grew.
  void timeChanged(double time);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void buildToolBar();
  QAction* addCamera(const char* name, const QString& text, const QString& key, CameraMode mode);
  void addSwitch(const char* name, const QString& text, bool SceneOptions::*option);
  void updateRange();
  void tellHand();

  SceneView* view_;
  PlaybackBar* playback_;
  HandBar* hand_;
  QToolBar* tools_;
  std::shared_ptr<const Recording> recording_;
  QTimer growth_;
};

}  // namespace rotorbench
