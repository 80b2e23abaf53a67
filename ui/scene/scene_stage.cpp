#include "ui/scene/scene_stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rotorbench {
namespace {

/// Rotors are shown turning this much slower than they do, so that the eye sees the direction.
constexpr double kTurnShare = 1.0 / 40.0;
/// Most a rotor turns between two pictures; more would look like standing still or turning back.
constexpr double kMostTurn = 0.7;
constexpr std::size_t kTrailPoints = 500;

bool isFinite(const ScenePose& pose) {
  return pose.position.allFinite() && pose.attitude.coeffs().allFinite() &&
         pose.attitude.norm() > 0.5 &&
         std::all_of(pose.hubs.begin(), pose.hubs.end(),
                     [](const Eigen::Vector3d& hub) { return hub.allFinite(); });
}

}  // namespace

void SceneStage::setModel(std::optional<SceneModel> model) {
  reader_.reset();
  const bool hadModel = model_.has_value();
  const SceneSize before = size_;
  model_ = std::move(model);
  size_ = model_ ? sceneSize(*model_) : SceneSize{};
  angles_.assign(model_ ? model_->rotors.size() : 0, 0.0);
  rebuildItems();
  bindReader();
  // An edit that leaves the vehicle much as it was leaves the camera where the user put it.
  const bool alike = hadModel && size_.planar == before.planar &&
                     std::abs(size_.radius - before.radius) < 0.2 * before.radius;
  if (!alike) resetCamera();
}

void SceneStage::setRecording(std::shared_ptr<const Recording> recording) {
  reader_.reset();
  recording_ = std::move(recording);
  std::fill(angles_.begin(), angles_.end(), 0.0);
  bindReader();
}

void SceneStage::bindReader() {
  pose_ = ScenePose{};
  if (model_ && recording_) reader_.emplace(*model_, *recording_);
  setTime(time_);
  camera_.centre(pose_.position);
}

bool SceneStage::flies() const {
  return reader_ && reader_->valid() && recording_->rows() > 0;
}

void SceneStage::setColors(const SceneColors& colors) {
  colors_ = colors;
  rebuildItems();
}

void SceneStage::rebuildItems() {
  items_ = model_ ? itemsOf(*model_, colors_, detail_) : std::vector<SceneItem>{};
}

void SceneStage::setTime(double time) {
  if (!std::isfinite(time)) return;
  if (flies()) {
    ScenePose pose = reader_->at(time);
    if (isFinite(pose)) pose_ = std::move(pose);
  }
  turnRotors(time_, time);
  time_ = time;
  camera_.follow(pose_);
}

void SceneStage::turnRotors(double from, double to) {
  for (std::size_t i = 0; i < angles_.size() && i < pose_.rotorSpeed.size(); ++i) {
    const double turn = pose_.rotorSpeed[i] * (to - from) * kTurnShare;
    if (!std::isfinite(turn)) continue;
    const double spin = model_->rotors[i].spin < 0 ? -1.0 : 1.0;
    angles_[i] = std::remainder(angles_[i] + spin * std::clamp(turn, -kMostTurn, kMostTurn),
                                2.0 * std::numbers::pi);
  }
}

void SceneStage::resetCamera() {
  camera_.reset(size_.radius, size_.planar);
}

std::vector<Placement> SceneStage::placements() const {
  if (!model_) return {};
  return placeItems(items_, *model_, pose_, angles_, options_);
}

Mesh SceneStage::shadow() const {
  return model_ ? shadowMesh(*model_, pose_, colors_) : Mesh{};
}

std::vector<Eigen::Vector3d> SceneStage::trail() const {
  if (!options_.trail || !flies()) return {};
  return reader_->trail(recording_->value(0, 0), time_, kTrailPoints);
}

}  // namespace rotorbench
