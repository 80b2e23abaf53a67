#include "sim/propulsion/rotor/lumped_equivalent.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/error.h"

namespace rotorbench {

namespace {

/// Steps of the grid: from none to the largest in-plane speed, from descent to climb.
constexpr int kAcross = 6, kAlong = 5;

using Load = RotorLoad<double>;

class Loads {
 public:
  Loads(const RotorAerodynamics& rotor, double speed, double density)
      : prepared_(prepareRotor(rotor)), speed_(speed), density_(density) {
    if (const auto* c = std::get_if<PropellerCoefficients>(&rotor)) lumped_ = lumpedModel(*c);
    if (const auto* c = std::get_if<RotorCoefficients>(&rotor)) lumped_ = lumpedModel(*c);
  }
  /// Along z, in a stream that meets the hub with these speeds in m/s.
  [[nodiscard]] Load at(double inPlane, double axial) const {
    const Eigen::Vector3d v(inPlane, 0, axial), axis = Eigen::Vector3d::UnitZ();
    if (prepared_) return prepared_->load<double>(speed_, v, axis, 1, density_);
    return lumped_.load<double>(speed_, v, axis, 1.0, density_);
  }

 private:
  std::shared_ptr<const PreparedRotor> prepared_;
  RotorModel<double> lumped_;
  double speed_, density_;
};

/// What is compared at one place of the grid.
struct Sample {
  double inPlane, axial;
  Load load;
};

std::vector<Sample> samplesOf(const Loads& loads, const LumpingRange& range) {
  std::vector<Sample> samples;
  for (int i = 0; i <= kAcross; ++i) {
    for (int j = -kAlong; j <= kAlong; ++j) {
      const double u = range.inPlane * i / kAcross, v = range.axial * j / kAlong;
      samples.push_back({u, v, loads.at(u, v)});
    }
  }
  return samples;
}

/// sum x y/sum x^2 over the samples.
template <class X, class Y>
double slope(const std::vector<Sample>& samples, const X& x, const Y& y) {
  double product = 0, square = 0;
  for (const Sample& s : samples) {
    product += x(s) * y(s);
    square += x(s) * x(s);
  }
  return product / square;
}

template <class Value>
double rootMeanSquare(const std::vector<Sample>& samples, double scale, const Value& value) {
  double square = 0;
  for (const Sample& s : samples) square += std::pow(value(s) / scale, 2);
  return std::sqrt(square / static_cast<double>(samples.size()));
}

/// k_z and k_h in turn: where one of both would be below 0 the other is alone.
void fitThrust(const std::vector<Sample>& samples, double atRest, double speed, RotorInflow& fit) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const Sample& s : samples) {
    const Eigen::Vector2d row(s.inPlane * s.inPlane, -speed * s.axial);
    normal += row * row.transpose();
    right += row * (s.load.thrust - atRest);
  }
  const Eigen::Vector2d both = normal.ldlt().solve(right);
  fit.translationalLift = both[0];
  fit.inflow = both[1];
  if (both[0] < 0) fit.inflow = std::max(right[1] / normal(1, 1), 0.0);
  if (both[1] < 0) fit.translationalLift = std::max(right[0] / normal(0, 0), 0.0);
  fit.translationalLift = std::max(fit.translationalLift, 0.0);
  fit.inflow = std::max(fit.inflow, 0.0);
}

LumpingErrors errorsOf(const std::vector<Sample>& samples, const RotorCoefficients& c,
                       const Load& rest, double speed, double radius) {
  const double w = speed, lever = rest.thrust * radius;
  const RotorInflow& k = c.inflow;
  LumpingErrors e;
  e.thrust = rootMeanSquare(samples, rest.thrust, [&](const Sample& s) {
    return rest.thrust + k.translationalLift * s.inPlane * s.inPlane - k.inflow * w * s.axial -
           s.load.thrust;
  });
  e.torque = rootMeanSquare(samples, std::max(rest.torque, 1e-12),
                            [&](const Sample& s) { return rest.torque - s.load.torque; });
  e.inPlane = rootMeanSquare(samples, rest.thrust, [&](const Sample& s) {
    return k.drag * w * s.inPlane + s.load.force[0];
  });
  e.pitch = rootMeanSquare(samples, lever, [&](const Sample& s) {
    return k.flapping * w * s.inPlane - s.load.moment[1];
  });
  e.side = rootMeanSquare(samples, rest.thrust, [](const Sample& s) { return s.load.force[1]; });
  e.roll = rootMeanSquare(samples, lever, [](const Sample& s) { return s.load.moment[0]; });
  return e;
}

}  // namespace

LumpingRange lumpingRange(const RotorAerodynamics& rotor, double speed, double density) {
  const double radius = rotorRadius(rotor), area = std::numbers::pi * radius * radius;
  const double thrust = Loads(rotor, speed, density).at(0, 0).thrust;
  return {speed, density, 0.1 * speed * radius,
          0.4 * std::sqrt(std::max(thrust, 0.0) / (2 * density * area))};
}

LumpedEquivalent lumpedEquivalent(const RotorAerodynamics& rotor, const LumpingRange& range) {
  const Loads loads(rotor, range.speed, range.density);
  const Load rest = loads.at(0, 0);
  if (!(rest.thrust > 0) || !std::isfinite(rest.torque)) {
    throw InputError({}, {{"aerodynamics", "has no thrust at this speed at rest",
                           "a propeller that lifts: coefficients could not be those of it"}});
  }
  const double w = range.speed, radius = rotorRadius(rotor);
  const std::vector<Sample> samples = samplesOf(loads, range);
  LumpedEquivalent result;
  RotorCoefficients& c = result.coefficients;
  c.thrust = rest.thrust / (w * w);
  c.torque = std::max(rest.torque / (w * w), 0.0);
  c.referenceDensity = range.density;
  c.diameter = 2 * radius;
  fitThrust(samples, rest.thrust, w, c.inflow);
  const auto stream = [&](const Sample& s) { return w * s.inPlane; };
  c.inflow.drag =
      std::max(slope(samples, stream, [](const Sample& s) { return -s.load.force[0]; }), 0.0);
  c.inflow.flapping = slope(samples, stream, [](const Sample& s) { return s.load.moment[1]; });
  result.errors = errorsOf(samples, c, rest, w, radius);
  return result;
}

void Describe<LumpingRange>::fields(schema::Builder<LumpingRange>& b) {
  using P = LumpingRange;
  b.title("lumping", "Range",
          "The rotor speed and the air speeds over which the coefficients are to hold.");
  b.number("speed", &P::speed, "Rotor speed", "w", "rad/s")
      .range(schema::above(0), schema::upTo(1e5))
      .shownIn("rpm")
      .help("That of the hover, where the vehicle hovers.");
  b.number("density", &P::density, "Air density", "rho", "kg/m^3")
      .range(schema::above(0), schema::upTo(100))
      .help("The coefficients hold at this one and scale with the actual density over it.");
  b.number("inPlane", &P::inPlane, "In-plane air speed up to", "u", "m/s")
      .range(schema::above(0), schema::upTo(1000))
      .help("A tenth of the blade tips' speed at first.");
  b.number("axial", &P::axial, "Climb and descent up to", "V", "m/s")
      .range(schema::above(0), schema::upTo(1000))
      .help("0.4 of the induced velocity at first, short of the vortex ring state.");
}

}  // namespace rotorbench
