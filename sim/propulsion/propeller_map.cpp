#include "sim/propulsion/propeller_map.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace rotorbench {

namespace {

/// Calls work(i) for all i below `count` on all processors: every point of a map stands alone, so the numbers do not
/// depend on how many there are.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  constexpr unsigned kMost = 8;
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;
  for (unsigned k = 1; k < std::min(kMost, std::thread::hardware_concurrency()); ++k)
    helpers.emplace_back(run);
  run();
}

}  // namespace

PropellerMap::PropellerMap(const BladeElementRotor& rotor, const PropellerMapSettings& settings)
    : radius_(rotor.radius()), area_(std::numbers::pi * radius_ * radius_) {
  tabulateAxial(rotor, settings);
  tabulateSide(rotor, settings);
}

void PropellerMap::tabulateAxial(const BladeElementRotor& rotor,
                                 const PropellerMapSettings& settings) {
  const auto directions = static_cast<std::size_t>(settings.directions);
  const auto rows = static_cast<std::size_t>(settings.reynoldsNumbers);
  stride_ = directions + 2;
  values_.resize(stride_ * (rows + 2));
  lastDirection_ = settings.directions - 1;
  lastRow_ = settings.reynoldsNumbers - 1;
  directionsPerAngle_ = lastDirection_ / std::numbers::pi;
  leastLogReynolds_ = std::log(settings.leastReynolds);
  rowsPerLog_ = lastRow_ / (std::log(settings.mostReynolds) - leastLogReynolds_);
  const AirState air;
  inParallel(rows, [&](std::size_t i) {
    const double reynolds = std::exp(leastLogReynolds_ + static_cast<double>(i) / rowsPerLog_);
    const double speed = reynolds * air.viscosity / (air.density * radius_);
    const double scale = 1 / (0.5 * air.density * area_ * speed * speed);
    for (std::size_t k = 0; k < directions; ++k) {
      const double chi = static_cast<double>(k) / directionsPerAngle_ - std::numbers::pi / 2;
      // The cosine of +-90 degrees is not quite 0; a blade that turns backwards would be meant below it.
      const double omega = std::fmax(0, speed * std::cos(chi) / (kReferenceRadius * radius_));
      const AxialLoad load = rotor.axial(omega, speed * std::sin(chi), air);
      values_[(i + 1) * stride_ + k + 1] = {load.thrust * scale, load.torque * scale / radius_};
    }
  });
  extrapolateEdges(rows);
}

void PropellerMap::tabulateSide(const BladeElementRotor& rotor,
                                const PropellerMapSettings& settings) {
  // At no in-plane speed the limit is wanted: so small an angle is near enough, the values being even in it.
  constexpr double kLeastAngle = 0.02;
  const auto directions = static_cast<std::size_t>(settings.sideDirections);
  const auto angles = static_cast<std::size_t>(settings.sideAngles);
  sideDirections_ = directions + 2;
  sideAngles_ = angles + 2;
  side_.resize(kSideRows * sideAngles_ * sideDirections_);
  sideDirectionsPerAngle_ = static_cast<double>(directions - 1) / std::numbers::pi;
  sideAnglesPerAngle_ = static_cast<double>(angles - 1) / (std::numbers::pi / 2);
  sideRowsPerLog_ = rowsPerLog_ * static_cast<double>(kSideRows - 1) / lastRow_;
  const AirState air;
  inParallel(kSideRows * angles, [&](std::size_t place) {
    const std::size_t i = place / angles, j = place % angles;
    const double reynolds = std::exp(leastLogReynolds_ + static_cast<double>(i) / sideRowsPerLog_);
    const double speed = reynolds * air.viscosity / (air.density * radius_);
    const double angle = std::fmax(kLeastAngle, static_cast<double>(j) / sideAnglesPerAngle_);
    for (std::size_t k = 0; k < directions; ++k) {
      const double chi = static_cast<double>(k) / sideDirectionsPerAngle_ - std::numbers::pi / 2;
      side_[sideIndex(i, j + 1, k + 1)] = sideAt(rotor, chi, angle, speed);
    }
  });
  extrapolateSideEdges();
}

PropellerMap::SideValues PropellerMap::sideAt(const BladeElementRotor& rotor, double direction,
                                              double sideAngle, double speed) const {
  const AirState air;
  const double inPlane = speed * std::sin(sideAngle);
  const double rest = std::fmax(0, speed * std::cos(sideAngle));
  const double omega = std::fmax(0, rest * std::cos(direction) / (kReferenceRadius * radius_));
  const double axial = rest * std::sin(direction);
  const ObliqueLoad load = rotor.oblique(omega, axial, inPlane, air);
  // Less what axial() of the map gives, so that the sum is right wherever the axial table is read.
  const ThrustAndTorque still = this->axial(omega, axial, air);
  const double sine = std::sin(sideAngle);
  const double force = 1 / (0.5 * air.density * area_ * speed * speed), moment = force / radius_;
  return {(load.thrust - still.thrust) * force / (sine * sine),
          (load.torque - still.torque) * moment / (sine * sine),
          load.drag * force / sine,
          load.side * force / sine,
          load.rollMoment * moment / sine,
          load.pitchMoment * moment / sine};
}

/// Even about no in-plane speed; on straight lines through the last two points elsewhere.
void PropellerMap::extrapolateSideEdges() {
  const auto beyond = [this](std::size_t to, std::size_t edge, std::size_t inner) {
    for (std::size_t q = 0; q < kSideValues; ++q)
      side_[to][q] = 2 * side_[edge][q] - side_[inner][q];
  };
  const std::size_t angle = sideAngles_ - 1, last = sideDirections_ - 1;
  for (std::size_t i = 0; i < kSideRows; ++i) {
    for (std::size_t j = 1; j < angle; ++j) {
      beyond(sideIndex(i, j, 0), sideIndex(i, j, 1), sideIndex(i, j, 2));
      beyond(sideIndex(i, j, last), sideIndex(i, j, last - 1), sideIndex(i, j, last - 2));
    }
    for (std::size_t k = 0; k <= last; ++k) {
      side_[sideIndex(i, 0, k)] = side_[sideIndex(i, 2, k)];
      beyond(sideIndex(i, angle, k), sideIndex(i, angle - 1, k), sideIndex(i, angle - 2, k));
    }
  }
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
  b.integer("sideDirections", &S::sideDirections, "Directions with air from the side")
      .range(schema::atLeast(16), schema::upTo(400))
      .help("As above, in the table of what in-plane air speed adds.")
      .advanced();
  b.integer("sideAngles", &S::sideAngles, "Side angles")
      .range(schema::atLeast(4), schema::upTo(100))
      .help("From no in-plane air speed to nothing but in-plane air speed.")
      .advanced();
  b.check([](const S& s, std::vector<Problem>& problems) {
    if (s.mostReynolds > s.leastReynolds) return;
    problems.push_back({"mostReynolds", "the highest Reynolds number is not above the lowest",
                        "a number above leastReynolds"});
  });
}

}  // namespace rotorbench
