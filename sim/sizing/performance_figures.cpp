#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/environment/standard_atmosphere.h"
#include "sim/numerics/scalar_search.h"
#include "sim/run/vehicle_doubts.h"
#include "sim/sizing/data_sheet_figures.h"
#include "sim/sizing/discharge.h"
#include "sim/sizing/performance.h"

namespace rotorbench {

namespace {

/// What all groups of figures are read from.
struct Flown {
  const VehicleParameters& vehicle;
  const SteadyFlight& flight;
  const PerformanceSettings& settings;
  FullThrottle full;
  std::optional<Trim> hover;
  AirResistance resistance{};
  DriveDemand demand{};
  double bus = kNoFigure;                  ///< V under the hover's load
  Margin margin{-1, FlightLimit::NoTrim};  ///< of the hover at the largest throttle
};

Sentence percent(double share) {
  return Sentence::number(100 * share) + " %";
}

/// "limited by ..." for a state at the edge of what the vehicle can do.
Sentence limitSentence(FlightLimit limit, const Flown& f, double throttle) {
  const Supply& supply = f.flight.supply();
  switch (limit) {
    case FlightLimit::Throttle:
      return "limited by the supply's voltage under load: a rotor needs " + percent(throttle) +
             " throttle";
    case FlightLimit::Current: {
      double least = f.flight.currentLimit(0);
      for (int i = 1; i < f.flight.rotors(); ++i) least = std::min(least, f.flight.currentLimit(i));
      return "limited by the motor's current limit of " + Sentence::number(least) + " A";
    }
    case FlightLimit::Supply:
      return "limited by the supply: its internal resistance lets it give no more power";
    case FlightLimit::CutOff:
      return "limited by the battery: its voltage under load reaches the cut-off of " +
             Sentence::number(supply.cutOff) + " V";
    case FlightLimit::Tilt:
      return "limited by the tilt of " +
             Sentence::number(f.settings.tiltLimit * 180 / std::numbers::pi) + " degrees";
    case FlightLimit::Model:
      return Sentence("at least this: beyond it the air speed is above ") +
             Sentence::number(kMostAdvance) +
             " of the blade tips' and no rotor "
             "model here holds; neither drag nor throttle limits the vehicle before";
    case FlightLimit::NoTrim:
      return "limited by the rotors' inflow: no rotor speeds balance force and moment beyond it";
    case FlightLimit::None:
      return {};
  }
  return {};
}

void addThrust(FigureSheet& sheet, const Flown& f) {
  FigureGroup g(sheet, "thrust", "Thrust");
  g.add("weight", "Weight", "m g", f.flight.weight(), "N", "N", "total mass times gravity");
  g.add("most", "Largest thrust", "T_max", f.full.thrust, "N", "N",
        "all rotors at full throttle at rest, full battery");
  g.add("toWeight", "Thrust to weight", "T/W", f.full.thrust / f.flight.weight(), "1", "1",
        "T_max/(m g)")
      .note = f.full.currentLimited
                  ? "limited by a motor's current limit of " +
                        Sentence::number(f.full.currents.maxCoeff()) + " A"
                  : "limited by the supply's voltage: " + Sentence::number(f.full.openCircuit) +
                        " V fall to " + Sentence::number(f.full.busVoltage) + " V under " +
                        Sentence::number(f.full.current) + " A";
  g.add("current", "Current at full throttle", "I_max", f.full.current, "A", "A",
        "of all motors, from the supply");
  g.add("power", "Power at full throttle", "P_max", f.full.power, "W", "W",
        "voltage under load times current");
}

void addHover(FigureSheet& sheet, const Flown& f) {
  FigureGroup g(sheet, "hover", "Hover");
  const Sentence none = f.hover ? limitSentence(f.margin.limit, f, 1)
                                : "the rotors cannot hold the vehicle in balance";
  const bool flies = f.hover && f.margin.value >= 0;
  const auto orNone = [flies](double value) { return flies ? value : kNoFigure; };
  const double mean = flies ? f.hover->rotors().mean() : kNoFigure;
  const Sentence spread =
      !flies ? "the vehicle cannot hover: " + none
      : f.hover->rotors().maxCoeff() - f.hover->rotors().minCoeff() > 1e-6 * mean
          ? "mean; the rotors differ to balance the vehicle"
          : Sentence();
  const double current = f.demand.power / f.bus;
  const double inner = f.flight.supply().openCircuit(f.flight.supply().charge);
  double ideal = 0, thrust = 0;
  for (int i = 0; flies && i < f.flight.rotors(); ++i) {
    const double t = f.hover->thrust[i];
    ideal += figureOfMerit(t, 1, f.flight.radius(i), f.flight.density());
    thrust += t;
  }
  g.add("speed", "Rotor speed", "\u03a9_h", mean, "rad/s", "rpm",
        "thrusts balance weight and moments")
      .note = spread;
  g.add("throttle", "Throttle", "d_h", orNone(f.demand.voltage.maxCoeff() / f.bus), "1", "%",
        "motor voltage over the supply's voltage under load, largest of all rotors");
  g.add("current", "Current per motor", "i_h", orNone(f.demand.current.mean()), "A", "A",
        "(Q + friction)/K_t");
  g.add("totalCurrent", "Current from the supply", "I_h", orNone(current), "A", "A",
        "power over voltage under load");
  g.add("voltage", "Voltage under load", "V_h", orNone(f.bus), "V", "V",
        "open-circuit voltage - R\u2080 I_h");
  g.add("power", "Electrical power", "P_h", orNone(f.demand.power), "W", "W", "V_h I_h");
  g.add("shaftPower", "Shaft power", "P_s", orNone(f.demand.shaftPower), "W", "W",
        "sum of Q \u03a9");
  g.add("thrustPerPower", "Thrust per power", "T/P", orNone(thrust / f.demand.power), "N/W", "gf/W",
        "sum of thrusts over electrical power");

  FigureGroup e(sheet, "efficiency", "Efficiency in hover");
  e.add("battery", "Battery", "\u03b7_b", orNone(f.bus / inner), "1", "%",
        "voltage under load over open-circuit voltage");
  e.add("esc", "Speed controllers", "\u03b7_esc", orNone(f.demand.motorPower / f.demand.power), "1",
        "%", "power at the motors over power from the supply");
  e.add("motor", "Motors", "\u03b7_m", orNone(f.demand.shaftPower / f.demand.motorPower), "1", "%",
        "shaft power over power at the motors");
  e.add("propeller", "Propellers (figure of merit)", "FM", orNone(ideal / f.demand.shaftPower), "1",
        "%", "sum of T^(3/2)/\u221a(2 \u03c1 A) over shaft power");
  e.add("total", "All", "\u03b7", orNone(ideal / f.demand.power * f.bus / inner), "1", "%",
        "ideal induced power over the power from the cells");
}

/// A flight at constant power until the reserve is left.
Discharge flightUntilReserve(const Flown& f, const Trim& trim, ConstantLoad& load) {
  const DriveDemand demand = f.flight.demand(trim);
  load = {demand.power, demand.voltage.maxCoeff(), f.settings.reserveCharge};
  return discharge(f.flight.supply(), load);
}

void addEndurance(FigureSheet& sheet, const Flown& f) {
  FigureGroup g(sheet, "endurance", "Endurance");
  const char* formula =
      "discharge at constant power with open-circuit voltage, resistance and polarisation";
  if (!f.hover || f.margin.value < 0) {
    g.add("hover", "Hover", "t_h", kNoFigure, "s", "min", formula).note =
        "the vehicle cannot hover";
    return;
  }
  ConstantLoad load;
  const Discharge run = flightUntilReserve(f, *f.hover, load);
  const bool endless = run.end == DischargeEnd::Never;
  const Sentence reason = reasonOf(run.end, f.flight.supply(), load);
  g.add("hover", "Hover", "t_h", endless ? kNoFigure : run.time, "s", "min", formula).note =
      endless ? reason : "ends when " + reason;
}

void addPayload(FigureSheet& sheet, const Flown& f) {
  FigureGroup g(sheet, "payload", "Payload");
  const double throttle = f.settings.payloadThrottle;
  const double own = f.flight.mass();
  FlightLimit limit = FlightLimit::NoTrim;
  const auto margin = [&](double mass) {
    const SteadyFlight heavier = f.flight.withMass(mass);
    const auto hover = heavier.hover();
    const Margin m = hover ? marginOf(heavier, *hover, throttle, f.settings.tiltLimit)
                           : Margin{-1, FlightLimit::NoTrim};
    limit = m.limit;
    return m.value;
  };
  const char* formula = "mass at the centre of mass with which it hovers at the throttle allowed";
  const double now = margin(own);
  if (!(now >= 0)) {
    g.add("most", "Largest payload", "m_p", 0, "kg", "g", formula).note =
        "none: the hover alone is " + limitSentence(limit, f, throttle);
    return;
  }
  double high = 2 * own;
  while (margin(high) > 0 && high < 1e3 * own) high *= 2;
  const double top = margin(high);
  const double most = top >= 0 ? high : findRoot(margin, own, now, high, top, 1e-9 * own);
  margin(most * (1 + 1e-6));
  g.add("most", "Largest payload", "m_p", most - own, "kg", "g", formula).note =
      limitSentence(limit, f, throttle);
}

void addLevelFlight(FigureSheet& sheet, const Flown& f) {
  FigureGroup g(sheet, "level", "Level flight");
  const char* fastest = "largest speed with a balance of force and moment inside the limits";
  if (!f.hover ||
      marginOf(f.flight, *f.hover, f.settings.speedThrottle, f.settings.tiltLimit).value < 0) {
    g.add("speed", "Fastest", "v_max", kNoFigure, "m/s", "m/s", fastest).note =
        "the vehicle cannot hover";
    return;
  }
  const LevelFlight level = levelFlight(f.flight, *f.hover, f.settings);
  g.add("speed", "Fastest", "v_max", level.fastest.speed, "m/s", "m/s", fastest).note =
      limitSentence(level.limit, f, f.settings.speedThrottle);
  g.add("tilt", "Tilt", "\u03b8", level.fastest.tilt(), "rad", "deg", "of the fastest flight");
  g.add("power", "Electrical power", "P", f.flight.demand(level.fastest).power, "W", "W",
        "of the fastest flight");
  ConstantLoad load;
  const Discharge run = flightUntilReserve(f, level.farthest, load);
  const bool endless = run.end == DischargeEnd::Never;
  const Sentence reason = reasonOf(run.end, f.flight.supply(), load);
  g.add("bestSpeed", "Speed of longest range", "v_r", level.farthest.speed, "m/s", "m/s",
        "least electrical power per speed")
      .note = level.farthest.speed >= level.fastest.speed * (1 - 1e-6)
                  ? "power per speed still falls at the fastest flight"
                  : Sentence();
  g.add("range", "Range in still air", "s_r", endless ? kNoFigure : run.time * level.farthest.speed,
        "m", "km", "that speed times the time the battery lasts")
      .note = endless ? reason : "ends when " + reason;
}

void addCeiling(FigureSheet& sheet, const Flown& f) {
  FigureGroup g(sheet, "ceiling", "Ceiling");
  const char* formula =
      "altitude in the standard atmosphere in whose air the hover reaches the throttle allowed";
  FlightLimit limit = FlightLimit::NoTrim;
  const auto margin = [&](double density) {
    const SteadyFlight thinner = f.flight.withDensity(density);
    const auto hover = thinner.hover();
    const Margin m = hover
                         ? marginOf(thinner, *hover, f.settings.speedThrottle, f.settings.tiltLimit)
                         : Margin{-1, FlightLimit::NoTrim};
    limit = m.limit;
    return m.value;
  };
  // The search ends at the tropopause.
  const double sea = standardDensity(0.0), top = standardAltitude(standardTropopause());
  const double here = margin(sea), least = standardTropopause();
  if (!(here >= 0)) {
    g.add("hover", "Hover ceiling", "h_max", kNoFigure, "m", "m", formula).note =
        "it cannot hover in the standard atmosphere at sea level";
    return;
  }
  const double thin = margin(least);
  if (thin >= 0) {
    g.add("hover", "Hover ceiling", "h_max", top, "m", "m", formula).note =
        "at least this; the search ends at the tropopause";
    return;
  }
  const double density = findRoot(margin, least, thin, sea, here, 1e-9);
  margin(density * (1 - 1e-6));
  g.add("hover", "Hover ceiling", "h_max", standardAltitude(density), "m", "m", formula).note =
      limitSentence(limit, f, f.settings.speedThrottle);
}

void addWarnings(FigureSheet& sheet, const Flown& f) {
  if (!f.hover) {
    sheet.warnings.emplace_back("The rotors cannot hold the vehicle in balance.");
  } else if (f.margin.value < 0) {
    sheet.warnings.push_back("The vehicle cannot hover: " + limitSentence(f.margin.limit, f, 1) +
                             ".");
  } else if (f.full.thrust < 1.5 * f.flight.weight()) {
    sheet.warnings.push_back("Full throttle gives only " +
                             Sentence::number(f.full.thrust / f.flight.weight()) +
                             " of the weight; little is left for control and gusts.");
  }
  for (const Problem& doubt : vehicleDoubts(f.vehicle))
    sheet.warnings.emplace_back(doubt.message());
  const double merit = f.hover ? sheet.at("efficiency.propeller").value : kNoFigure;
  if (merit > 1) {
    sheet.warnings.push_back(
        "The propellers would have a figure of merit of " + Sentence::number(merit) +
        "; above 1 no propeller can be, so thrust, torque or diameter is wrong.");
  }
}

}  // namespace

FigureSheet performanceSheet(const VehicleParameters& vehicle,
                             const EnvironmentParameters& environment,
                             const PerformanceSettings& settings) {
  const SteadyFlight flight(vehicle, environment);
  Flown f{
      vehicle, flight, settings, flight.fullThrottle(), flight.hover(), airResistanceOf(vehicle)};
  if (f.hover) {
    f.demand = flight.demand(*f.hover);
    const Supply& supply = flight.supply();
    f.bus = voltageUnder(f.demand.power, supply.openCircuit(supply.charge), supply.resistance);
    f.margin = marginOf(flight, *f.hover, 1, settings.tiltLimit);
  }
  FigureSheet sheet;
  addThrust(sheet, f);
  addHover(sheet, f);
  addEndurance(sheet, f);
  addPayload(sheet, f);
  addLevelFlight(sheet, f);
  addCeiling(sheet, f);
  addWarnings(sheet, f);
  return sheet;
}

}  // namespace rotorbench
