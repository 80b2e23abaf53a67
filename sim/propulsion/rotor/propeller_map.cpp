#include "sim/propulsion/rotor/propeller_map.h"

#include <algorithm>
#include <cstdint>
#include <istream>
#include <ostream>

#include "sim/core/constants.h"
#include "sim/core/parallel.h"
#include "sim/propulsion/rotor/lane_rotor.h"

namespace rotorbench {

namespace {

/// Fills a row of equal steps: every fourth value is solved, and those between where the row bends
/// more than a cubic follows. All are solved between two points where kinks come so close that the
/// coarse steps would miss some.
template <class Solve>
void fillRow(std::vector<ThrustAndTorque>& row, std::size_t kinksFrom, std::size_t kinksTo,
             const Solve& solve) {
  const std::size_t last = row.size() - 1, coarse = last % 4 == 0 ? 4 : 1;
  for (std::size_t k = 0; k <= last; k += coarse) solve(k);
  ThrustAndTorque most;
  for (std::size_t k = 0; k <= last; k += coarse) {
    most.thrust = std::max(most.thrust, std::abs(row[k].thrust));
    most.torque = std::max(most.torque, std::abs(row[k].torque));
  }
  // Midway between two points: the cubic through the four points around them.
  const auto middle = [&row](std::size_t k, std::size_t step) {
    const auto mean = [&](double ThrustAndTorque::*v) {
      return (9 * (row[k - step].*v + row[k + step].*v) -
              (row[k - 3 * step].*v + row[k + 3 * step].*v)) /
             16;
    };
    return ThrustAndTorque{mean(&ThrustAndTorque::thrust), mean(&ThrustAndTorque::torque)};
  };
  constexpr double kThrust = 1e-4, kTorque = 2.5e-4;  // of the most in any direction
  const auto bends = [&](std::size_t k, std::size_t step) {
    if (k >= kinksFrom && k <= kinksTo) return true;
    if (k < 3 * step || k + 3 * step > last) return true;
    const ThrustAndTorque m = middle(k, step);
    return std::abs(m.thrust - row[k].thrust) > kThrust * most.thrust ||
           std::abs(m.torque - row[k].torque) > kTorque * most.torque;
  };
  for (std::size_t step = coarse / 2; step > 0; step /= 2) {
    std::vector<bool> bent(row.size());
    for (std::size_t k = 0; k <= last; k += 2 * step) bent[k] = bends(k, 2 * step);
    for (std::size_t k = step; k < last; k += 2 * step) {
      // Of all four points the cubic leans on: a kink may hide from the nearest ones.
      if (k < 3 * step || k + 3 * step > last || bent[k - step] || bent[k + step] ||
          bent[k - 3 * step] || bent[k + 3 * step]) {
        solve(k);
      } else {
        row[k] = middle(k, step);
      }
    }
  }
}

}  // namespace

PropellerMap::PropellerMap(const BladeElementRotor& rotor, const PropellerMapSettings& settings) {
  setScales(rotor, settings);
  tabulateAxial(rotor, settings);
  tabulateSide(rotor, settings);
}

void PropellerMap::setScales(const BladeElementRotor& rotor, const PropellerMapSettings& settings) {
  radius_ = rotor.radius();
  area_ = kPi * radius_ * radius_;
  disc_ = rotor.disc();
  stride_ = static_cast<std::size_t>(settings.directions) + 2;
  lastDirection_ = settings.directions - 1;
  lastRow_ = settings.reynoldsNumbers - 1;
  directionsPerAngle_ = lastDirection_ / kPi;
  leastLogReynolds_ = std::log(settings.leastReynolds);
  rowsPerLog_ = lastRow_ / (std::log(settings.mostReynolds) - leastLogReynolds_);
}

void PropellerMap::write(std::ostream& out) const {
  const std::uint64_t count = values_.size(), solved = sideSolved_;
  out.write(reinterpret_cast<const char*>(&count), sizeof count);
  out.write(reinterpret_cast<const char*>(values_.data()),
            static_cast<std::streamsize>(count * sizeof(ThrustAndTorque)));
  out.write(reinterpret_cast<const char*>(&solved), sizeof solved);
  side_.write(out);
}

std::optional<PropellerMap> PropellerMap::read(std::istream& in, const BladeElementRotor& rotor,
                                               const PropellerMapSettings& settings) {
  PropellerMap map;
  map.setScales(rotor, settings);
  std::uint64_t count = 0, solved = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof count);
  const auto rows = static_cast<std::size_t>(settings.reynoldsNumbers) + 2;
  if (!in || count != map.stride_ * rows) return {};
  map.values_.resize(count);
  in.read(reinterpret_cast<char*>(map.values_.data()),
          static_cast<std::streamsize>(count * sizeof(ThrustAndTorque)));
  in.read(reinterpret_cast<char*>(&solved), sizeof solved);
  if (!in || !map.side_.read(in)) return {};
  map.sideSolved_ = solved;
  return map;
}

