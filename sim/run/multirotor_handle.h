// A multirotor of a fixed rotor count with its solver, commands on their way included, as a
// PlantHandle.
#pragma once

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "sim/analysis/trim.h"
#include "sim/document/flight.h"
#include "sim/ode/solver.h"
#include "sim/run/delayed_commands.h"
#include "sim/run/multirotor_plants.h"
#include "sim/run/plant_handle.h"
#include "sim/run/plausible.h"
#include "sim/vehicle/multirotor_outputs.h"

namespace rotorbench {

template <class Plant>
class MultirotorHandle final : public PlantHandle {
 public:
  static constexpr int kRotors = Plant::kRotors;
  static constexpr bool kMotors = Plant::kDrive == RotorDrive::Motors;
  using State = typename Plant::State;
  using Layout = typename Plant::Layout;
  using Command = typename Plant::Command;

  MultirotorHandle(const MultirotorConstants<kRotors>& constants, const Flight& flight)
      : plant_(constants),
        solver_(flight.solver, plant_),
        y_(initialState(plant_, flight.start)),
        commands_(deadTimes(constants), flight.tick),
        tick_(flight.tick) {
    if (flight.endsAtGround)
      landing_.events.push_back(
          {[](double /*t*/, const State& y) { return y[kHeight]; }, ode::Crossing::Falling, true});
    // Until the first command acts, the one that brought the rotors to their speeds does.
    if constexpr (kMotors) plant_.setCommand(y_.template segment<kRotors>(Layout::kDuty));
  }

  [[nodiscard]] int rotors() const override { return kRotors; }
  [[nodiscard]] double time() const override { return solver_.time(); }
  [[nodiscard]] const Supply& supply() const override { return plant_.constants().supply; }
  [[nodiscard]] double currentLimit(int rotor) const override {
    if (!kMotors) return std::numeric_limits<double>::infinity();
    return plant_.constants().hubs[static_cast<std::size_t>(rotor)].motor.maxCurrent;
  }
  [[nodiscard]] std::optional<EnergyBalance> energy() const override {
    const auto& c = plant_.constants();
    if (!kMotors || c.air.moving) return {};
    double body = c.mass * y_.template segment<3>(Layout::kVelocity).squaredNorm() +
                  forces_.rates.dot(c.inertia * forces_.rates);
    double magnetic = 0;
    for (int i = 0; i < kRotors; ++i) {
      const auto& hub = c.hubs[static_cast<std::size_t>(i)];
      const double speed = y_[Layout::kSpeed + i], current = y_[Layout::kCurrent + i];
      body += hub.rotor.inertia * speed * speed;
      magnetic += hub.motor.inductance * current * current;
    }
    const double potential = c.mass * c.gravity * y_[kHeight];
    return EnergyBalance{body / 2 + magnetic / 2 + potential, body / 2, y_[Layout::kEnergy],
                         c.mass};
  }
  [[nodiscard]] std::optional<RunFailure> beyondFlight() const override {
    return implausible<Plant>(time(), y_);
  }
  [[nodiscard]] RunFailure failure() const override { return solver_.runFailure(); }
  [[nodiscard]] ode::Statistics statistics() const override {
    ode::Statistics s = solver_.statistics();
    s.evaluations += startEvaluations_;
    return s;
  }

  [[nodiscard]] std::vector<Channel> channels() const override {
    std::vector<Channel> all;
    visitMultirotorOutputs<Plant>(
        plant_.constants().air, y_, forces_,
        [&](int rotor, const char* name, const char* unit, const char* description, double) {
          all.push_back({rotor == 0 ? name : rotorChannel(rotor, name), unit, description});
        });
    return all;
  }
  void row(double* out) const override {
    visitMultirotorOutputs<Plant>(
        plant_.constants().air, y_, forces_,
        [&](int, const char*, const char*, const char*, double value) { *out++ = value; });
  }

  void setAir(const AirConstants& air) override {
    plant_.setAir(air);
    solver_.restart();
  }

  void observe(Truth& truth) override {
    plant_.derivativeAndForces(time(), y_, derivative_, forces_);
    truth.body = {y_.template segment<3>(Layout::kPosition),
                  y_.template segment<3>(Layout::kVelocity), forces_.attitude, forces_.rates};
    truth.specificForce = forces_.specificForce;
    truth.drives.speed.template head<kRotors>() = y_.template segment<kRotors>(Layout::kSpeed);
    truth.drives.current.template head<kRotors>() = y_.template segment<kRotors>(Layout::kCurrent);
    truth.drives.busVoltage = forces_.busVoltage;
    truth.openCircuit = plant_.openCircuit(y_);
    const double qx = y_[Layout::kAttitude + 1], qy = y_[Layout::kAttitude + 2];
    truth.tiltCosine = 1 - 2 * (qx * qx + qy * qy);
  }

