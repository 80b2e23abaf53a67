#include "sim/run/timeline.h"

#include <algorithm>

#include "sim/document/controlled_inputs.h"

namespace rotorbench {

namespace {

/// One set-point: its channel and where it stands in a row.
struct Wanted {
  const char* channel;
  const char* unit;
  const char* description;
  double SetPointRow::*value;
};
constexpr Wanted kWanted[] = {
    {"setpoint.z", "m", "Height wanted", &SetPointRow::height},
    {"setpoint.roll", "rad", "Roll wanted", &SetPointRow::roll},
    {"setpoint.pitch", "rad", "Pitch wanted", &SetPointRow::pitch},
    {"setpoint.yaw", "rad", "Yaw wanted", &SetPointRow::yaw},
};

InputSignal<Eigen::Vector4d> signalOf(const std::vector<SetPointRow>& rows,
                                      Interpolation interpolation) {
  std::vector<InputSignal<Eigen::Vector4d>::Sample> samples;
  samples.reserve(rows.size());
  for (const auto& row : rows)
    samples.push_back({row.time, {row.height, row.roll, row.pitch, row.yaw}});
  return {std::move(samples), interpolation};
}

}  // namespace

Timeline::Timeline(const ControlledInputs& inputs) : Task("timeline", {}) {
  set(inputs);
  for (const SetPointRow& row : inputs.setPoints) asked_.push_back(held(row));
}

void Timeline::set(const ControlledInputs& inputs) {
  signal_ = signalOf(inputs.setPoints, inputs.interpolation);
  hand_ = inputs.byHand;
  byHand_ = hand_.heightByHand || hand_.rollByHand || hand_.pitchByHand || hand_.yawByHand;
}

SetPointRow Timeline::held(SetPointRow row) const {
  if (hand_.heightByHand) row.height = hand_.height;
  if (hand_.rollByHand) row.roll = hand_.roll;
  if (hand_.pitchByHand) row.pitch = hand_.pitch;
  if (hand_.yawByHand) row.yaw = hand_.yaw;
  return row;
}

void Timeline::take(const ControlledInputs& inputs, double time) {
  set(inputs);
  std::erase_if(asked_, [time](const SetPointRow& row) { return row.time >= time; });
  const Eigen::Vector4d now = wantedAt(time);
  asked_.push_back({time, now[0], now[1], now[2], now[3]});
  for (const SetPointRow& row : inputs.setPoints)
    if (row.time > time) asked_.push_back(held(row));
}

std::vector<Channel> Timeline::channels() const {
  std::vector<Channel> all;
  for (const Wanted& w : kWanted) all.push_back({w.channel, w.unit, w.description});
  return all;
}

Eigen::Vector4d Timeline::wantedAt(double time) {
  const Eigen::Vector4d laid = signal_.at(time);
  if (!byHand_) return laid;
  const SetPointRow row = held({time, laid[0], laid[1], laid[2], laid[3]});
  return {row.height, row.roll, row.pitch, row.yaw};
}

void Timeline::act(const ClockTick& tick, Board& board, double* row) {
  const Eigen::Vector4d wanted = wantedAt(tick.time);
  board.setPoint = {wanted[0], wanted[1], wanted[2], wanted[3]};
  Eigen::Map<Eigen::Vector4d>{row} = wanted;
}

std::vector<SetPointChange> changesOf(const std::vector<SetPointRow>& rows,
                                      const std::string& channel) {
  std::vector<SetPointChange> changes;
  const auto wanted = std::ranges::find(kWanted, channel, &Wanted::channel);
  if (wanted == std::end(kWanted)) return changes;
  for (const SetPointRow& row : rows) changes.push_back({row.time, row.*(wanted->value)});
  return changes;
}

}  // namespace rotorbench
