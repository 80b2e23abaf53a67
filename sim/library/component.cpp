#include "sim/library/component.h"

#include <algorithm>

#include "sim/core/schema_tree.h"
#include "sim/library/component_kind.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"
#include "sim/propulsion/rotor/blade.h"
#include "sim/propulsion/rotor/measured_propeller.h"
#include "sim/propulsion/rotor/polar_section.h"
#include "sim/propulsion/rotor/rotor.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

const std::vector<ComponentKind>& componentKinds() {
  static const std::vector<ComponentKind> kKinds{
      makeKind<MotorParameters>("motor", "Motor", "motors",
                                {"speedConstant", "resistance", "noLoadCurrent"}),
      makeKind<EscParameters>("esc", "Speed controller (ESC)", "escs",
                              {"maxCurrent", "resistance", "reverse"}),
      makeKind<BatteryParameters>("battery", "Battery", "batteries",
                                  {"series", "parallel", "capacity", "resistance"}),
      makeKind<PropellerGeometry>("propeller", "Propeller", "propellers",
                                  {"diameter", "pitch", "blades"}),
      makeKind<MeasuredPropeller>("measured-propeller", "Measured propeller", "measured-propellers",
                                  {"diameter"}),
      makeKind<PropellerCoefficients>("propeller-coefficients", "Propeller coefficients",
                                      "propeller-coefficients",
                                      {"diameter", "thrustCoefficient", "powerCoefficient"}),
      makeKind<RotorCoefficients>("rotor-coefficients", "Lumped rotor", "rotor-coefficients",
                                  {"diameter", "thrust", "torque"}),
      makeKind<PolarSection>("airfoil", "Airfoil with polars", "airfoils", {"name"}),
      makeKind<AnalyticSection>("analytic-airfoil", "Analytic airfoil", "analytic-airfoils",
                                {"constants.zeroLift", "constants.stallLift"}),
      makeKind<VehicleParameters>("airframe", "Airframe", "airframes",
                                  {"mass.mass", "mass.bodyMass", "layout.arm"}),
  };
  return kKinds;
}

const ComponentKind* kindOf(const schema::Type& type) {
  const auto& kinds = componentKinds();
  const auto found = std::ranges::find(kinds, &type, &ComponentKind::type);
  return found == kinds.end() ? nullptr : &*found;
}

const ComponentKind* kindOf(std::string_view key) {
  const auto& kinds = componentKinds();
  const auto found = std::ranges::find(kinds, key, &ComponentKind::key);
  return found == kinds.end() ? nullptr : &*found;
}

Component makeComponent(ComponentInfo info, schema::ConstRef value) {
  Component component{std::move(info), value.type, value.type->make()};
  schema::copy(value, {component.type, component.value.get()});
  return component;
}

void Describe<ComponentInfo>::fields(schema::Builder<ComponentInfo>& b) {
  b.title("component-info", "Component", "What a person reads about a component.");
  addInfoFields(b);
}

}  // namespace rotorbench
