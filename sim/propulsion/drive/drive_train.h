// One motor on a stand: supply -> speed controller -> motor -> load, coupled as they are in a
// vehicle. SI units; speed positive in the rotor's own sense.
//   bus       see bus.h;   dz/dt = -i_bus/Q,   dv_rc/dt = (R_1 i_bus - v_rc)/tau_1
//   converter see esc.h, its losses conversion.h
//   motor     L di/dt = v - R i - K w,   J dw/dt = K i - friction(w) - load(w)        thesis 2014,
//             figure 3.11
// With quasi-static current L is taken as 0: i follows v and w at once, which is exact in the
// steady state and late by L/R otherwise; the ripple of a current needs an inductance, so that then
// the converter has no losses but its resistance.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string_view>
#include <vector>

#include "sim/core/scalar.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/drive/bus.h"
#include "sim/propulsion/drive/conversion.h"
#include "sim/propulsion/drive/esc.h"
#include "sim/propulsion/drive/motor.h"

namespace rotorbench {

/// Coefficients of a propeller on a stand at equal steps of speed from 0 on: they change little
/// with it, so that straight lines between them do.
struct SpeedCurve {
  double step = 1;             ///< rad/s
  std::vector<double> values;  ///< two at least

  /// At the magnitude of speed w; the last value beyond the end. Any scalar.
  template <class S>
  [[nodiscard]] S at(const S& w) const {
    using std::abs;
    const S place = S(abs(w) / step);
    const double most = static_cast<double>(values.size() - 1);
    if (!(valueOf(place) < most)) return S(values.back());
    const auto i = static_cast<std::size_t>(valueOf(place));
    return S(values[i] + (place - static_cast<double>(i)) * (values[i + 1] - values[i]));
  }
};

/// What the shaft carries: a propeller's torque at rest in the air, friction of a brake, nothing.
struct ShaftLoad {
  SpeedCurve quadratic{1, {0, 0}};  ///< N m s^2: torque per speed squared, against the rotation
  double constant = 0;  ///< N m: a friction brake, smooth through rest as the motor's own friction
  SpeedCurve thrust{1, {0, 0}};  ///< N s^2: thrust per speed squared, for reading

  template <class S>
  [[nodiscard]] S torque(const S& w) const {
    using std::abs;
    using std::sqrt;
    return S(quadratic.at(w) * w * abs(w) +
             constant * w / sqrt(w * w + kFrictionSpeed * kFrictionSpeed));
  }
  /// N along the axis; backwards as much the other way.
  [[nodiscard]] double thrustAt(double w) const { return thrust.at(w) * w * std::abs(w); }
};

/// Speed in rad/s that a motor holds with a load at a terminal voltage v in V.
double steadySpeed(const MotorConstants& motor, const ShaftLoad& load, double v);

struct DriveTrainSetup {
  SupplyModel supply;
  EscParameters esc;
  MotorParameters motor;
  ShaftLoad load;
  double inertia = 1e-5;  ///< kg m^2 of all that spins
  bool quasiStaticCurrent = false;
  /// Without saturation: the speed controller gives any share of the voltage, also a negative one
  /// or one above 1, and no limit holds the current. No real drive can; it shows what the limits
  /// do.
  bool unlimited = false;
};

/// Electrical and mechanical figures of one instant.
template <class S>
struct DriveInstant {
  S duty{}, current{}, busVoltage{}, busCurrent{}, motorVoltage{}, openCircuit{};
};

/// Powers in W of one instant; what goes in equals what is stored and lost.
struct DrivePowers {
  double source;        ///< OCV i_bus, taken from the cells
  double supplyLoss;    ///< R_0 i_bus^2 + v_rc i_bus
  double escLoss;       ///< what the converter takes and does not give: R_esc i^2 and conversion.h
  double copperLoss;    ///< R i^2
  double frictionLoss;  ///< friction(w) w
  double load;          ///< load(w) w, the shaft power
  double magnetic;      ///< d/dt of L i^2/2
  double kinetic;       ///< d/dt of J w^2/2
  /// source minus everything else; 0 up to rounding.
  [[nodiscard]] double residual() const {
    return source - supplyLoss - escLoss - copperLoss - frictionLoss - load - magnetic - kinetic;
  }
};

class DriveTrain {
 public:
  static constexpr int kStates = 5;
  enum Index { kCurrent, kSpeed, kDuty, kCharge, kPolarisation };
  template <class S>
  using StateOf = Eigen::Matrix<S, kStates, 1>;
  using State = StateOf<double>;

