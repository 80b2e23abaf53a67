#include "sim/document/drive_stand.h"

namespace rotorbench {

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
  b.title(
      "propeller", "Propeller at rest",
      "A propeller in still air: T = CT rho n^2 D^4, P = CP rho n^3 D^5, n in turns per second.");
  b.standsAlone();
  b.number("thrustCoefficient", &P::thrustCoefficient, "Thrust coefficient", "C_T", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .required();
  b.number("powerCoefficient", &P::powerCoefficient, "Power coefficient", "C_P", "1")
      .range(schema::atLeast(0), schema::upTo(1))
      .required();
  b.number("diameter", &P::diameter, "Diameter", "D", "m")
      .range(schema::above(0), schema::upTo(20))
      .shownIn("in")
      .required();
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
  b.check([](const P& p, std::vector<Problem>& problems) {
    const EscParameters& esc = p.esc;
    if (p.quasiStaticCurrent &&
        (esc.pwmFrequency > 0 || esc.switchingLoss > 0 || esc.leadResistance > 0)) {
      problems.push_back({"quasiStaticCurrent", "leaves out the losses the speed controller states",
                          "false, or esc.pwmFrequency, switchingLoss and leadResistance 0"});
    }
  });
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

void checkDriveMethod(const ode::SolverSettings& solver, std::vector<Problem>& problems) {
  if (solver.method != ode::Method::ExponentialRk4) return;
  problems.push_back({"solver.method", "Exponential RK4 is made for the motors of a vehicle",
                      "choose another method, or quasi-static current"});
}

}  // namespace rotorbench
