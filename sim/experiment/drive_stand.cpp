#include "sim/experiment/drive_stand.h"

#include <algorithm>
#include <cmath>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/experiment/step_stability.h"
#include "sim/propulsion/lumped_rotor.h"

namespace rotorbench {

namespace {

/// Points of a propeller's curve over the speed; fewer do where only the step is judged.
constexpr int kSpeedPoints = 64, kFewSpeedPoints = 4;

struct LoadOf {
  double topSpeed;  ///< rad/s, never exceeded: the motor's speed at the full voltage of the supply
  int points;

  ShaftLoad operator()(const FreeShaft& /*load*/) const { return {}; }
  ShaftLoad operator()(const BrakeLoad& load) const { return {.constant = load.torque}; }
  ShaftLoad operator()(const PropellerLoad& p) const {
    const SquareFactors factors =
        squareFactors(p.thrustCoefficient, p.powerCoefficient, p.diameter);
    const double torque = p.airDensity * factors.torque, thrust = p.airDensity * factors.thrust;
    return {.quadratic = {1, {torque, torque}}, .thrust = {1, {thrust, thrust}}};
  }
  ShaftLoad operator()(const BladeElementLoad& p) const {
    const BladeElementRotor rotor(p.propeller, p.settings);
    const AirState air{p.airDensity, p.airViscosity};
    ShaftLoad load;
    load.quadratic = load.thrust = {topSpeed / points, {}};
    for (int k = 0; k <= points; ++k) {
      // At rest the coefficients are those of the slowest turning, which is a limit and no division
      // by zero.
      const double w = topSpeed * std::max(k, 1) / points;
      const AxialLoad at = rotor.axial(w, 0, air);
      load.quadratic.values.push_back(at.torque / (w * w));
      load.thrust.values.push_back(at.thrust / (w * w));
    }
    return load;
  }
};

DriveTrainSetup setupOf(const DriveStand& stand, int speedPoints) {
  const double topSpeed = Supply(stand.supply).openCircuit(1.0) * stand.motor.speedConstant;
  return {.supply = stand.supply,
          .esc = stand.esc,
          .motor = stand.motor,
          .load = std::visit(LoadOf{topSpeed, speedPoints}, stand.load),
          .inertia = stand.inertia,
          .quasiStaticCurrent = stand.quasiStaticCurrent};
}

}  // namespace

DriveTrain buildDriveTrain(const DriveStand& stand) {
  return DriveTrain(setupOf(stand, kSpeedPoints));
}

DriveTrain buildUnlimitedDriveTrain(const DriveStand& stand) {
  DriveTrainSetup setup = setupOf(stand, kSpeedPoints);
  const Supply supply(stand.supply);
  setup.supply = SupplyParameters{.voltage = supply.openCircuit(supply.charge)};
  setup.unlimited = true;
  return DriveTrain(setup);
}

std::vector<Channel> driveChannels() {
  return {{"time", "s", "Simulated time"},
          {"throttle", "1", "Throttle asked of the speed controller"},
          {"esc.duty", "1", "Share of the supply's voltage put on the motor"},
          {"supply.voltage", "V", "Voltage of the supply under load"},
          {"supply.current", "A", "Current drawn from the supply"},
          {"supply.charge", "1", "State of charge of the battery"},
          {"motor.voltage", "V", "Voltage at the motor's terminals"},
          {"motor.current", "A", "Current of the motor"},
          {"motor.speed", "rad/s", "Angular speed"},
          {"motor.torque", "N*m", "Torque of the load on the shaft"},
          {"thrust", "N", "Thrust of the propeller"},
          {"thrust_per_power", "N/W", "Thrust over electrical power"},
          {"power.electrical", "W", "Power drawn from the supply"},
          {"power.shaft", "W", "Power delivered to the load"},
          {"efficiency", "1", "Shaft power over electrical power"},
          {"power.residual", "W", "What the energy ledger leaves over: rounding"}};
}

void driveRow(const DriveTrain& train, double time, double asked, const DriveTrain::State& y,
              double* out) {
  const DriveInstant<double> at = train.instant(y);
  const DrivePowers powers = train.powers(y);
  const double w = y[DriveTrain::kSpeed];
  const double thrust = train.load().thrustAt(w);
  const double electrical = at.busVoltage * at.busCurrent;
  const double values[] = {
      time, asked, at.duty, at.busVoltage, at.busCurrent, y[DriveTrain::kCharge], at.motorVoltage,
      at.current, w, train.load().torque(w), thrust,
      // While the propeller drives the motor the ratio says nothing.
      electrical > 0 && powers.load <= electrical ? thrust / electrical : 0.0, electrical,
      powers.load,
      electrical > 0 && powers.load >= 0 ? std::min(powers.load / electrical, 1.0) : 0.0,
      powers.residual()};
  std::copy(std::begin(values), std::end(values), out);
}

void checkDriveMethod(const ode::SolverSettings& solver, std::vector<Problem>& problems) {
  if (solver.method != ode::Method::ExponentialRk4) return;
  problems.push_back({"solver.method", "Exponential RK4 is made for the motors of a vehicle",
                      "choose another method, or quasi-static current"});
}

void warnOfUnstableStep(const DriveStand& stand, const ode::SolverSettings& solver, double tick,
                        std::vector<Problem>& problems) {
  if (!(stabilityLimit(solver.method) > 0)) return;
  // Rules are asked of documents with faults too, and nothing can be built of a stand that has
  // some.
  const auto faults = schema::validate(schema::ref(stand));
  if (std::ranges::any_of(faults, [](const Problem& p) { return !p.warning; })) return;
  // The motor makes the fast pole; the propeller's share of it changes little between few points.
  const DriveTrain train(setupOf(stand, kFewSpeedPoints));
  const double top = train.steadySpeed(train.supply().openCircuit(1.0));
  const double pole = std::max(train.fastestPole(0), train.fastestPole(top));
  const double lag = train.esc().inverseResponse;
  StepWarning words{"run.solver.step", "the motor's fastest pole", "quasi-static current"};
  if (lag > pole) words = {"run.solver.step", kLagPole, "no response time"};
  addUnstableStep(words, std::max(pole, lag), solver, tick, problems);
}

void Describe<FreeShaft>::fields(schema::Builder<FreeShaft>& b) {
  b.title("free", "Free shaft", "Nothing but the inertia.");
}

void Describe<BrakeLoad>::fields(schema::Builder<BrakeLoad>& b) {
  b.title("brake", "Brake", "A constant torque against the rotation.");
  b.number("torque", &BrakeLoad::torque, "Torque", "Q", "N*m")
      .range(schema::atLeast(0), schema::upTo(1e4));
}

void Describe<PropellerLoad>::fields(schema::Builder<PropellerLoad>& b) {
  using P = PropellerLoad;
  const char* source = "JSBSim aircraft F450, engine/DJI_9450.xml";
  b.title(
      "propeller", "Propeller at rest",
      "A propeller in still air: T = CT rho n^2 D^4, P = CP rho n^3 D^5, n in turns per second.");
  b.number("thrustCoefficient", &P::thrustCoefficient, "Thrust coefficient", "C_T", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .source(source);
  b.number("powerCoefficient", &P::powerCoefficient, "Power coefficient", "C_P", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .source(source);
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(20))
      .shownIn("in")
      .source(source);
  b.number("airDensity", &P::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(schema::atLeast(0), schema::upTo(10))
      .source("International standard atmosphere at sea level");
}

void Describe<BladeElementLoad>::fields(schema::Builder<BladeElementLoad>& b) {
  using P = BladeElementLoad;
  b.title("blade-element", "Propeller by blade elements",
          "A propeller in still air from its geometry and sections; its coefficients change with "
          "the speed.");
  b.group("propeller", &P::propeller, "Propeller");
  b.number("airDensity", &P::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(schema::atLeast(0), schema::upTo(10))
      .source("International standard atmosphere at sea level");
  b.number("airViscosity", &P::airViscosity, "Air viscosity", "\u03bc", "Pa*s")
      .range(schema::atLeast(1e-7), schema::upTo(1))
      .source("Sutherland's law at 15 degrees Celsius")
      .advanced();
  b.group("settings", &P::settings, "Blade elements");
}

void Describe<DriveStand>::fields(schema::Builder<DriveStand>& b) {
  using P = DriveStand;
  b.title("drive-stand", "Drive on a stand",
          "Supply, speed controller, motor and load as they are coupled in a vehicle.",
          "Thesis 2014, figure 3.11");
  b.variant("supply", &P::supply, "Supply");
  b.group("esc", &P::esc, "Speed controller (ESC)");
  b.group("motor", &P::motor, "Motor");
  b.variant("load", &P::load, "Load");
  b.number("inertia", &P::inertia, "Inertia", "J", "kg*m^2")
      .range(schema::above(0), schema::upTo(1e3))
      .help("Of all that spins: rotor of the motor and propeller.")
      .source("JSBSim aircraft F450, engine/DJI_9450.xml: propeller");
  b.boolean("quasiStaticCurrent", &P::quasiStaticCurrent, "Quasi-static current")
      .help(
          "Takes the inductance as zero: the current follows at once. Exact in the steady state, "
          "late by L/R "
          "otherwise; allows steps far above L/R.")
      .advanced();
}

void Describe<DriveRunSettings>::fields(schema::Builder<DriveRunSettings>& b) {
  using P = DriveRunSettings;
  b.title("drive-run", "Run", "How long and how finely.");
  b.group("solver", &P::solver, "Solver");
  b.number("tick", &P::tick, "Tick", "", "s")
      .range(schema::atLeast(1e-6), schema::upTo(1))
      .shownIn("ms")
      .help("The throttle is held for this long, and the solver ends a step at its end.");
  b.number("duration", &P::duration, "Duration", "T", "s")
      .range(schema::above(0), schema::upTo(36000));
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (p.tick > p.duration)
      problems.push_back({"tick", "is longer than the run", "at most the duration"});
    checkDriveMethod(p.solver, problems);
  });
}

}  // namespace rotorbench
