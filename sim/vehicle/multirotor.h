// A multirotor as a rigid body with N spinning rotors: Newton-Euler equations (physics of Mahony,
// Kumar, Corke, "Multirotor Aerial Vehicles", IEEE RAM 2012) with any of the rotor models, motors,
// speed controllers and one supply for all of them. SI units; inertial frame x forward, y left, z
// up; body axes alike, origin of the state: the actual centre of mass.
//
//   p' = v            v' = g + R F/m            q' = q * (0, w)/2
//   H' = tau - w x H  with  H = I w + sum_i s_i J_i Omega_i a_i   (body axes)
//
// H is the angular momentum of body and rotors together. Carrying it instead of the body rates w
// makes the gyroscopic moment -w x sum(s J Omega a) and the reaction -s_i J_i Omega_i' a_i of
// accelerating rotors exact with no equation to solve: motor torques act inside the system, and
// only the aerodynamic torque Q_i remains in tau. w follows from bodyRates(). A jump of a
// prescribed rotor speed leaves H and turns the body, as it must.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "sim/environment/environment.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/drive/bus.h"
#include "sim/propulsion/drive/conversion.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"
#include "sim/propulsion/rotor/rotor.h"
#include "sim/vehicle/attitude.h"
#include "sim/vehicle/multirotor_layout.h"
#include "sim/vehicle/rotation.h"
#include "sim/vehicle/vehicle_parameters.h"

namespace rotorbench {

/// The constants of all rotors side by side, lane i for rotor i: the derivative works on every
/// rotor at once, with the vector instructions of the processor.
template <int N>
struct RotorLanes {
  using Lanes = Eigen::Array<double, N, 1>;
  std::array<Lanes, 3> arm, axis, momentum;  ///< x, y, z of what Hub holds
  Lanes spin, inverseInertia;
  Lanes escResistance;  ///< Ohm
  /// V: within these of the back-EMF the converter gives what the duty asks for; beyond them, see
  /// EscConstants.
  Lanes leastExcess, mostExcess;
  DutyModel<Lanes> duty;
  RotorModel<Lanes> rotor;
  MotorModel<Lanes> motor;
};

/// One rotor in its place, with motor and speed controller.
struct RotorHub {
  Eigen::Vector3d arm;       ///< m, from the centre of mass
  Eigen::Vector3d axis;      ///< unit thrust direction
  double spin;               ///< +1 counter-clockwise from above
  Eigen::Vector3d momentum;  ///< s J a: angular momentum per rotor speed
  RotorConstants rotor;
  MotorConstants motor;  ///< its current limit is the lower one of motor and speed controller
  EscConstants esc;
  double deadTime = 0;  ///< s until a command begins to act; whoever gives it waits
  /// Winding and speed controller as one: what a controller sees that sets the duty.
  [[nodiscard]] MotorConstants drive() const {
    MotorConstants m = motor;
    m.resistance += esc.resistance;
    return m;
  }
};

/// Everything the derivative needs, computed once per run.
template <int N>
struct MultirotorConstants {
  using Hub = RotorHub;
  std::array<Hub, N> hubs;
  RotorLanes<N> lanes;  ///< the numbers of `hubs` again
  double mass, inverseMass;
  Eigen::Vector3d centre;  ///< centre of mass in the body frame of the parameters
  Eigen::Matrix3d inertia, inverseInertia;
  double gravity;
  AirConstants air;
  BodyDrag drag;
  bool lumped = true;      ///< every rotor: `lanes` holds all of them
  bool passive = false;    ///< some speed controller does not brake actively
  bool lossy = false;      ///< some speed controller states losses of conversion.h
  double openCircuit = 0;  ///< V, of the supply at the start; of one that never empties always
  Supply supply{SupplyModel{}};
  double avionicsPower = 0;  ///< W
};

/// Throws InputError naming every problem of mass properties or rotor numbers. `asPlanned` leaves
/// deviations out.
template <int N>
MultirotorConstants<N> buildMultirotor(const VehicleParameters& vehicle,
                                       const EnvironmentParameters& environment,
                                       bool asPlanned = false);

template <int N, RotorDrive Drive = RotorDrive::Motors>
class Multirotor {
 public:
  using Layout = MultirotorLayout<N>;
  using Constants = MultirotorConstants<N>;
  static constexpr int kRotors = N;
  static constexpr int kStates = Layout::kStates;
  static constexpr RotorDrive kDrive = Drive;
  template <class S>
  using StateOf = Eigen::Matrix<S, kStates, 1>;
  using State = StateOf<double>;
  template <class S>
  using CommandOf = Eigen::Matrix<S, N, 1>;
  using Command = CommandOf<double>;
  /// One quantity of every rotor.
  template <class S>
  using LanesOf = Eigen::Array<S, N, 1>;