  /// The parameters must satisfy their schemas.
  explicit DriveTrain(const DriveTrainSetup& setup);

  /// At rest, the supply as charged as its parameters say, the command 0.
  [[nodiscard]] State initialState() const;
  /// Throttle: 0..1, or -1..1 where the speed controller is reversible; more is cut off. Held until
  /// the next call; `y` takes it at once where the speed controller has no response time.
  void setThrottle(double throttle, State& y);
  [[nodiscard]] double throttle() const { return throttle_; }
  /// What of a throttle the speed controller takes.
  [[nodiscard]] double allowedThrottle(double throttle) const { return esc_.allowed(throttle); }

  template <class S>
  [[nodiscard]] DriveInstant<S> instant(const StateOf<S>& y) const {
    DriveInstant<S> at;
    const S& w = y[kSpeed];
    const S back = S(motor_.torqueConstant * w);
    at.duty = y[kDuty];
    at.openCircuit = supply_.openCircuit(S(y[kCharge]));
    const S inner = S(at.openCircuit - y[kPolarisation]);
    if (quasiStatic_) {
      at.current = quasiStaticCurrent(at.duty, inner, back);
      at.motorVoltage = S(motor_.resistance * at.current + back);
    } else if (lossy_) {
      lossyInstant(S(inner), back, S(y[kCurrent]), at);
      return at;
    } else {
      at.current = y[kCurrent];
      const S free = S(at.duty * (inner - supply_.resistance * at.duty * at.current) -
                       esc_.resistance * at.current);
      at.motorVoltage = esc_.voltage(motor_, at.duty, at.current, free, back);
    }
    const S power = converterPower(at.motorVoltage, esc_.resistance, at.current);
    const S kept = S(inner - supply_.resistance * at.duty * at.current);
    if (!isStrongBus(valueOf(kept), valueOf(inner), valueOf(power), supply_.resistance) &&
        weakBus(inner, back, kept, power, at)) [[unlikely]]
      return at;
    at.busVoltage = busVoltage(inner, power, supply_.resistance);
    at.busCurrent = S(power / at.busVoltage);
    return at;
  }

  template <class S>
  void derivative(const StateOf<S>& y, StateOf<S>& dydt) const {
    const DriveInstant<S> at = instant(y);
    const S& w = y[kSpeed];
    dydt[kCurrent] = quasiStatic_ ? S(0) : motor_.currentRate(at.motorVoltage, at.current, w);
    dydt[kSpeed] = (motor_.torqueConstant * at.current - motor_.friction(w) - load_.torque(w)) *
                   inverseInertia_;
    dydt[kDuty] = esc_.rate(S(asked_), S(y[kDuty]));
    dydt[kCharge] = -at.busCurrent * supply_.inverseCapacity;
    dydt[kPolarisation] =
        (supply_.polarisation * at.busCurrent - y[kPolarisation]) * supply_.inversePolarisationTime;
  }
  void operator()(double /*t*/, const State& y, State& dydt) const { derivative(y, dydt); }
  void afterStep(State& y) const { esc_.settle(y[kDuty], y[kCurrent]); }
  static std::string_view componentName(int index);

  [[nodiscard]] DrivePowers powers(const State& y) const;
  /// Largest magnitude of the poles of current and speed about speed w, 1/s.
  [[nodiscard]] double fastestPole(double w) const;
  /// Speed in rad/s that the motor holds with its load at a terminal voltage v in V.
  [[nodiscard]] double steadySpeed(double v) const {
    return rotorbench::steadySpeed(motor_, load_, v);
  }
  /// The steady state with the throttle given, at a state of charge and a polarised voltage.
  [[nodiscard]] State steadyState(double throttle, double charge, double polarisation) const;

