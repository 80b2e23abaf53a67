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

LivePart liveWind(PlantHandle& plant) {
  return {"environment.wind",
          [&plant](const Flight& f, double /*time*/) { plant.setAir(buildAir(f.environment)); }};
}

/// A part that takes its values from the inputs of a controlled flight.
template <class Take>
LivePart liveInputs(const char* path, Take take) {
  return {path, [take](const Flight& f, double time) {
            take(*std::get<Box<ControlledInputs>>(f.control), time);
          }};
}

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
    parts.live.push_back(liveWind(*parts.plant));
    return parts;
  }
};

}  // namespace

FlightParts controlledFlight(const Flight& flight, const ControlledInputs& inputs,
                             const BuildContext& context, const ControllerFactory& factory) {
  const Place vehicle = context.place / "vehicle";
  // No speed of the rotors is the one that gives a thrust.
  if (!(buildAir(flight.environment).density(flight.start.position.z()) > 0))
    throw(context.place / "environment" / "air")
        .error({{"density", "a controller cannot fly where there is no air", "must be above 0"}});
  // The controller flies the vehicle as planned; deviations are what it does not know.
  const ControlModel model = controlModel(flight.vehicle, flight.environment, vehicle);
  const Timing speedTiming{
      ticksBetween(inputs.motors.rate, flight.tick, context.place / "control" / "motors" / "rate")};
  FlightParts parts;
  parts.plant = makePlant(flight, RotorDrive::Motors, vehicle);
  MadeController controller = factory(model);
  auto timeline = std::make_unique<Timeline>(inputs);
  auto speeds = std::make_unique<SpeedControllers>(inputs.motors, model, speedTiming);
  parts.held = controller.task->held();
  parts.timeline = timeline.get();
  parts.live.push_back(liveWind(*parts.plant));
  const auto takeRows = [t = timeline.get()](const ControlledInputs& i, double time) {
    t->take(i, time);
  };
  parts.live.push_back(liveInputs("control.setPoints", takeRows));
  parts.live.push_back(liveInputs("control.byHand", takeRows));
  parts.live.push_back(liveInputs(
      "control.motors",
      [s = speeds.get()](const ControlledInputs& i, double /*time*/) { s->retune(i.motors); }));
  if (controller.retune)
    parts.live.push_back(
        liveInputs("control.controller",
                   [retune = controller.retune](const ControlledInputs& i, double /*time*/) {
                     retune(i.controller);
                   }));
  parts.tasks.push_back(makeSensors(flight.sensors, context.seed));
  parts.tasks.push_back(std::make_unique<TrueState>());
  parts.tasks.push_back(std::move(timeline));
  parts.tasks.push_back(std::move(controller.task));
  parts.tasks.push_back(std::move(speeds));
  return parts;
}

std::unique_ptr<Simulation> build(const Flight& flight, const BuildContext& context) {
  return std::make_unique<FlightSimulation>(
      flight, context.outputs, visitAlternative(PartsOf{flight, context}, flight.control));
}

}  // namespace rotorbench
