// A plant with its solver behind one interface: the edge where rotor count and drive are forgotten.
// The flight loop, tasks and metrics see this; inside a step nothing of it is called.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sim/control/control_model.h"
#include "sim/core/channel.h"
#include "sim/core/place.h"
#include "sim/document/flight.h"
#include "sim/environment/air.h"
#include "sim/ode/solver_settings.h"
#include "sim/ode/status.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/run/energy_watch.h"
#include "sim/signal/task.h"
#include "sim/vehicle/multirotor_layout.h"

namespace rotorbench {

class PlantHandle {
 public:
  virtual ~PlantHandle() = default;
  [[nodiscard]] virtual int rotors() const = 0;
  /// What row() writes, in this order.
  [[nodiscard]] virtual std::vector<Channel> channels() const = 0;
  [[nodiscard]] virtual double time() const = 0;

  /// Works out derivative and forces at time() and tells what of it is seen.
  virtual void observe(Truth& truth) = 0;
  /// The command from the tick's time on, or from when its dead times have passed. Brings
  /// derivative and forces up to date. Returns the supply's voltage under load, V.
  virtual double command(const ClockTick& tick, const RotorCommand& command) = 0;
  virtual void row(double* out) const = 0;
  /// The air is another from time() on, of the same models. Between two ticks.
  virtual void setAir(const AirConstants& air) = 0;
  /// Brings the plant exactly to `end`; dead times are multiples of nothing, so the solver stops on
  /// the way wherever a command begins to act. Stopped: something happened on the way that ends the
  /// flight; time() is when.
  virtual ode::Status advance(double end) = 0;

  [[nodiscard]] virtual const Supply& supply() const = 0;
  /// The lower limit of motor and speed controller, A; infinite where speeds are prescribed.
  [[nodiscard]] virtual double currentLimit(int rotor) const = 0;
  /// As of the last observe(); nothing where something else than the supply gives energy: wind, or
  /// whoever prescribes speeds.
  [[nodiscard]] virtual std::optional<EnergyBalance> energy() const = 0;
  /// Why the state is none of a flight, if it is finite and yet beyond every vehicle.
  [[nodiscard]] virtual std::optional<RunFailure> beyondFlight() const = 0;
  [[nodiscard]] virtual ode::Statistics statistics() const = 0;
  [[nodiscard]] virtual RunFailure failure() const = 0;
};

/// The plant of a flight whose rotors have motors, or turn at prescribed speeds, at the flight's
/// start. Throws InputError with paths below `vehicle`.
std::unique_ptr<PlantHandle> makePlant(const Flight& flight, RotorDrive drive,
                                       const Place& vehicle);

/// What a controller knows: the vehicle as planned, at the air density of sea level.
ControlModel controlModel(const VehicleParameters& vehicle,
                          const EnvironmentParameters& environment, const Place& place);

}  // namespace rotorbench
