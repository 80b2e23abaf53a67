#include "sim/run/timeline.h"

#include <algorithm>

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

Timeline::Timeline(const std::vector<SetPointRow>& rows, Interpolation interpolation)
    : Task("timeline", {}), signal_(signalOf(rows, interpolation)) {}

std::vector<Channel> Timeline::channels() const {
  std::vector<Channel> all;
  for (const Wanted& w : kWanted) all.push_back({w.channel, w.unit, w.description});
  return all;
}

void Timeline::act(const ClockTick& tick, Board& board, double* row) {
  const Eigen::Vector4d wanted = signal_.at(tick.time);
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