  [[nodiscard]] const EscConstants& esc() const { return esc_; }
  [[nodiscard]] const MotorConstants& motor() const { return motor_; }
  [[nodiscard]] const ShaftLoad& load() const { return load_; }
  [[nodiscard]] const Supply& supply() const { return supply_; }
  [[nodiscard]] double inertia() const { return 1 / inverseInertia_; }
  /// The lower limit of motor and speed controller, A.
  [[nodiscard]] double maxCurrent() const { return esc_.maxCurrent; }

 private:
  /// Current, voltages and bus of a converter with losses.
  template <class S>
  void lossyInstant(const S& inner, const S& back, const S& current, DriveInstant<S>& at) const {
    using std::max;
    at.current = current;
    const double r = supply_.resistance;
    // The ripple is that under the voltage a converter without losses would see.
    const S lossless = S(max(S(inner - r * at.duty * current), S(0.5 * inner)));
    const Conversion<S> c = conversion(esc_, at.duty, current, back, lossless);
    const S bus = S((inner - r * (c.duty * current + c.chopped)) / (1.0 + r * c.perVoltage));
    const S free =
        S(c.duty * bus - (esc_.resistance + esc_.leadResistance * c.duty * c.duty) * current);
    at.motorVoltage = esc_.voltage(motor_, at.duty, current, free, back);
    const S power = S(converterPower(at.motorVoltage, esc_.resistance, current) +
                      conversionLoss(esc_, c, current, bus));
    at.busVoltage = busVoltage(inner, power, r);
    at.busCurrent = S(power / at.busVoltage);
  }
  /// The current in A that a duty holds at a speed, inductance or not.
  [[nodiscard]] double heldCurrent(const State& y, double speed) const;
  /// The supply has less than half its voltage left, `kept` V with the duty kept, or cannot give
  /// the power. False where it has more all the same: a limit holds a current without inductance.
  template <class S>
  bool weakBus(const S& inner, const S& back, const S& kept, const S& power,
               DriveInstant<S>& at) const {
    if (quasiStatic_) {
      const S asked = S(at.duty * at.current * kept);
      if (std::abs(valueOf(power) - valueOf(asked)) > 1e-9 * std::abs(valueOf(power))) return false;
      at.busVoltage = kept;
      at.busCurrent = S(at.duty * at.current);
      if (valueOf(kept) < 0) {
        // A rotor turned against its duty brakes through the diodes.
        const BusPoint<S> none = emptyBus(inner, supply_.resistance);
        at.busVoltage = none.voltage;
        at.busCurrent = none.current;
        at.current = S(-back / (motor_.resistance + esc_.resistance));
        at.motorVoltage = S(-esc_.resistance * at.current);
      }
      return true;
    }
    const S duty = at.duty;
    const auto drawn = [&](const S& bus) {
      at.duty = esc_.shareOf(motor_, duty, at.current, back, bus);
      return S(at.duty * at.current);
    };
    const BusPoint<S> point = loadedBus<S>(inner, supply_.resistance, drawn);
    at.busVoltage = point.voltage;
    at.busCurrent = point.current;
    at.motorVoltage = S(at.duty * at.busVoltage - esc_.resistance * at.current);
    return true;
  }
  /// The current of a winding without inductance, the sag of the supply in it, at a back-EMF.
  template <class S>
  [[nodiscard]] S quasiStaticCurrent(const S& duty, const S& inner, const S& back) const {
    const S sag = S(duty * duty * supply_.resistance);
    const S free = S((duty * inner - back) / (motor_.resistance + esc_.resistance + sag));
    return esc_.quasiStaticCurrent(motor_, duty, free, back);
  }

  Supply supply_;
  MotorConstants motor_;
  ShaftLoad load_;
  EscConstants esc_;
  double inverseInertia_;
  bool quasiStatic_;
  bool lossy_;                       ///< the losses of conversion.h act
  double throttle_ = 0, asked_ = 0;  ///< as given, and the duty the speed controller makes of it
};

}  // namespace rotorbench