  explicit Multirotor(const Constants& constants) : constants_(constants) {}

  /// The air from now on.
  void setAir(const AirConstants& air) { constants_.air = air; }

  /// Held between two calls; see RotorDrive. Duties beyond what the speed controllers take are cut
  /// off.
  void setCommand(const Command& command) { command_ = allowed(command); }
  /// The same in the course of a flight: the state takes what jumps with it.
  void setCommand(const Command& command, State& y) {
    setCommand(command);
    settle(y);
  }
  /// What of a command the speed controllers take.
  [[nodiscard]] Command allowed(const Command& command) const {
    if constexpr (Drive == RotorDrive::PrescribedSpeeds) return command;
    return command.array().max(constants_.lanes.duty.least).min(1).matrix();
  }
  [[nodiscard]] const Command& command() const { return command_; }

  /// Kept out of line: solvers call it from many places, and the call costs nothing beside it.
  [[gnu::noinline]] void operator()(double t, const State& y, State& dydt) const {
    evaluate(t, command_, y, dydt, [](auto&&...) {});
  }

  /// The derivative over any scalar, for a command over any scalar.
  template <class S>
  void derivative(double t, const CommandOf<S>& command, const StateOf<S>& y,
                  StateOf<S>& dydt) const {
    evaluate(t, command, y, dydt, [](auto&&...) {});
  }

  /// The derivative together with the quantities it passes through.
  void derivativeAndForces(double t, const State& y, State& dydt,
                           MultirotorForces<N>& forces) const;
  /// Brings both up to date after setCommand(command, y) without working out everything again: only
  /// the electrical side depends on a motor's command.
  void updateCommand(const State& y, State& dydt, MultirotorForces<N>& forces) const;

  /// To be called once after each step: brings the quaternion back to unit length and ends currents
  /// that a passive speed controller does not let flow.
  void afterStep(State& y) const {
    y.template segment<4>(Layout::kAttitude) *= 1 / y.template segment<4>(Layout::kAttitude).norm();
    if (constants_.passive) settle(y);
  }

  /// Linear pairs for the exponential Runge-Kutta method. First the motors' (speed, current),
  /// linear(i) being the constant part [[-f/J, K/J], [-K/L, -R/L]] of their equations, R with the
  /// speed controller's (zero where speeds are prescribed); then the duties two by two, which a
  /// command held for the step makes linear altogether.
  static constexpr int kPairs = Drive == RotorDrive::Motors ? N + N / 2 : N;
  static_assert(N % 2 == 0);
  static constexpr std::pair<int, int> pair(int i) {
    if (i < N) return {Layout::kSpeed + i, Layout::kCurrent + i};
    return {Layout::kDuty + 2 * (i - N), Layout::kDuty + 2 * (i - N) + 1};
  }
  [[nodiscard]] Eigen::Matrix2d linear(int i) const;

  /// Body rates in rad/s from the total angular momentum.
  template <class S>
  [[nodiscard]] Eigen::Matrix<S, 3, 1> bodyRates(const StateOf<S>& y) const {
    Eigen::Matrix<S, 3, 1> body = y.template segment<3>(Layout::kMomentum);
    const LanesOf<S> speed = y.template segment<N>(Layout::kSpeed).array();
    for (std::size_t k = 0; k < 3; ++k) {
      body[static_cast<int>(k)] -= LanesOf<S>(constants_.lanes.momentum[k] * speed).sum();
    }
    return times(constants_.inverseInertia, body);
  }
  /// Sets the total angular momentum so that the body turns at `rates` with the rotor speeds of the
  /// state.
  void setBodyRates(State& y, const Eigen::Vector3d& rates) const;
  /// Prescribes rotor speeds from now on; the body takes up the change of the rotors' momentum.
  static void setRotorSpeeds(State& y, const Command& speeds) {
    y.template segment<N>(Layout::kSpeed) = speeds;
  }

  /// A state of the centre of mass at `start`; the body frame's origin plays no role. Rotors that
  /// hover are at hoverSpeeds(), or at `hover` where that is given (sim/analysis/trim.h); turning
  /// rotors have the currents and duties that hold their speeds.
  [[nodiscard]] State initialState(const FlightStart& start) const;
  [[nodiscard]] State initialState(const FlightStart& start, const Command& hover) const;
  /// Rotor speeds in rad/s whose thrusts carry the vehicle level in still air without a moment
  /// about the x and y axes, and about z as far as spins allow. Throws InputError if some rotor
  /// would have to pull downwards.
  [[nodiscard]] Command hoverSpeeds() const;
  /// Duties that hold given rotor speeds in still air. May exceed 1 where the supply is too weak.
  [[nodiscard]] Command steadyDuties(const Command& speeds) const;

