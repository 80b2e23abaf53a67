#include "sim/document/default_charts.h"

#include "sim/document/kinds.h"

#include "sim/document/experiment.h"

namespace rotorbench {

namespace {

ChartSpec overTime(const char* title, const char* channels) {
  ChartSpec spec;
  spec.title = title;
  spec.channels = channels;
  return spec;
}

ChartSpec over(const char* x, const char* title, const char* channels) {
  ChartSpec spec = overTime(title, channels);
  spec.kind = ChartKind::XY;
  spec.x = x;
  return spec;
}

struct ChartsOf {
  std::vector<ChartSpec> operator()(const Flight& /*setup*/) const {
    return {overTime("Position", "position.*, setpoint.z"),
            overTime("Attitude",
                     "attitude.roll, attitude.pitch, attitude.yaw, setpoint.roll, setpoint.pitch, "
                     "setpoint.yaw"),
            overTime("Thrust", "rotor*.thrust"), overTime("Rotor speed", "rotor*.speed")};
  }
  std::vector<ChartSpec> operator()(const MotorBench& /*setup*/) const {
    return {overTime("Speed", "motor.speed"),
            overTime("Currents", "motor.current, supply.current"),
            overTime("Voltages", "supply.voltage, motor.voltage"),
            overTime("Powers", "power.electrical, power.shaft"),
            over("over_speed.speed", "Efficiency over speed", "over_speed.efficiency"),
            over("over_throttle.throttle", "Thrust over throttle", "over_throttle.thrust")};
  }
  std::vector<ChartSpec> operator()(const PropellerBench& /*setup*/) const {
    return {overTime("Thrust and torque over time", "thrust, torque"),
            over("over_speed.speed", "Thrust and torque over speed",
                 "over_speed.thrust, over_speed.torque"),
            over("over_advance.j", "CT, CP and efficiency over J",
                 "over_advance.ct, over_advance.cp, over_advance.efficiency"),
            over("edgewise.ratio", "Edgewise stream", "edgewise.thrust, edgewise.drag")};
  }
  std::vector<ChartSpec> operator()(const ThrustStand& /*setup*/) const {
    return {overTime("Thrust", "thrust"),
            overTime("Voltage and currents", "supply.voltage, supply.current, motor.current"),
            overTime("Powers", "power.electrical, power.shaft"),
            over("*.throttle", "Thrust over throttle", "over_throttle.thrust, reached.thrust")};
  }
  std::vector<ChartSpec> operator()(const MotorSpeedRun& /*setup*/) const {
    return {overTime("Angular speed", "motor.speed, setpoint.speed"),
            overTime("Current", "motor.current"), overTime("Control signal", "controller.voltage"),
            overTime("Powers", "power.electrical, power.shaft")};
  }
  std::vector<ChartSpec> operator()(const SolverComparison& /*setup*/) const {
    ChartSpec error = overTime("Error against time", "error_norm");
    error.logY = true;
    ChartSpec work = over("*.evaluations", "Work-precision", "*.max_error_norm");
    work.logX = work.logY = work.markers = true;
    return {error, over("position.y", "Path in the y-z plane", "position.z"), work,
            overTime("Angular velocity", "angular_velocity")};
  }
  std::vector<ChartSpec> operator()(const BirotorMotion& /*setup*/) const {
    return {overTime("Angular velocity", "angular_velocity"), overTime("Energy", "energy"),
            overTime("Thrust", "rotor*.thrust"),
            over("position.y", "Path in the y-z plane", "position.z")};
  }
};

}  // namespace

std::vector<ChartSpec> defaultCharts(const Experiment& experiment) {
  return visitAlternative(ChartsOf{}, experiment.setup);
}

std::vector<ChartSpec> chartsOf(const Experiment& experiment) {
  return experiment.outputs.charts.empty() ? defaultCharts(experiment) : experiment.outputs.charts;
}

}  // namespace rotorbench
