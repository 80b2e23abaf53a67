#include "sim/run/birotor_view.h"

namespace rotorbench {

namespace {

std::vector<Channel> sharedChannels() {
  return {{"position.y", "m", "Middle of the bar, inertial y"},
          {"position.z", "m", "Middle of the bar, inertial z (up)"},
          {"velocity.y", "m/s", "Velocity of the middle of the bar along y"},
          {"velocity.z", "m/s", "Velocity of the middle of the bar along z"},
          {"angle", "rad", "Angle of the bar from y towards z, unwrapped"},
          {"angular_velocity", "rad/s", "Rate of the angle"},
          {"rotor1.thrust", "N", "Force of rotor 1, square to the bar"},
          {"rotor2.thrust", "N", "Force of rotor 2, square to the bar"},
          {"energy", "J", "Kinetic, potential and elastic energy"}};
}

}  // namespace

std::vector<Channel> BirotorView<RigidBarBirotor>::channels() {
  return sharedChannels();
}

void BirotorView<RigidBarBirotor>::row(const RigidBarBirotor& plant,
                                       const RigidBarBirotor::State& y, double* out) {
  const double values[] = {y[0],
                           y[2],
                           y[1],
                           y[3],
                           y[4],
                           y[5],
                           plant.parameters().force1,
                           plant.parameters().force2,
                           plant.energy(y)};
  std::copy(std::begin(values), std::end(values), out);
}

std::vector<Metric> BirotorView<RigidBarBirotor>::endMetrics(const RigidBarBirotor& plant, double t,
                                                             const RigidBarBirotor::State& y) {
  return {{"end_angular_velocity", "rad/s", "Angular velocity at the end", y[5]},
          {"end_angular_velocity_physical", "rad/s",
           "The exact one with physical damping of the rotation",
           plant.angularVelocityAt(t, BirotorDamping::Physical)},
          {"end_angular_velocity_thesis_2014", "rad/s",
           "The exact one with the damping of the 2014 thesis, which is weaker by the arm length",
           plant.angularVelocityAt(t, BirotorDamping::Thesis2014)}};
}

std::vector<Channel> BirotorView<SpringBarBirotor>::channels() {
  auto all = sharedChannels();
  all.insert(all.end(),
             {{"body1.y", "m", "Body 1, inertial y"},
              {"body1.z", "m", "Body 1, inertial z"},
              {"body2.y", "m", "Body 2, inertial y"},
              {"body2.z", "m", "Body 2, inertial z"},
              {"bar.length", "m", "Distance of the bodies"},
              {"bar.force", "N",
               "Force of spring and damper, positive where it pushes the bodies apart"}});
  return all;
}

void BirotorView<SpringBarBirotor>::row(const SpringBarBirotor& plant,
                                        const SpringBarBirotor::State& y, double* out) {
  const double raw = SpringBarBirotor::angle(y);
  angle_ = started_ ? angle_ + std::remainder(raw - angle_, 2 * std::numbers::pi) : raw;
  started_ = true;
  const auto bar = plant.bar(y);
  const double values[] = {(y[0] + y[4]) / 2,
                           (y[2] + y[6]) / 2,
                           (y[1] + y[5]) / 2,
                           (y[3] + y[7]) / 2,
                           angle_,
                           SpringBarBirotor::angularVelocity(y),
                           plant.parameters().force1,
                           plant.parameters().force2,
                           plant.energy(y),
                           y[0],
                           y[2],
                           y[4],
                           y[6],
                           bar.length,
                           bar.force};
  std::copy(std::begin(values), std::end(values), out);
}

std::vector<Metric> BirotorView<SpringBarBirotor>::endMetrics(const SpringBarBirotor& /*plant*/,
                                                              double /*t*/,
                                                              const SpringBarBirotor::State& y) {
  return {{"end_angular_velocity", "rad/s", "Angular velocity at the end",
           SpringBarBirotor::angularVelocity(y)}};
}

}  // namespace rotorbench
