#include "sim/experiment/pid_pilot.h"

#include <algorithm>
#include <numbers>

#include "sim/analysis/step_response.h"
#include "sim/experiment/flight_simulation.h"

namespace rotorbench {

namespace {

InputSignal signalOf(const PidControl& control) {
  std::vector<InputSignal::Sample> samples;
  samples.reserve(control.setPoints.size());
  for (const auto& row : control.setPoints) {
    samples.push_back({row.time, {row.height, row.roll, row.pitch, row.yaw}});
  }
  return {std::move(samples), control.interpolation};
}

/// One controlled quantity: its channel and where its set-point stands in a row.
struct Axis {
  const char* name;
  const char* channel;
  const char* unit;
  double SetPointRow::*setPoint;
};
constexpr Axis kAxes[] = {{"altitude", "position.z", "m", &SetPointRow::height},
                          {"roll", "attitude.roll", "rad", &SetPointRow::roll},
                          {"pitch", "attitude.pitch", "rad", &SetPointRow::pitch},
                          {"yaw", "attitude.yaw", "rad", &SetPointRow::yaw}};

}  // namespace

PidPilot::PidPilot(const PidControl& control, const ControlModel<kRotors>& planned, double tick)
    : signal_(signalOf(control)),
      rows_(control.setPoints),
      controller_(control.controller, planned, tick) {}

std::vector<HeldQuantity> PidPilot::held() {
  // Far outside what a step's overshoot or a gust does to a vehicle that flies.
  constexpr double kHeight = 1;                    // m
  constexpr double kAngle = std::numbers::pi / 6;  // rad
  return {{"height", kHeight}, {"roll", kAngle}, {"pitch", kAngle}, {"yaw", kAngle, true}};
}

std::vector<Channel> PidPilot::channels() const {
  std::vector<Channel> all{{"setpoint.z", "m", "Height wanted"},
                           {"setpoint.roll", "rad", "Roll wanted"},
                           {"setpoint.pitch", "rad", "Pitch wanted"},
                           {"setpoint.yaw", "rad", "Yaw wanted"}};
  controller_.visitOutputs(
      [&](int rotor, const char* name, const char* unit, const char* description, double) {
        all.push_back({channelName(rotor, name), unit, description});
      });
  return all;
}

void PidPilot::figures(const Recording& recording, std::vector<Metric>& metrics) const {
  if (recording.rows() == 0) return;
  for (const Axis& axis : kAxes) {
    const auto channel = recording.find(axis.channel);
    if (!channel) continue;
    std::vector<SetPointChange> changes;
    for (const SetPointRow& row : rows_) changes.push_back({row.time, row.*axis.setPoint});
    const StepFigures worst = worstFigures(recording, *channel, changes);
    const std::string name = axis.name;
    metrics.push_back(
        {name + "_rest_error", axis.unit,
         "Largest distance from the set-point in the last tenth of any part of the timeline",
         worst.restError});
    metrics.push_back({name + "_overshoot", "1",
                       "Largest overshoot of a step, as a fraction of the step", worst.overshoot});
    metrics.push_back({name + "_settling_time", "s", "Longest time to stay within 2 % of a step",
                       worst.settlingTime});
  }
}

}  // namespace rotorbench
