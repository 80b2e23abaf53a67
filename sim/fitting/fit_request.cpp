#include "sim/fitting/fit_request.h"

#include "sim/core/number_text.h"

namespace rotorbench {

MotorFitSetup setupOf(const MotorFitRequest& request, const FitStart& start) {
  MotorFitSetup setup;
  setup.start = start.motor;
  setup.escResistance = start.escResistance;
  setup.torque = request.torque;
  setup.torqueCoefficient = start.torqueCoefficient;
  setup.torqueCoefficientIsGuess = start.coefficientsAreGuesses;
  setup.torquePerThrust = request.torquePerThrust;
  setup.duty = request.duty;
  setup.fitSpeedConstant = request.speedConstant;
  setup.fitResistance = request.resistance;
  setup.fitNoLoadCurrent = request.noLoadCurrent;
  setup.fitViscousShare = request.viscousShare;
  setup.fitTorqueCoefficient = request.torqueCoefficient;
  return setup;
}

PropellerFitSetup setupOf(const PropellerFitRequest& request, const FitStart& start) {
  PropellerFitSetup setup;
  setup.start = start.propeller;
  setup.settings = start.settings;
  setup.air.density = request.airDensity;
  setup.speed = request.speed;
  setup.fitTwistOffset = request.twistOffset;
  setup.fitDrag = request.drag;
  return setup;
}

RotorFitSetup setupOf(const RotorFitRequest& request, const FitStart& start) {
  RotorFitSetup setup;
  setup.thrustStart = start.thrustCoefficient;
  setup.torqueStart = start.torqueCoefficient;
  setup.startsAreGuesses = start.coefficientsAreGuesses;
  setup.fitThrust = request.thrust;
  setup.fitTorque = request.torque;
  setup.rotors = request.rotors;
  return setup;
}

namespace {

/// A; 0 where none is given and the experiment has none.
double limitOf(const LimitedRows& limited, const FitStart& start) {
  return limited.currentLimit > 0 ? limited.currentLimit : start.currentLimit;
}

/// The setup of a motor fit that leaves out the limited rows, whether it is asked to or not.
MotorFitSetup limitedSetup(const MotorFitRequest& request, const LimitedRows& limited,
                           const FitStart& start) {
  MotorFitSetup setup = setupOf(request, start);
  setup.currentLimit = limitOf(limited, start);
  setup.nearLimit = limited.nearLimit;
  return setup;
}

MotorFitSetup motorSetup(const MotorFitRequest& request, const LimitedRows& limited,
                         const FitStart& start) {
  return limited.leaveOut ? limitedSetup(request, limited, start) : setupOf(request, start);
}

struct Missing {
  const MeasuredTable& table;
  const FitStart& start;
  const LimitedRows& limited;
  std::vector<std::string> operator()(const MotorFitRequest& r) const {
    std::vector<std::string> missing = missingForMotorFit(table, motorSetup(r, limited, start));
    if (limited.leaveOut && !(limitOf(limited, start) > 0)) {
      missing.emplace_back("The experiment has no current limit; give the one of the stand.");
    }
    return missing;
  }
  std::vector<std::string> operator()(const PropellerFitRequest& r) const {
    return missingForPropellerFit(table, setupOf(r, start));
  }
  std::vector<std::string> operator()(const RotorFitRequest& r) const {
    return missingForRotorFit(table, setupOf(r, start));
  }
};

struct ProblemOf {
  const MeasuredTable& table;
  const FitStart& start;
  const LimitedRows& limited;
  FitProblem operator()(const MotorFitRequest& r) const {
    return motorFitProblem(table, motorSetup(r, limited, start));
  }
  FitProblem operator()(const PropellerFitRequest& r) const {
    return propellerFitProblem(table, setupOf(r, start));
  }
  FitProblem operator()(const RotorFitRequest& r) const {
    return rotorFitProblem(table, setupOf(r, start));
  }
};

}  // namespace

std::vector<std::string> missingFor(const FitRequest& request, const MeasuredTable& table,
                                    const FitStart& start) {
  return std::visit(Missing{table, start, request.limited}, request.what);
}

std::string limitedRowsText(const FitRequest& request, const MeasuredTable& table,
                            const FitStart& start) {
  const auto* motor = std::get_if<MotorFitRequest>(&request.what);
  if (motor == nullptr) return {};
  const MotorFitSetup setup = limitedSetup(*motor, request.limited, start);
  if (!(setup.currentLimit > 0) || !missingForMotorFit(table, setupOf(*motor, start)).empty())
    return {};
  const MotorFitRows rows = motorFitRows(table, setup);
  const bool leaveOut = request.limited.leaveOut;
  if (rows.limited == 0 && !leaveOut) return {};
  return std::to_string(rows.limited) + " of " + std::to_string(rows.used + rows.limited) +
         " rows " + (leaveOut ? "are left out" : "could be left out") +
         ": they are at or near the current limit of " + numberText(setup.currentLimit) + " A.";
}

std::string dutyText(const FitRequest& request, const MeasuredTable& table, const FitStart& start) {
  const auto* motor = std::get_if<MotorFitRequest>(&request.what);
  return motor == nullptr ? std::string()
                          : motorDutyText(table, motorSetup(*motor, request.limited, start));
}

FitProblem problemOf(const FitRequest& request, const MeasuredTable& table, const FitStart& start) {
  return std::visit(ProblemOf{table, start, request.limited}, request.what);
}

void Describe<MotorFitRequest>::fields(schema::Builder<MotorFitRequest>& b) {
  using R = MotorFitRequest;
  b.title("motor-fit", "Motor constants",
          "From supply voltage and current, speed and, where it is known, throttle, in steady "
          "states.");
  b.boolean("speedConstant", &R::speedConstant, "Fit the speed constant");
  b.boolean("resistance", &R::resistance, "Fit the resistance");
  b.boolean("noLoadCurrent", &R::noLoadCurrent, "Fit the no-load current");
  b.boolean("viscousShare", &R::viscousShare, "Fit the viscous share of friction");
  b.boolean("torqueCoefficient", &R::torqueCoefficient, "Fit the torque coefficient")
      .help("k_m of the propeller, where the torque of the load is taken from it.");
  b.choice("torque", &R::torque, "Torque of the load",
           std::vector<schema::Named<ShaftTorque>>{
               {ShaftTorque::Propeller, "propeller", "k_m times speed squared",
                "A propeller at rest in the air."},
               {ShaftTorque::Measured, "measured", "Measured", "The torque column."},
               {ShaftTorque::FromThrust, "from-thrust", "From the thrust",
                "Thrust times torque per thrust."},
               {ShaftTorque::None, "none", "None", "Nothing on the shaft."}});
  b.number("torquePerThrust", &R::torquePerThrust, "Torque per thrust", "\u03ba", "m")
      .range(schema::atLeast(0), schema::upTo(10))
      .help("k_m/k_f, used where the torque is taken from the thrust.");
  b.choice("duty", &R::duty, "Duty",
           std::vector<schema::Named<DutyFrom>>{
               {DutyFrom::Automatic, "automatic", "The throttle, if it can be",
                "The throttle, unless the motor turns as fast with much less of it: then 1 at full "
                "throttle, else unknown."},
               {DutyFrom::Throttle, "throttle", "The throttle",
                "A speed controller whose duty is the throttle."},
               {DutyFrom::FullThrottle, "full-throttle", "1 at full throttle, else unknown",
                "A speed controller with a curve of its own."},
               {DutyFrom::Unknown, "unknown", "Unknown", "Found from the speed in each row."}});
}

void Describe<PropellerFitRequest>::fields(schema::Builder<PropellerFitRequest>& b) {
  using R = PropellerFitRequest;
  b.title(
      "propeller-fit", "Propeller: twist offset and drag",
      "From thrust and power coefficients, or thrust and torque, at rest or in flight, by blade "
      "elements.");
  b.boolean("twistOffset", &R::twistOffset, "Fit the twist offset");
  b.boolean("drag", &R::drag, "Fit the drag")
      .help("A factor on the profile drag of every analytic section.");
  b.number("speed", &R::speed, "Rotor speed", "\u03a9", "rad/s")
      .range(schema::atLeast(0), schema::upTo(1e5))
      .shownIn("rpm")
      .help("Used where the data have no speed.");
  b.number("airDensity", &R::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(schema::above(0), schema::upTo(100))
      .help("In which was measured.");
}

void Describe<RotorFitRequest>::fields(schema::Builder<RotorFitRequest>& b) {
  using R = RotorFitRequest;
  b.title("rotor-fit", "Lumped rotor coefficients",
          "k_f and k_m: thrust and torque over the square of the speed, at rest in the air.");
  b.boolean("thrust", &R::thrust, "Fit the thrust coefficient");
  b.boolean("torque", &R::torque, "Fit the torque coefficient");
  b.integer("rotors", &R::rotors, "Rotors measured together", "N")
      .range(schema::atLeast(1), schema::upTo(100))
      .help("The thrust and torque columns are the sum of so many.");
  b.number("airDensity", &R::airDensity, "Air density", "\u03c1", "kg/m^3")
      .range(schema::above(0), schema::upTo(100))
      .help("In which was measured.");
}

void Describe<LimitedRows>::fields(schema::Builder<LimitedRows>& b) {
  using R = LimitedRows;
  b.title("limited-rows", "Rows at the current limit",
          "There a motor gets less than the throttle asks for. For motor constants only.");
  b.boolean("leaveOut", &R::leaveOut, "Leave them out");
  b.number("currentLimit", &R::currentLimit, "Current limit", "i_max", "A")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .help(
          "Of the motor current. 0: the smaller one of the experiment's motor and speed "
          "controller.");
  b.number("nearLimit", &R::nearLimit, "Near the limit from", "", "1")
      .range(schema::above(0), schema::upTo(1))
      .shownIn("%")
      .help("Part of the limit from which a row, and all of more throttle, are left out.");
}

void Describe<FitRequest>::fields(schema::Builder<FitRequest>& b) {
  b.title("fit", "Fit", "What is to be found from the measured data.",
          "Seber, Wild, Nonlinear Regression, 1989; Ceres Solver");
  b.variant("what", &FitRequest::what, "Fit");
  b.boolean("robust", &FitRequest::robust, "Outliers count less")
      .help("Beyond two sigma a residual counts linearly instead of squared.");
  b.group("limited", &FitRequest::limited, "Rows at the current limit");
}

}  // namespace rotorbench
