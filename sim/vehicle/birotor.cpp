#include "sim/vehicle/birotor.h"

namespace rotorbench {

namespace {

template <class P>
void describeCommon(schema::Builder<P>& b, const char* table) {
  using schema::above;
  using schema::atLeast;
  using schema::upTo;
  b.number("mass1", &P::mass1, "Mass of body 1", "m\u2081", "kg")
      .range(above(0), upTo(1e4))
      .source(table);
  b.number("mass2", &P::mass2, "Mass of body 2", "m\u2082", "kg")
      .range(above(0), upTo(1e4))
      .source(table);
  b.number("arm", &P::arm, "Arm length", "r", "m")
      .range(above(0), upTo(100))
      .help("Half the length of the bar.")
      .source(table);
  b.number("gravity", &P::gravity, "Gravity", "g", "m/s^2")
      .range(atLeast(0), upTo(100))
      .source(table);
  const auto force = [&](const char* key, double P::*member, const char* label,
                         const char* symbol) {
    b.number(key, member, label, symbol, "N")
        .range(atLeast(-1e5), upTo(1e5))
        .help("Square to the bar.")
        .source(table);
  };
  force("force1", &P::force1, "Force on body 1", "F\u2081");
  force("force2", &P::force2, "Force on body 2", "F\u2082");
  b.template vector<2>("centre", &P::centre, "Centre at the start", "y, z", "m")
      .range(atLeast(-1e6), upTo(1e6))
      .components({"y", "z"})
      .source(table);
  b.template vector<2>("velocity", &P::velocity, "Velocity at the start", "v", "m/s")
      .range(atLeast(-1e4), upTo(1e4))
      .components({"y", "z"})
      .source(table);
  b.number("angle", &P::angle, "Angle at the start", "\u03b1", "rad")
      .range(atLeast(-1e4), upTo(1e4))
      .help("From the y axis towards the z axis.")
      .source(table);
  b.number("angularVelocity", &P::angularVelocity, "Angular velocity at the start", "\u03b1'",
           "rad/s")
      .range(atLeast(-1e4), upTo(1e4))
      .source(table);
}

}  // namespace

SpringBarBirotor::State SpringBarBirotor::initialState() const {
  const Eigen::Vector2d along(std::cos(p_.angle), std::sin(p_.angle));
  const Eigen::Vector2d arm = p_.arm * along;
  const Eigen::Vector2d turn = p_.angularVelocity * Eigen::Vector2d(-arm.y(), arm.x());
  const Eigen::Vector2d r1 = p_.centre - arm, r2 = p_.centre + arm;
  const Eigen::Vector2d v1 = p_.velocity - turn, v2 = p_.velocity + turn;
  State y;
  y << r1.x(), v1.x(), r1.y(), v1.y(), r2.x(), v2.x(), r2.y(), v2.y();
  return y;
}

double SpringBarBirotor::angle(const State& y) {
  return std::atan2(y[6] - y[2], y[4] - y[0]);
}

double SpringBarBirotor::angularVelocity(const State& y) {
  const double dy = y[4] - y[0], dz = y[6] - y[2];
  return (dy * (y[7] - y[3]) - dz * (y[5] - y[1])) / (dy * dy + dz * dz);
}

double SpringBarBirotor::energy(const State& y) const {
  const double stretch = bar(y).length - 2 * p_.arm;
  return 0.5 * p_.mass1 * (y[1] * y[1] + y[3] * y[3]) +
         0.5 * p_.mass2 * (y[5] * y[5] + y[7] * y[7]) +
         p_.gravity * (p_.mass1 * y[2] + p_.mass2 * y[6]) + 0.5 * p_.stiffness * stretch * stretch;
}

RigidBarBirotor::RigidBarBirotor(const RigidBarParameters& parameters)
    : p_(parameters),
      mass_(parameters.mass1 + parameters.mass2),
      thrust_(parameters.force1 + parameters.force2),
      angularFriction_(angularFriction(parameters, parameters.angularDamping)) {}

double RigidBarBirotor::angularFriction(const RigidBarParameters& p, BirotorDamping damping) {
  return 2 * p.friction * p.arm * (damping == BirotorDamping::Physical ? 1 : p.arm);
}

double RigidBarBirotor::angularVelocityAt(double t, BirotorDamping damping) const {
  const double rate = angularFriction(p_, damping) / (p_.arm * mass_);
  const double push = (p_.force2 - p_.force1) / (p_.arm * mass_);
  // (1 - exp(-rate t)) / rate, which is t without friction.
  const double held = rate * t > 0 ? -std::expm1(-rate * t) / rate : t;
  return p_.angularVelocity * std::exp(-rate * t) + push * held;
}

RigidBarBirotor::State RigidBarBirotor::initialState() const {
  State y;
  y << p_.centre.x(), p_.velocity.x(), p_.centre.y(), p_.velocity.y(), p_.angle, p_.angularVelocity;
  return y;
}

double RigidBarBirotor::energy(const State& y) const {
  return 0.5 * mass_ * (y[1] * y[1] + y[3] * y[3] + p_.arm * p_.arm * y[5] * y[5]) +
         p_.gravity * mass_ * y[2];
}

void Describe<SpringBarParameters>::fields(schema::Builder<SpringBarParameters>& b) {
  using P = SpringBarParameters;
  const char* table = "Thesis 2014, table 2.1";
  b.title(
      "spring-bar", "Spring-damper bar",
      "Two point masses held together by a spring and a damper. A stiff bar shows how an explicit "
      "method fails at too large a step.",
      "Thesis 2014, (2.7)-(2.19), with F_g1 and F_g2 of (2.2)-(2.3) exchanged and atan2 in (2.12)");
  describeCommon(b, table);
  b.number("friction", &P::friction, "Friction", "D", "N*s/m")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .help("Force per speed on each body.")
      .source(table);
  b.number("stiffness", &P::stiffness, "Spring constant", "k", "N/m")
      .range(schema::above(0), schema::upTo(1e9))
      .source(table);
  b.number("damping", &P::damping, "Damper constant", "b", "N*s/m")
      .range(schema::atLeast(0), schema::upTo(1e7))
      .source(table);
}

void Describe<RigidBarParameters>::fields(schema::Builder<RigidBarParameters>& b) {
  using P = RigidBarParameters;
  const char* table = "Thesis 2014, table 2.2";
  b.title("rigid-bar", "Rigid bar",
          "One rigid body in the plane, moment of inertia r\u00b2 (m1 + m2). Both bodies must "
          "weigh the "
          "same.",
          "Thesis 2014, (2.25)-(2.32), with F2 - F1 in (2.31) as in its figure 2.1");
  describeCommon(b, table);
  b.number("friction", &P::friction, "Friction", "D", "N*s/m")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .help("Force per speed on the centre, and on each body as the bar turns.")
      .source(table);
  b.choice("angularDamping", &P::angularDamping, "Damping of the rotation",
           std::vector<schema::Named<BirotorDamping>>{
               {BirotorDamping::Physical, "physical", "Physical",
                "Moment 2 D r\u00b2 \u03b1', (2.27)."},
               {BirotorDamping::Thesis2014, "thesis-2014", "Thesis 2014",
                "2 D r\u00b3 \u03b1': what the published tables 2.3 and 2.4 were computed with."}})
      .source("Thesis 2014: tables 2.3 and 2.4 come out only with the second");
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (p.mass1 != p.mass2) {
      problems.push_back(
          {"mass2", "the rigid bar is balanced in the middle", "the mass of body 1"});
    }
  });
}

}  // namespace rotorbench