  double command(const ClockTick& tick, const RotorCommand& command) override {
    if (take(tick, command)) {
      ++startEvaluations_;
      // ABM4 keeps its history over ticks where nothing jumped.
      solver_.restart();
      solver_.setStartDerivative(derivative_);
    }
    return forces_.busVoltage;
  }

  ode::Status advance(double end) override {
    const auto act = [this](double time) {
      Command acting = plant_.command();
      commands_.take(time, acting);
      if (set(acting)) solver_.restart();
    };
    // Only who waits for an event pays for looking.
    const bool watched = landing_.wanted() && hasBeenAloft();
    const auto step = [this, watched](double to, State& y) {
      return watched ? solver_.advanceTo(to, y, landing_) : solver_.advanceTo(to, y);
    };
    return advanceWithCommands(step, y_, commands_, end, tick_, act);
  }

 private:
  /// m above the ground from which on it can be come back to: a controller that starts on it dips
  /// before it holds the weight.
  static constexpr double kAloft = 0.1;
  static constexpr int kHeight = Layout::kPosition + 2;
  bool hasBeenAloft() {
    aloft_ = aloft_ || y_[kHeight] > kAloft;
    return aloft_;
  }

  /// A vehicle that hovers only at a tilt begins at it, unless it is given one.
  static State initialState(const Plant& plant, FlightStart start) {
    if (start.rotors != RotorStart::Hover) return plant.initialState(start);
    // In the air of the height it begins at.
    MultirotorConstants<kRotors> there = plant.constants();
    there.air.elevation += start.position.z();
    const Trim hover = hoverToStartIn(there);
    if (start.attitude.x() == 0 && start.attitude.y() == 0)
      start.attitude.head<2>() << hover.roll, hover.pitch;
    return plant.initialState(start, hover.speeds.template head<kRotors>());
  }

  static std::array<double, kRotors> deadTimes(const MultirotorConstants<kRotors>& constants) {
    std::array<double, kRotors> times{};
    for (std::size_t i = 0; kMotors && i < times.size(); ++i) times[i] = constants.hubs[i].deadTime;
    return times;
  }

  /// The state follows; false if nothing changed.
  bool set(const Command& acting) {
    if (acting == plant_.command()) return false;
    plant_.setCommand(acting, y_);
    return true;
  }

  /// True if anything jumped.
  bool take(const ClockTick& tick, const RotorCommand& command) {
    const Command value = command.value.template head<kRotors>();
    if constexpr (kMotors) {
      Command acting = plant_.command();
      commands_.give(tick.time, plant_.allowed(value), acting);
      if (!set(acting)) return false;
      plant_.updateCommand(y_, derivative_, forces_);
      return true;
    } else {
      const Command rate = command.rate.template head<kRotors>();
      const bool jumped =
          rate != plant_.command() || value != y_.template segment<kRotors>(Layout::kSpeed);
      plant_.setCommand(rate);
      Plant::setRotorSpeeds(y_, value);
      if (jumped) plant_.derivativeAndForces(tick.time, y_, derivative_, forces_);
      return jumped;
    }
  }

  Plant plant_;
  ode::Solver<Plant> solver_;
  State y_, derivative_;
  DelayedCommands<kRotors> commands_;
  double tick_;
  ode::Watch<State> landing_;  ///< of nothing, unless the flight ends at the ground
  bool aloft_ = false;
  MultirotorForces<kRotors> forces_{};
  std::int64_t startEvaluations_ = 0;  ///< derivatives handed to the solver as the start of a step
};

template <int N>
std::unique_ptr<PlantHandle> makeMultirotor(const Flight& flight, RotorDrive drive) {
  const auto constants = buildMultirotor<N>(flight.vehicle, flight.environment);
  if (drive == RotorDrive::Motors)
    return std::make_unique<MultirotorHandle<Multirotor<N, RotorDrive::Motors>>>(constants, flight);
  return std::make_unique<MultirotorHandle<Multirotor<N, RotorDrive::PrescribedSpeeds>>>(constants,
                                                                                         flight);
}

}  // namespace rotorbench
