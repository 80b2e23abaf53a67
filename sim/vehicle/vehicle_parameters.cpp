#include "sim/vehicle/vehicle_parameters.h"

#include <string>

namespace rotorbench {

namespace {

std::string numbered(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

bool fitting(const VehicleParameters& vehicle) {
  const auto* own = std::get_if<IndividualRotors>(&vehicle.rotors);
  const auto count = static_cast<std::size_t>(rotorCount(vehicle.layout));
  return own == nullptr || own->rotors.empty() || count == 0 || own->rotors.size() == count;
}

/// What is wrong with the number of rotors, or empty.
std::vector<Problem> countProblems(const VehicleParameters& vehicle) {
  std::vector<Problem> problems;
  const auto count = static_cast<std::size_t>(rotorCount(vehicle.layout));
  const std::string allowed = std::to_string(count) + " rotors, as the layout has";
  if (count != 4 && count != 6 && count != 8) {
    problems.push_back(
        {"layout.rotors", "the layout has " + std::to_string(count), "4, 6 or 8 rotors"});
  }
  if (const auto* own = std::get_if<IndividualRotors>(&vehicle.rotors);
      own != nullptr && own->rotors.size() != count) {
    problems.push_back(
        {"rotors.rotors", "there are " + std::to_string(own->rotors.size()), allowed});
  }
  for (std::size_t k = 0; k < vehicle.deviations.size(); ++k) {
    const int rotor = vehicle.deviations[k].rotor;
    if (rotor < 1 || static_cast<std::size_t>(rotor) > count) {
      problems.push_back({numbered("deviations", k) + ".rotor",
                          "there is no rotor " + std::to_string(rotor),
                          "1 to " + std::to_string(count)});
    }
  }
  return problems;
}

MassProperties withoutCheck(const VehicleParameters& vehicle, bool asPlanned) {
  const std::vector<RotorAtHub> planned = rotorsOf(vehicle, true);
  const std::vector<RotorAtHub> actual = asPlanned ? planned : rotorsOf(vehicle);
  MassProperties sum;
  if (const auto* direct = std::get_if<DirectMass>(&vehicle.mass)) {
    sum = {direct->mass, direct->centreOfMass, direct->inertia.matrix()};
  } else {
    const auto& parts = std::get<PartsMass>(vehicle.mass);
    const double sphere = 0.4 * parts.bodyMass * parts.bodyRadius * parts.bodyRadius;  // (3.7)
    sum = {parts.bodyMass, parts.bodyPosition, sphere * Eigen::Matrix3d::Identity()};
    for (const auto& hub : planned) {
      sum = withPointMass(sum, hub.rotor.mass, hub.placement.position);
    }
  }
  for (const auto& load : vehicle.payloads) sum = withPointMass(sum, load.mass, load.position);
  for (std::size_t i = 0; i < planned.size(); ++i) {
    if (actual[i].placement == planned[i].placement &&
        actual[i].rotor.mass == planned[i].rotor.mass)
      continue;
    sum = withPointMass(sum, actual[i].rotor.mass, actual[i].placement.position);
    sum = withPointMass(sum, -planned[i].rotor.mass, planned[i].placement.position);
  }
  return sum;
}

}  // namespace

std::vector<RotorAtHub> rotorsOf(const VehicleParameters& vehicle, bool asPlanned) {
  auto problems = countProblems(vehicle);
  if (!problems.empty()) throw InputError({}, std::move(problems));
  std::vector<RotorAtHub> hubs;
  for (const auto& placement : placeRotors(vehicle.layout)) {
    const auto* equal = std::get_if<EqualRotors>(&vehicle.rotors);
    hubs.push_back(
        {placement, equal != nullptr
                        ? equal->rotor
                        : std::get<IndividualRotors>(vehicle.rotors).rotors[hubs.size()]});
  }
  if (!asPlanned) {
    for (const auto& deviation : vehicle.deviations) {
      auto& hub = hubs[static_cast<std::size_t>(deviation.rotor - 1)];
      hub.placement.position += deviation.position;
      hub.rotor.mass += deviation.mass;
    }
  }
  return hubs;
}

MassProperties massOf(const VehicleParameters& vehicle, bool asPlanned) {
  MassProperties sum = withoutCheck(vehicle, asPlanned);
  auto problems = massProblems(sum, "mass");
  std::erase_if(problems, [](const Problem& p) { return p.warning; });
  if (!problems.empty()) throw InputError({}, std::move(problems));
  return sum;
}

std::string AirResistance::missing() const {
  const char* braked = "nothing that brakes a level flight";
  const char* thrust = "no loss of the rotors' thrust in climb";
  if (!level && !climb) return std::string(braked) + " and " + thrust;
  return !level ? braked : !climb ? thrust : "";
}

AirResistance airResistanceOf(const VehicleParameters& vehicle) {
  bool lumped = true, dragging = true, losing = true;
  const auto consider = [&](const RotorParameters& rotor) {
    std::visit(
        [&](const auto& a) {
          if constexpr (requires { a.inflow.drag; }) {
            dragging &= a.inflow.drag > 0;
            losing &= a.inflow.inflow > 0;
          } else {
            lumped = false;
          }
        },
        rotor.aerodynamics);
  };
  if (const auto* equal = std::get_if<EqualRotors>(&vehicle.rotors)) {
    consider(equal->rotor);
  } else {
    for (const auto& rotor : std::get<IndividualRotors>(vehicle.rotors).rotors) consider(rotor);
  }
  const bool body = vehicle.drag.linear > 0 || vehicle.drag.quadratic.head<2>().minCoeff() > 0;
  return {.level = body || (lumped && dragging), .climb = losing};
}

void Describe<EqualRotors>::fields(schema::Builder<EqualRotors>& b) {
  b.title("equal", "All alike", "One description for all rotors.");
  b.group("rotor", &EqualRotors::rotor, "Rotor");
}

void Describe<IndividualRotors>::fields(schema::Builder<IndividualRotors>& b) {
  b.title("individual", "Each its own",
          "A description for every rotor, in the order of their numbers.");
  b.list("rotors", &IndividualRotors::rotors, "Rotors").items(4, 8);
}

void Describe<RotorDeviation>::fields(schema::Builder<RotorDeviation>& b) {
  using P = RotorDeviation;
  b.title("deviation", "Deviation",
          "How one arm or motor differs from the plan. The controller does not know of it.",
          "Thesis 2014, nomenclature: \u0394r_i, \u0394m_i");
  b.integer("rotor", &P::rotor, "Rotor")
      .range(schema::atLeast(1), schema::upTo(8))
      .help("Its number.");
  b.vector("position", &P::position, "Displacement", "\u0394r", "m")
      .range(schema::atLeast(-10), schema::upTo(10))
      .help("Added to the place of the hub: x forward, y left, z up.");
  b.number("mass", &P::mass, "Additional mass", "\u0394m", "kg")
      .range(schema::atLeast(-100), schema::upTo(100))
      .shownIn("g")
      .help("Added to the point mass at the hub.");
}

void Describe<BodyDrag>::fields(schema::Builder<BodyDrag>& b) {
  using P = BodyDrag;
  b.title("drag", "Body drag", "Resistance of the body against the air, at the centre of mass.");
  b.standsAlone();
  b.number("linear", &P::linear, "Linear drag", "D", "N*s/m")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .help("Force per speed, against the motion.")
      .source("None unless given; thesis 2014, (3.18)");
  b.vector("quadratic", &P::quadratic, "Quadratic drag", "c", "N*s^2/m^2")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .help("Along each body axis: c times speed times the velocity along the axis.")
      .source("RotorPy, vehicles/multirotor.py (drag matrix)");
  b.vector("angular", &P::angular, "Angular drag", "d", "N*m*s")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .help("Moment per body rate, against the rotation.")
      .advanced();
}

void Describe<VehicleParameters>::fields(schema::Builder<VehicleParameters>& b) {
  using P = VehicleParameters;
  b.title(
      "multirotor", "Multirotor",
      "A rigid body with four, six or eight rotors: Newton-Euler equations with the momentum of "
      "the rotors.",
      "Mahony, Kumar, Corke, Multirotor Aerial Vehicles, IEEE RAM 2012");
  b.variant("layout", &P::layout, "Layout");
  b.variant("rotors", &P::rotors, "Rotors");
  b.variant("mass", &P::mass, "Mass properties");
  b.list("payloads", &P::payloads, "Payloads").items(0, 100).table();
  b.list("deviations", &P::deviations, "Deviations").items(0, 100).table();
  b.group("drag", &P::drag, "Body drag");
  b.variant("supply", &P::supply, "Supply").untyped();
  b.number("avionicsPower", &P::avionicsPower, "Power of the avionics", "P_a", "W")
      .range(schema::atLeast(0), schema::upTo(1e5))
      .help(
          "Flight controller, radio, camera: a constant power drawn from the supply besides the "
          "motors.")
      .source("None unless given");
  b.follows("rotors", fitting, [](P& p) {
    auto& own = std::get<IndividualRotors>(p.rotors).rotors;
    own.resize(static_cast<std::size_t>(rotorCount(p.layout)), own.back());
  });
  b.check([](const P& p, std::vector<Problem>& problems) {
    auto found = countProblems(p);
    if (found.empty()) {
      found = massProblems(withoutCheck(p, false), "mass");
      // The tensor that is given has said it already.
      if (std::holds_alternative<DirectMass>(p.mass))
        std::erase_if(found, [](const Problem& problem) { return problem.warning; });
    }
    problems.insert(problems.end(), found.begin(), found.end());
  });
}

void Describe<FlightStart>::fields(schema::Builder<FlightStart>& b) {
  using P = FlightStart;
  b.title("start", "Start",
          "Motion of the centre of mass and speed of the rotors when the flight begins.");
  b.vector("position", &P::position, "Position", "p", "m")
      .range(schema::atLeast(-1e5), schema::upTo(1e5));
  b.vector("velocity", &P::velocity, "Velocity", "v", "m/s")
      .range(schema::atLeast(-1000), schema::upTo(1000));
  b.vector("attitude", &P::attitude, "Attitude", "\u03c6\u03b8\u03c8", "rad")
      .range(schema::atLeast(-7), schema::upTo(7))
      .shownIn("deg")
      .components({"roll", "pitch", "yaw"})
      .help("Roll, pitch and yaw, turned in the order yaw, pitch, roll.");
  b.vector("rates", &P::rates, "Body rates", "\u03c9", "rad/s")
      .range(schema::atLeast(-1000), schema::upTo(1000))
      .shownIn("deg/s");
  b.choice(
      "rotors", &P::rotors, "Rotors",
      std::vector<schema::Named<RotorStart>>{
          {RotorStart::Hover, "hover", "Hovering",
           "At the speeds that carry the vehicle at rest in still air, and at the tilt it hovers "
           "at unless roll or pitch are given."},
          {RotorStart::Stopped, "stopped", "Stopped", "All rotors at rest."},
          {RotorStart::Given, "given", "At a given speed", "All rotors at the speed below."}});
  b.number("rotorSpeed", &P::rotorSpeed, "Rotor speed", "\u03a9", "rad/s")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .shownIn("rpm")
      .help("Used when the rotors start at a given speed.");
}

}  // namespace rotorbench