void PropellerMap::tabulateAxial(const BladeElementRotor& rotor,
                                 const PropellerMapSettings& settings) {
  const auto directions = static_cast<std::size_t>(settings.directions);
  const auto rows = static_cast<std::size_t>(settings.reynoldsNumbers);
  values_.resize(stride_ * (rows + 2));
  const AirState air;
  const auto solved = inParallel(rows, [&](std::size_t i) {
    std::vector<ThrustAndTorque> row(directions);
    const double reynolds = std::exp(leastLogReynolds_ + static_cast<double>(i) / rowsPerLog_);
    const double speed = reynolds * air.viscosity / (air.density * radius_);
    const double scale = 1 / (0.5 * air.density * area_ * speed * speed);
    const auto solve = [&](std::size_t k) {
      const double chi = static_cast<double>(k) / directionsPerAngle_ - kPi / 2;
      // The cosine of +-90 degrees is not quite 0; a blade that turns backwards would be meant
      // below it.
      const double omega = std::fmax(0, speed * std::cos(chi) / (kReferenceRadius * radius_));
      const AxialLoad load = rotor.axial(omega, speed * std::sin(chi), air);
      row[k] = {load.thrust * scale, load.torque * scale / radius_};
    };
    // From slow descent to where the annuli have left the ring one after the other.
    constexpr double kKinksFrom = 30 * kDegree;
    const auto place = [&](double chi) {
      return static_cast<std::size_t>((chi + kPi / 2) * directionsPerAngle_);
    };
    fillRow(row, place(-kKinksFrom), place(0), solve);
    return row;
  });
  for (std::size_t i = 0; i < rows; ++i)
    std::copy(solved[i].begin(), solved[i].end(), &values_[(i + 1) * stride_ + 1]);
  extrapolateEdges(rows);
}

void PropellerMap::tabulateSide(const BladeElementRotor& rotor,
                                const PropellerMapSettings& settings) {
  const double logRange = lastRow_ / rowsPerLog_;
  const LaneRotor lanes(rotor, settings.leastReynolds, settings.mostReynolds);
  const auto direction = [&](const GridPlace& p) { return (p[0] - 0.5) * kPi; };
  const auto sideAngle = [&](const GridPlace& p) { return p[1] * kPi / 2; };
  const auto logReynolds = [&](const GridPlace& p) { return leastLogReynolds_ + p[2] * logRange; };
  const auto axis = [](int points, int refinements, bool even) {
    return GridAxis{static_cast<std::size_t>(points), refinements, even};
  };
  const RefinedGrid grid({axis(settings.sideDirections, settings.sideRefinements, false),
                          axis(settings.sideAngles, settings.sideRefinements, true),
                          axis(settings.sideReynoldsNumbers, 0, false)},
                         sideTolerance(settings.sideTolerance), [&](const GridPlace& p) {
                           return sideAt(lanes, direction(p), sideAngle(p), logReynolds(p));
                         });
  sideSolved_ = grid.solved();
  side_ = CubicTable(grid);
}

GridValues PropellerMap::sideAt(const LaneRotor& rotor, double direction, double sideAngle,
                                double logReynolds) const {
  // Of what is divided by the sine the limit is wanted at no in-plane speed: so small an angle is
  // near enough, the values being even in it.
  constexpr double kLeastAngle = 0.01;
  const AirState air;
  const double speed = std::exp(logReynolds) * air.viscosity / (air.density * radius_);
  const double rest = std::fmax(0, speed * std::cos(sideAngle));
  const double omega = std::fmax(0, rest * std::cos(direction) / (kReferenceRadius * radius_));
  const double sine = std::sin(std::fmax(sideAngle, kLeastAngle));
  const ObliqueLoad load = rotor.oblique(omega, rest * std::sin(direction), speed * sine, air);
  const double force = 1 / (0.5 * air.density * area_ * speed * speed), moment = force / radius_;
  GridValues values{load.thrust * force, load.torque * moment, load.drag * force / sine,
                    load.rollMoment * moment / sine};
  if (sideAngle < kLeastAngle) {
    const ThrustAndTorque still = axialCoefficients(direction, logReynolds);
    values[0] = still.thrust;
    values[1] = still.torque;
  }
  return values;
}

