#include "sim/propulsion/propeller_map.h"

namespace rotorbench {

PropellerMap::PropellerMap(const BladeElementRotor& rotor, const PropellerMapSettings& settings)
    : radius_(rotor.radius()), area_(std::numbers::pi * radius_ * radius_) {
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
  for (std::size_t i = 0; i < rows; ++i) {
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
  }
  extrapolateEdges(rows);
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
  b.title("map", "Propeller map", "How finely a propeller is tabulated.");
  b.integer("directions", &S::directions, "Directions of the air", "N_\u03c7")
      .range(schema::atLeast(16), schema::upTo(4000));
  b.integer("reynoldsNumbers", &S::reynoldsNumbers, "Reynolds numbers", "N_Re")
      .range(schema::atLeast(2), schema::upTo(200));
  b.number("leastReynolds", &S::leastReynolds, "Lowest Reynolds number", "", "1")
      .range(schema::atLeast(1), schema::upTo(1e9))
      .help("Of the tip radius and the air speed at 75 % of it.")
      .advanced();
  b.number("mostReynolds", &S::mostReynolds, "Highest Reynolds number", "", "1")
      .range(schema::atLeast(1), schema::upTo(1e9))
      .help("Of the tip radius and the air speed at 75 % of it.")
      .advanced();
  b.check([](const S& s, std::vector<Problem>& problems) {
    if (s.mostReynolds > s.leastReynolds) return;
    problems.push_back({"mostReynolds", "the highest Reynolds number is not above the lowest",
                        "a number above leastReynolds"});
  });
}

}  // namespace rotorbench
