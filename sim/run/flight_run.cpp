#include <utility>

#include "sim/control/pid.h"
#include "sim/control/speed_controllers.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/flight.h"
#include "sim/run/builders.h"
#include "sim/run/controller_factory.h"
#include "sim/run/flight_assembly.h"
#include "sim/run/flight_simulation.h"
#include "sim/run/input_tasks.h"
#include "sim/run/load_inputs.h"
#include "sim/run/simulation.h"
#include "sim/run/timeline.h"
#include "sim/sensing/sensor_tasks.h"
#include "sim/sensing/true_state.h"

namespace rotorbench {

namespace {

/// The controller's or inputs' part of the build: every alternative of Flight::control has one.
struct PartsOf {
  const Flight& flight;
  const BuildContext& context;
  Place vehicle = context.place / "vehicle", control = context.place / "control";
  int rotors = rotorCount(flight.vehicle.layout);

  FlightParts operator()(const ControlledInputs& inputs) const {
    const auto factory = [&](const ControlModel& model) {
      return makeController(inputs.controller,
                            {model, flight.tick, control / "controller", vehicle});
    };
    return controlledFlight(flight, inputs, context, factory);
  }
  FlightParts operator()(const SpeedInputs& inputs) const {
    auto signal = loadInputs(inputs, rotors, context.directory, control);
    return prescribed(RotorDrive::PrescribedSpeeds,
                      std::make_unique<SpeedInputTask>(std::move(signal)));
  }
  FlightParts operator()(const VoltageInputs& inputs) const {
    auto signal = loadInputs(inputs, rotors, context.directory, control);
    return prescribed(RotorDrive::Motors, std::make_unique<VoltageInputTask>(std::move(signal)));
  }

 private:
  [[nodiscard]] FlightParts prescribed(RotorDrive drive, std::unique_ptr<Task> inputs) const {
    FlightParts parts;
    parts.plant = makePlant(flight, drive, vehicle);
    parts.tasks.push_back(std::move(inputs));
    return parts;
  }
};

}  // namespace

FlightParts controlledFlight(const Flight& flight, const ControlledInputs& inputs,
                             const BuildContext& context, const ControllerFactory& factory) {
  const Place vehicle = context.place / "vehicle";
  // The controller flies the vehicle as planned; deviations are what it does not know.
  const ControlModel model = controlModel(flight.vehicle, flight.environment, vehicle);
  const Timing speedTiming{
      ticksBetween(inputs.motors.rate, flight.tick, context.place / "control" / "motors" / "rate")};
  FlightParts parts;
  parts.plant = makePlant(flight, RotorDrive::Motors, vehicle);
  auto controller = factory(model);
  parts.held = controller->held();
  parts.timeline = inputs.setPoints;
  parts.tasks.push_back(makeSensors(flight.sensors, context.seed));
  parts.tasks.push_back(std::make_unique<TrueState>());
  parts.tasks.push_back(std::make_unique<Timeline>(inputs.setPoints, inputs.interpolation));
  parts.tasks.push_back(std::move(controller));
  parts.tasks.push_back(std::make_unique<SpeedControllers>(inputs.motors, model, speedTiming));
  return parts;
}

std::unique_ptr<Simulation> build(const Flight& flight, const BuildContext& context) {
  return std::make_unique<FlightSimulation>(
      flight, context.outputs, visitAlternative(PartsOf{flight, context}, flight.control));
}

}  // namespace rotorbench