/// `share` of the static thrust and ten times that of the static torque. Of a blade that hardly
/// lifts at rest, of a part of the most it does in any direction.
GridValues PropellerMap::sideTolerance(double share) const {
  constexpr double kLeastPart = 0.05;
  ThrustAndTorque most;
  for (const ThrustAndTorque& v : values_) {
    most.thrust = std::fmax(most.thrust, std::abs(v.thrust));
    most.torque = std::fmax(most.torque, std::abs(v.torque));
  }
  const ThrustAndTorque still =
      axialCoefficients(0.0, leastLogReynolds_ + 0.5 * lastRow_ / rowsPerLog_);
  const double thrust = share * std::fmax(std::abs(still.thrust), kLeastPart * most.thrust);
  const double torque = share * std::fmax(std::abs(still.torque), kLeastPart * most.torque);
  constexpr double kTorque = 10, kInPlane = 4;
  // A propeller without blades to speak of has nothing to be refined.
  const auto positive = [](double x) { return x > 0 ? x : 1; };
  return {positive(thrust), positive(kTorque * torque), positive(kInPlane * thrust),
          positive(kInPlane * thrust)};
}

/// Points beyond the grid, on straight lines through the last two.
void PropellerMap::extrapolateEdges(std::size_t rows) {
  const auto beyond = [this](std::size_t to, std::size_t edge, std::size_t inner) {
    values_[to].thrust = 2 * values_[edge].thrust - values_[inner].thrust;
    values_[to].torque = 2 * values_[edge].torque - values_[inner].torque;
  };
  for (std::size_t i = 1; i <= rows; ++i) {
    const std::size_t first = i * stride_, last = first + stride_ - 1;
    beyond(first, first + 1, first + 2);
    beyond(last, last - 1, last - 2);
  }
  for (std::size_t k = 0; k < stride_; ++k) {
    const std::size_t last = (rows + 1) * stride_ + k;
    beyond(k, k + stride_, k + 2 * stride_);
    beyond(last, last - stride_, last - 2 * stride_);
  }
}

void Describe<PropellerMapSettings>::fields(schema::Builder<PropellerMapSettings>& b) {
  using S = PropellerMapSettings;
  b.title("map-grid", "Propeller map", "How finely a propeller is tabulated.");
  b.integer("directions", &S::directions, "Directions of the air", "N_\u03c7")
      .range(schema::atLeast(16), schema::upTo(2000))
      .advanced();
  b.integer("reynoldsNumbers", &S::reynoldsNumbers, "Reynolds numbers", "N_Re")
      .range(schema::atLeast(2), schema::upTo(100))
      .advanced();
  b.number("leastReynolds", &S::leastReynolds, "Lowest Reynolds number", "", "1")
      .range(schema::atLeast(1), schema::upTo(1e9))
      .help("Of the tip radius and the air speed at 75 % of it.")
      .advanced();
  b.number("mostReynolds", &S::mostReynolds, "Highest Reynolds number", "", "1")
      .range(schema::atLeast(1), schema::upTo(1e9))
      .help("Of the tip radius and the air speed at 75 % of it.")
      .advanced();
  b.integer("sideDirections", &S::sideDirections, "Directions in edgewise flow")
      .range(schema::atLeast(16), schema::upTo(400))
      .help("Of the coarse grid of what in-plane air speed does.")
      .advanced();
  b.integer("sideAngles", &S::sideAngles, "Side angles")
      .range(schema::atLeast(4), schema::upTo(100))
      .help("Coarse, from no in-plane air speed to nothing but in-plane air speed.")
      .advanced();
  b.integer("sideReynoldsNumbers", &S::sideReynoldsNumbers, "Reynolds numbers in edgewise flow")
      .range(schema::atLeast(4), schema::upTo(100))
      .advanced();
  b.integer("sideRefinements", &S::sideRefinements, "Refinements in edgewise flow")
      .range(schema::atLeast(0), schema::upTo(4))
      .help("How often the coarse steps are halved where the tolerance asks for it.")
      .advanced();
  b.number("sideTolerance", &S::sideTolerance, "Tolerance in edgewise flow", "", "1")
      .range(schema::atLeast(1e-5), schema::upTo(1))
      .help("Of the static thrust; ten times that of the static torque.")
      .advanced();
  b.check([](const S& s, std::vector<Problem>& problems) {
    constexpr double kMostPoints = 4e6;
    const double finer = std::exp2(s.sideRefinements);
    const double points = finer * s.sideDirections * finer * s.sideAngles *
                          static_cast<double>(s.sideReynoldsNumbers);
    if (points > kMostPoints) {
      problems.push_back(
          {"sideRefinements",
           "refined, the grid of edgewise flow would have more than 4 million points",
           "fewer refinements, directions, side angles or Reynolds numbers"});
    }
  });
  b.check([](const S& s, std::vector<Problem>& problems) {
    if (s.mostReynolds > s.leastReynolds) return;
    problems.push_back({"mostReynolds", "the highest Reynolds number is not above the lowest",
                        "a number above leastReynolds"});
  });
}

}  // namespace rotorbench
