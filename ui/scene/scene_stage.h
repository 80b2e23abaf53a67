// What stands on the stage at this instant: model, recording, time, camera and switches turned into
// placed meshes. No widget and no renderer; both views hold one and draw it. Positions in the
// inertial frame, m.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sim/scene/scene_model.h"
#include "ui/scene/scene_camera.h"
#include "ui/scene/scene_colors.h"
#include "ui/scene/scene_items.h"

namespace rotorbench {

class SceneStage {
 public:
  explicit SceneStage(MeshDetail detail) : detail_(detail) {}
  SceneStage(const SceneStage&) = delete;
  SceneStage& operator=(const SceneStage&) = delete;

  void setModel(std::optional<SceneModel> model);
  void setRecording(std::shared_ptr<const Recording> recording);
  void setColors(const SceneColors& colors);
  void setOptions(const SceneOptions& options) { options_ = options; }
  /// Moves everything to the time in s; also call it when the recording has grown. Samples that are
  /// not finite (a failed run) leave the vehicle where it was.
  void setTime(double time);
  void resetCamera();

  [[nodiscard]] SceneCamera& camera() { return camera_; }
  [[nodiscard]] const SceneCamera& camera() const { return camera_; }
  [[nodiscard]] const std::optional<SceneModel>& model() const { return model_; }
  [[nodiscard]] const std::shared_ptr<const Recording>& recording() const { return recording_; }
  /// True if the recording places this model.
  [[nodiscard]] bool flies() const;
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const ScenePose& pose() const { return pose_; }
  [[nodiscard]] const SceneOptions& options() const { return options_; }
  [[nodiscard]] const SceneColors& colors() const { return colors_; }
  [[nodiscard]] const SceneSize& size() const { return size_; }

  /// Changes only with the model and the colours; empty without a model.
  [[nodiscard]] const std::vector<SceneItem>& items() const { return items_; }
  [[nodiscard]] std::vector<Placement> placements() const;
  [[nodiscard]] Mesh shadow() const;
  /// The path flown so far, empty if switched off.
  [[nodiscard]] std::vector<Eigen::Vector3d> trail() const;
  [[nodiscard]] const std::vector<double>& rotorAngles() const { return angles_; }

 private:
  void rebuildItems();
  void bindReader();
  void turnRotors(double from, double to);

  MeshDetail detail_;
  std::optional<SceneModel> model_;
  std::shared_ptr<const Recording> recording_;
  std::optional<PoseReader> reader_;
  SceneColors colors_;
  SceneOptions options_;
  SceneCamera camera_;
  SceneSize size_;
  std::vector<SceneItem> items_;
  double time_ = 0;
  ScenePose pose_;
  std::vector<double> angles_;
};

}  // namespace rotorbench