  /// Open-circuit voltage in V and state of charge, 0..1, of the supply.
  template <class S>
  [[nodiscard]] S stateOfCharge(const StateOf<S>& y) const {
    return S(constants_.supply.charge - y[Layout::kCharge] * constants_.supply.inverseCapacity);
  }
  template <class S>
  [[nodiscard]] S openCircuit(const StateOf<S>& y) const {
    if (!(constants_.supply.inverseCapacity > 0)) return S(constants_.openCircuit);
    return constants_.supply.openCircuit(stateOfCharge(y));
  }
  /// The energy ledger of supply and motors with the command held.
  [[nodiscard]] FlightPowers powers(double t, const State& y) const;

  /// "rotor1.speed", "position.z": for messages about a state component.
  [[nodiscard]] static std::string componentName(int index);
  [[nodiscard]] const Constants& constants() const { return constants_; }

 private:
  template <class S>
  static Eigen::Matrix<S, 3, 1> times(const Eigen::Matrix3d& m, const Eigen::Matrix<S, 3, 1>& v) {
    Eigen::Matrix<S, 3, 1> r;
    for (int k = 0; k < 3; ++k) r[k] = m(k, 0) * v[0] + m(k, 1) * v[1] + m(k, 2) * v[2];
    return r;
  }

  /// Duties without a lag become their commands; see EscConstants::settle().
  void settle(State& y) const;
  [[nodiscard]] Command steadyDuties(const Command& speeds, double density) const;

  /// Supply and motors' voltages for a command and a current of each.
  template <class S>
  struct Electrical {
    LanesOf<S> duty, voltage;
    S bus, supplyCurrent;
  };
  template <class S>
  [[nodiscard]] Electrical<S> electrical(const CommandOf<S>& command, const StateOf<S>& y) const;
  /// Some speed controller gives other than its duty asks for.
  template <class S>
  [[nodiscard]] bool someLimit(const LanesOf<S>& excess) const;
  template <class S>
  void addLosses(const LanesOf<S>& current, const LanesOf<S>& back, const S& inner,
                 Electrical<S>& at) const;
  template <class S>
  void limitVoltages(const LanesOf<S>& current, const LanesOf<S>& back, const S& inner,
                     Electrical<S>& at) const;
  /// A supply whose current takes all its voltage.
  template <class S>
  void collapse(const S& inner, Electrical<S>& at) const;
  /// limitVoltages() where the supply has less than half its voltage left or cannot give the power.
  template <class S>
  void weakBus(const LanesOf<S>& current, const LanesOf<S>& back, const S& inner,
               Electrical<S>& at) const;
  template <class S>
  using LoadOf = RotorLoad<LanesOf<S>, std::array<LanesOf<S>, 3>>;
  /// Rotor by rotor, where one at least is not lumped.
  template <class S>
  [[nodiscard]] LoadOf<S> mixedLoads(const LanesOf<S>& speed,
                                     const std::array<LanesOf<S>, 3>& hubVelocity,
                                     const LanesOf<S>& density) const;

  /// What forces depend on, and their sum so far.
  template <class S>
  struct Flow {
    detail::Rotation<S> rotation;   ///< body to inertial
    Eigen::Matrix<S, 3, 1> rates;   ///< rad/s, body axes
    AirAt<S> air;                   ///< at the centre of mass
    Eigen::Matrix<S, 3, 1> motion;  ///< m/s, of the centre of mass against the air, body axes
  };
  template <class S>
  struct Sum {
    Eigen::Matrix<S, 3, 1> force, moment;  ///< N, N m about the centre of mass, body axes
  };
  template <class S>
  [[nodiscard]] Flow<S> flow(double t, const StateOf<S>& y) const;
  /// The contributions to the sum of forces, in the order in which they are added; the first one
  /// begins it.
  template <class S>
  void beginWithDrag(const Flow<S>& at, Sum<S>& sum) const;
  template <class S>
  void addRotors(double t, const StateOf<S>& y, const Flow<S>& at, Sum<S>& sum, LanesOf<S>& thrust,
                 LanesOf<S>& torque) const;
  /// Where the air differs from hub to hub: takes its velocity out of the hubs' and gives its
  /// density at each.
  template <class S>
  [[nodiscard]] LanesOf<S> airAtHubs(double t, const StateOf<S>& y, const Flow<S>& at,
                                     std::array<LanesOf<S>, 3>& hubVelocity) const;
  template <class S>
  void motionRates(const StateOf<S>& y, const Flow<S>& at, Sum<S>& sum, StateOf<S>& dydt) const;

  template <class S, class Sink>
  void evaluate(double t, const CommandOf<S>& command, const StateOf<S>& y, StateOf<S>& dydt,
                Sink&& sink) const;

  Constants constants_;
  Command command_ = Command::Zero();
};

}  // namespace rotorbench

#include "sim/vehicle/multirotor_equations.h"
