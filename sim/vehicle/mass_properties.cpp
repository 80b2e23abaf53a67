#include "sim/vehicle/mass_properties.h"

#include <Eigen/Eigenvalues>

#include "sim/core/number_text.h"

namespace rotorbench {

namespace {

/// Share by which the largest moment may be above the sum of the others: two figures rounded to
/// three digits are off by 1 % in sum at worst, and the sum of the others by as much again.
constexpr double kRounded = 0.02;

Eigen::Matrix3d pointInertia(double mass, const Eigen::Vector3d& d) {
  return mass * (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose());
}

}  // namespace

Eigen::Matrix3d InertiaTensor::matrix() const {
  Eigen::Matrix3d m;
  m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return m;
}

MassProperties withPointMass(const MassProperties& body, double mass,
                             const Eigen::Vector3d& position) {
  MassProperties sum;
  sum.mass = body.mass + mass;
  sum.centre = (body.mass * body.centre + mass * position) / sum.mass;
  sum.inertia = body.inertia + pointInertia(body.mass, body.centre - sum.centre) +
                pointInertia(mass, position - sum.centre);
  return sum;
}

std::vector<Problem> massProblems(const MassProperties& properties, const std::string& path) {
  if (!(properties.mass > 0)) {
    return {{path, "the total mass is not positive", "a mass above 0 kg"}};
  }
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(properties.inertia, Eigen::EigenvaluesOnly)
          .eigenvalues();
  if (!(moments[0] > 0)) {
    return {{path, "the inertia is not positive definite",
             "three positive principal moments, products of inertia small enough"}};
  }
  // Rounding must not refuse a flat body, whose largest moment is exactly the sum of the others.
  const double over = moments[2] / (moments[0] + moments[1]) - 1;
  if (over <= 1e-9) return {};
  const char* allowed = "each principal moment at most the sum of the other two";
  if (over > kRounded) {
    return {
        {path,
         "no body has this inertia: one principal moment is above the sum of the other two by " +
             shortNumber(100 * over, 2) + " %",
         allowed}};
  }
  return {{path,
           "one principal moment is above the sum of the other two by " +
               shortNumber(100 * over, 2) + " %, as rounded figures of a flat body are",
           allowed, true}};
}

void Describe<InertiaTensor>::fields(schema::Builder<InertiaTensor>& b) {
  using P = InertiaTensor;
  b.title(
      "inertia", "Inertia",
      "Inertia tensor about the centre of mass in body axes. Off the diagonal stand the tensor's "
      "entries, the negative products of inertia.");
  b.standsAlone();
  b.number("xx", &P::xx, "Roll", "I_xx", "kg*m^2")
      .range(schema::above(0), schema::upTo(1e4))
      .required();
  b.number("yy", &P::yy, "Pitch", "I_yy", "kg*m^2")
      .range(schema::above(0), schema::upTo(1e4))
      .required();
  b.number("zz", &P::zz, "Yaw", "I_zz", "kg*m^2")
      .range(schema::above(0), schema::upTo(1e4))
      .required();
  const auto product = [&b](const char* key, double P::*member, const char* symbol) {
    b.number(key, member, "Product", symbol, "kg*m^2")
        .range(schema::atLeast(-1e4), schema::upTo(1e4))
        .advanced();
  };
  product("xy", &P::xy, "I_xy");
  product("xz", &P::xz, "I_xz");
  product("yz", &P::yz, "I_yz");
  b.check([](const P& p, std::vector<Problem>& problems) {
    for (auto& problem : massProblems({1, {}, p.matrix()}, "")) problems.push_back(problem);
  });
}

void Describe<DirectMass>::fields(schema::Builder<DirectMass>& b) {
  using P = DirectMass;
  b.title("direct", "Given directly",
          "Mass, centre of mass and inertia of the whole vehicle, its rotors included.");
  b.number("mass", &P::mass, "Mass", "m", "kg")
      .range(schema::above(0), schema::upTo(1e4))
      .shownIn("g")
      .source("JSBSim aircraft F450, Mass.xml");
  b.vector("centreOfMass", &P::centreOfMass, "Centre of mass", "r_c", "m")
      .range(schema::atLeast(-10), schema::upTo(10))
      .help("From the centre of the rotor layout, x forward, y left, z up.");
  b.group("inertia", &P::inertia, "Inertia");
}

void Describe<PartsMass>::fields(schema::Builder<PartsMass>& b) {
  using P = PartsMass;
  b.title("parts", "From parts",
          "A solid sphere in the middle and a point mass at every hub: motor and propeller of the "
          "rotor.",
          "Thesis 2014, (3.7)-(3.9), yz entries of (3.8) corrected");
  b.number("bodyMass", &P::bodyMass, "Body mass", "m", "kg")
      .range(schema::above(0), schema::upTo(1e4))
      .shownIn("g")
      .help("Everything but motors, propellers and payloads.");
  b.number("bodyRadius", &P::bodyRadius, "Body radius", "r_s", "m")
      .range(schema::above(0), schema::upTo(10))
      .shownIn("cm")
      .help("Radius of the solid sphere the body is taken for.");
  b.vector("bodyPosition", &P::bodyPosition, "Body centre", "r_b", "m")
      .range(schema::atLeast(-10), schema::upTo(10))
      .help("From the centre of the rotor layout, x forward, y left, z up.")
      .advanced();
}

void Describe<PointMass>::fields(schema::Builder<PointMass>& b) {
  using P = PointMass;
  b.title("payload", "Payload", "A point mass fixed to the body.");
  b.number("mass", &P::mass, "Mass", "m", "kg")
      .range(schema::atLeast(0), schema::upTo(1e4))
      .shownIn("g");
  b.vector("position", &P::position, "Position", "r", "m")
      .range(schema::atLeast(-10), schema::upTo(10))
      .help("From the centre of the rotor layout, x forward, y left, z up.");
}

}  // namespace rotorbench
