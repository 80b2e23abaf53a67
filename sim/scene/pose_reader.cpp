#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/scene/scene_model.h"

namespace rotorbench {
namespace {

/// Indices of all the named channels, or nothing if one of them is missing.
template <std::size_t N>
std::vector<std::size_t> findAll(const Recording& recording,
                                 const std::array<std::string, N>& names) {
  std::vector<std::size_t> indices;
  for (const std::string& name : names) {
    const std::optional<std::size_t> index = recording.find(name);
    if (!index) return {};
    indices.push_back(*index);
  }
  return indices;
}

/// `rotor1.<what>`, `rotor2.<what>`, … for every rotor, or nothing if one of them is missing.
std::vector<std::size_t> findPerRotor(const Recording& recording, std::size_t rotors,
                                      const char* what) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 1; i <= rotors; ++i) {
    const auto index = recording.find("rotor" + std::to_string(i) + "." + what);
    if (!index) return {};
    indices.push_back(*index);
  }
  return indices;
}

/// Row of the last sample not after t (0 before the start). Precondition: rows > 0.
std::size_t rowAt(const Recording& recording, double t) {
  const double after = std::nextafter(t, std::numeric_limits<double>::infinity());
  const std::size_t next = recording.lowerBound(after);
  return next > 0 ? next - 1 : 0;
}

Eigen::Vector3d readPosition(const Recording& recording, const std::vector<std::size_t>& position,
                             const std::vector<std::size_t>& hub, bool planar, std::size_t row) {
  const auto read = [&](std::size_t channel) { return recording.value(channel, row); };
  if (!hub.empty()) {
    return {0.0, 0.5 * (read(hub[0]) + read(hub[2])), 0.5 * (read(hub[1]) + read(hub[3]))};
  }
  if (planar) return {0.0, read(position[0]), read(position[1])};
  return {read(position[0]), read(position[1]), read(position[2])};
}

}  // namespace

PoseReader::PoseReader(const SceneModel& model, const Recording& recording)
    : recording_(&recording) {
  using Names2 = std::array<std::string, 2>;
  using Names3 = std::array<std::string, 3>;
  using Names4 = std::array<std::string, 4>;
  onStand_ = model.onStand;
  if (onStand_) {
    for (const char* name : {"motor.speed", "speed"}) {
      const auto channel = recording.find(name);
      if (channel && speed_.empty()) speed_ = {*channel};
    }
    if (const auto channel = recording.find("thrust")) thrust_ = {*channel};
    valid_ = !speed_.empty();
    return;
  }
  if (model.elasticArms) {
    hub_ = findAll(recording, Names4{"body1.y", "body1.z", "body2.y", "body2.z"});
    planar_ = true;
    valid_ = !hub_.empty() && model.rotors.size() == 2;
  } else {
    position_ = findAll(recording, Names3{"position.x", "position.y", "position.z"});
    attitude_ = findAll(recording, Names4{"attitude.w", "attitude.x", "attitude.y", "attitude.z"});
    valid_ = !position_.empty() && !attitude_.empty();
    if (!valid_) {
      planar_ = true;
      position_ = findAll(recording, Names2{"position.y", "position.z"});
      attitude_ = findAll(recording, std::array<std::string, 1>{"angle"});
      valid_ = !position_.empty() && !attitude_.empty();
    }
  }
  setPoint_ = findAll(recording, Names3{"setpoint.x", "setpoint.y", "setpoint.z"});
  if (setPoint_.empty()) setPoint_ = findAll(recording, std::array<std::string, 1>{"setpoint.z"});
  wind_ = findAll(recording, Names3{"wind.x", "wind.y", "wind.z"});
  speed_ = findPerRotor(recording, model.rotors.size(), "speed");
  thrust_ = findPerRotor(recording, model.rotors.size(), "thrust");
}

ScenePose PoseReader::at(double t) const {
  ScenePose pose;
  pose.time = t;
  if (!valid_ || recording_->rows() == 0) return pose;
  const std::size_t row = rowAt(*recording_, t);
  const auto read = [&](std::size_t channel) { return recording_->value(channel, row); };
  if (onStand_) {
    pose.rotorSpeed = {read(speed_.front())};
    if (!thrust_.empty()) pose.rotorThrust = {read(thrust_.front())};
    return pose;
  }
  pose.position = readPosition(*recording_, position_, hub_, planar_, row);
  if (!hub_.empty()) {
    // The line through the bodies is the vehicle: its angle about x, and half its length to each
    // side.
    const Eigen::Vector2d bar(read(hub_[2]) - read(hub_[0]), read(hub_[3]) - read(hub_[1]));
    pose.attitude = Eigen::AngleAxisd(std::atan2(bar.y(), bar.x()), Eigen::Vector3d::UnitX());
    const double half = 0.5 * bar.norm();
    pose.hubs = {Eigen::Vector3d(0, -half, 0), Eigen::Vector3d(0, half, 0)};
  } else if (planar_) {
    pose.attitude = Eigen::AngleAxisd(read(attitude_[0]), Eigen::Vector3d::UnitX());
  } else {
    pose.attitude = Eigen::Quaterniond(read(attitude_[0]), read(attitude_[1]), read(attitude_[2]),
                                       read(attitude_[3]));
    pose.attitude.normalize();
  }
  for (const std::size_t channel : speed_) pose.rotorSpeed.push_back(read(channel));
  for (const std::size_t channel : thrust_) pose.rotorThrust.push_back(read(channel));
  if (!wind_.empty()) pose.wind = Eigen::Vector3d(read(wind_[0]), read(wind_[1]), read(wind_[2]));
  if (setPoint_.size() == 3) {
    pose.setPoint = Eigen::Vector3d(read(setPoint_[0]), read(setPoint_[1]), read(setPoint_[2]));
  } else if (setPoint_.size() == 1) {
    pose.setPoint = Eigen::Vector3d(pose.position.x(), pose.position.y(), read(setPoint_[0]));
  }
  return pose;
}

std::vector<Eigen::Vector3d> PoseReader::trail(double t0, double t1, std::size_t count) const {
  std::vector<Eigen::Vector3d> points;
  if (!valid_ || onStand_ || count == 0 || recording_->rows() == 0 || t1 < t0) return points;
  const std::size_t first = recording_->lowerBound(t0);
  const std::size_t last = rowAt(*recording_, t1);
  if (first > last) return points;
  // A stride that is a power of two and counts from row 0 keeps the points where they are while the
  // trail grows; otherwise every frame would pick other rows and the curve would shimmer.
  std::size_t stride = 1;
  while ((last - first) / stride + 2 > std::max<std::size_t>(count, 2)) stride *= 2;
  const auto add = [&](std::size_t row) {
    const Eigen::Vector3d p = readPosition(*recording_, position_, hub_, planar_, row);
    if (p.allFinite()) points.push_back(p);
  };
  if (count > 1) {
    for (std::size_t row = (first + stride - 1) / stride * stride; row < last; row += stride) {
      add(row);
    }
  }
  add(last);
  return points;
}

}  // namespace rotorbench
