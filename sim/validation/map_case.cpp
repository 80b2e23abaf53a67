// The tabulated propeller against the blade elements it was made of, over all directions of the
// air, axial and edgewise, and both under the states where a division could go wrong.
#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/constants.h"
#include "sim/core/parallel.h"
#include "sim/propulsion/rotor/propeller_map.h"
#include "sim/validation/cases.h"
#include "sim/validation/text.h"
#include "sim/validation/uiuc_data.h"

namespace rotorbench::validation {

namespace {

constexpr double kReference = 0.75;  // r/R of the air speed

struct MapScore {
  std::string name;
  double thrust = 0, torque = 0;     ///< greatest differences in axial flow, % of static
  std::array<double, 4> edgewise{};  ///< thrust, torque, in-plane force and hub moment, % of static
  std::vector<std::array<double, 2>> edgewiseThrust, edgewiseTorque;  ///< side angle, degrees, %
  int broken = 0, solves = 0;  ///< loads that are no finite number
  std::vector<std::array<double, 2>> thrustByAngle, torqueByAngle;  ///< degrees, %
};

/// Directions from straight descent to straight climb, off the map's grid, at five air speeds and
/// in thin air.
void compare(const BladeElementRotor& rotor, const PropellerMap& map, MapScore& score) {
  constexpr double kEnd = 89.9, kStep = 0.37;
  const AirState air{1.1, 1.9e-5};
  for (double chi = -kEnd; chi <= kEnd; chi += kStep) {
    double thrust = 0, torque = 0;
    for (const double speed : {5.0, 17.0, 33.0, 60.0, 110.0}) {
      const double omega = speed / (kReference * rotor.radius());
      const AxialLoad still = rotor.axial(omega, 0, air);
      const double w = omega * std::cos(chi * kDegree), axial = speed * std::sin(chi * kDegree);
      const AxialLoad exact = rotor.axial(w, axial, air);
      const auto mapped = map.axial(w, axial, air);
      thrust = std::max(thrust, 100 * std::abs(mapped.thrust - exact.thrust) / still.thrust);
      torque = std::max(torque, 100 * std::abs(mapped.torque - exact.torque) / still.torque);
    }
    score.thrust = std::max(score.thrust, thrust);
    score.torque = std::max(score.torque, torque);
    score.thrustByAngle.push_back({chi, thrust});
    score.torqueByAngle.push_back({chi, torque});
  }
}

/// Edgewise flow: directions and side angles off the map's grid, three air speeds.
void compareEdgewise(const BladeElementRotor& rotor, const PropellerMap& map, MapScore& score) {
  constexpr double kDirections = 5.3, kSides = 3.7;
  const AirState air{1.1, 1.9e-5};
  const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  for (double side = 0.4; side < 90; side += kSides) {
    std::array<double, 4> most{};
    for (const double speed : {6.0, 25.0, 100.0}) {
      const double omega = speed / (kReference * rotor.radius());
      const AxialLoad still = rotor.axial(omega, 0, air);
      const double rest = std::cos(side * kDegree), moment = still.thrust * rotor.radius();
      for (double chi = -89.7; chi < 90; chi += kDirections) {
        const double w = omega * rest * std::cos(chi * kDegree);
        const Eigen::Vector3d v(speed * std::sin(side * kDegree), 0,
                                speed * rest * std::sin(chi * kDegree));
        const auto exact = rotor.load(w, v, axis, 1, air);
        const auto mapped =
            map.load<double, Eigen::Vector3d>(w, v, axis, 1, air.density, air.viscosity);
        const std::array<double, 4> off{
            std::abs(mapped.thrust - exact.thrust) / still.thrust,
            std::abs(mapped.torque - exact.torque) / still.torque,
            (mapped.force - exact.force).head<2>().norm() / still.thrust,
            (mapped.moment - exact.moment).head<2>().norm() / moment};
        for (std::size_t q = 0; q < most.size(); ++q) most[q] = std::max(most[q], 100 * off[q]);
      }
    }
    for (std::size_t q = 0; q < most.size(); ++q)
      score.edgewise[q] = std::max(score.edgewise[q], most[q]);
    score.edgewiseThrust.push_back({side, most[0]});
    score.edgewiseTorque.push_back({side, most[1]});
  }
}

/// |J| <= 2 forwards and backwards, standing still in wind, without air, and nothing at all.
void scan(const BladeElementRotor& rotor, const PropellerMap& map, MapScore& score) {
  const double d = 2 * rotor.radius();
  const auto look = [&](double omega, double axial, const AirState& air) {
    const AxialLoad exact = rotor.axial(omega, axial, air);
    const auto mapped = map.axial(omega, axial, air);
    const bool finite = std::isfinite(exact.thrust) && std::isfinite(exact.torque) &&
                        std::isfinite(mapped.thrust) && std::isfinite(mapped.torque);
    score.broken += finite ? 0 : 1;
    ++score.solves;
  };
  for (const double density : {0.0, 0.4, 1.225}) {
    const AirState air{density, 1.81e-5};
    for (const double n : {-120.0, -10.0, -1e-6, 0.0, 1e-9, 1.0, 60.0, 250.0}) {
      for (int j = -100; j <= 100; j += 2) {
        const double advance = 0.02 * j;
        look(2 * kPi * n, advance * std::max(std::abs(n), 1.0) * d, air);
      }
    }
  }
}

MapScore scoreOfMap(const PropellerSet& set) {
  const BladeElementRotor rotor(set.geometry);
  const PropellerMap map(rotor);
  MapScore score;
  score.name = set.propeller;
  compare(rotor, map, score);
  compareEdgewise(rotor, map, score);
  scan(rotor, map, score);
  return score;
}

}  // namespace

CaseResult mapAgainstBladeElements(const std::filesystem::path& resources) {
  // Slow flyers, sport, high pitch, small ones: what differs in shape.
  constexpr std::array<const char*, 7> kNames{"apcsf_10x4.7", "apce_10x5",     "gwssf_10x8",
                                              "apcsp_9x7",    "da4052_9x8.95", "gwsdd_4x2.5",
                                              "grsn_11x6"};
  auto sets = readPropellerSets(resources / "validation" / "uiuc");
  std::erase_if(sets, [&](const PropellerSet& set) {
    return std::find(kNames.begin(), kNames.end(), set.propeller) == kNames.end();
  });
  const auto scores = inParallel(sets.size(), [&](std::size_t i) { return scoreOfMap(sets[i]); });
  CaseResult result;
  result.key = "map";
  result.title = "Propeller map against blade elements";
  result.method =
      "The map tabulates a propeller once; here it is asked between its grid points, over all "
      "directions of the air from straight descent to straight climb at five air speeds, and with "
      "air from the side up to nothing but air from the side. Greatest difference in percent of "
      "the static thrust and torque at that air speed. Then both are "
      "asked for |J| up to 2, forwards and backwards, at a standstill and without air, and every "
      "answer must be a finite number.";
  Table table{"By propeller",
              {"Propeller", "Thrust, %", "Torque, %", "Thrust edgewise, %", "Torque edgewise, %",
               "In-plane force, %", "Hub moment, %", "States asked"},
              {}};
  SvgChart thrust{"Map less blade elements, thrust",
                  {"Direction of the air, deg (90: climb)", -90, 90},
                  {"Most, % of static", 0, {}},
                  {}};
  SvgChart torque = thrust;
  torque.title = "Map less blade elements, torque";
  SvgChart edgewiseThrust{"Map less blade elements, thrust with air from the side",
                          {"Side angle, deg (90: no speed but in the plane)", 0, 90},
                          {"Most, % of static", 0, {}},
                          {}};
  SvgChart edgewiseTorque = edgewiseThrust;
  edgewiseTorque.title = "Map less blade elements, torque with air from the side";
  double mostThrust = 0, mostTorque = 0, broken = 0;
  std::array<double, 4> edgewise{};
  int color = 0;
  for (const MapScore& s : scores) {
    mostThrust = std::max(mostThrust, s.thrust);
    mostTorque = std::max(mostTorque, s.torque);
    broken += s.broken;
    table.rows.push_back({s.name, fixed(s.thrust, 3), fixed(s.torque, 3), fixed(s.edgewise[0], 3),
                          fixed(s.edgewise[1], 3), fixed(s.edgewise[2], 3), fixed(s.edgewise[3], 3),
                          std::to_string(s.solves)});
    for (std::size_t q = 0; q < edgewise.size(); ++q)
      edgewise[q] = std::max(edgewise[q], s.edgewise[q]);
    edgewiseThrust.series.push_back({s.name, SvgSeries::Style::Line, color, s.edgewiseThrust});
    edgewiseTorque.series.push_back({s.name, SvgSeries::Style::Line, color, s.edgewiseTorque});
    thrust.series.push_back({s.name, SvgSeries::Style::Line, color, s.thrustByAngle});
    torque.series.push_back({s.name, SvgSeries::Style::Line, color++, s.torqueByAngle});
  }
  result.figures = {
      {"thrust, most", Evidence::SelfCheck, "% of static", mostThrust, 0.2},
      {"torque, most", Evidence::SelfCheck, "% of static", mostTorque, 1},
      {"thrust edgewise, most", Evidence::SelfCheck, "% of static", edgewise[0], 0.2},
      {"torque edgewise, most", Evidence::SelfCheck, "% of static", edgewise[1], 1},
      {"in-plane force, most", Evidence::SelfCheck, "% of static thrust", edgewise[2], 0.2},
      {"hub moment, most", Evidence::SelfCheck, "% of static thrust and radius", edgewise[3], 0.2},
      {"loads that are no finite number", Evidence::SelfCheck, "1", broken, 0}};
  result.tables = {std::move(table)};
  result.charts = {std::move(thrust), std::move(torque), std::move(edgewiseThrust),
                   std::move(edgewiseTorque)};
  result.sources = {"Blades: UIUC Propeller Database"};
  return result;
}

}  // namespace rotorbench::validation
