#include "sim/vehicle/geometry.h"

#include <cmath>
#include <numbers>
#include <string>

namespace rotorbench {

namespace {

/// `offset`: angle of the first rotor in steps between rotors.
template <class Layout>
std::vector<RotorPlacement> ring(const Layout& layout, double offset) {
  const int count = static_cast<int>(layout.count);
  const double arm = layout.arm, height = layout.height;
  const Spin first = layout.firstSpin;
  std::vector<RotorPlacement> rotors;
  const Spin second = first == Spin::CounterClockwise ? Spin::Clockwise : Spin::CounterClockwise;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + offset) / count;
    rotors.push_back({{arm * std::cos(angle), arm * std::sin(angle), height},
                      Eigen::Vector3d::UnitZ(),
                      i % 2 == 0 ? first : second});
  }
  return rotors;
}

std::vector<schema::Named<Spin>> spins() {
  return {{Spin::CounterClockwise, "counter-clockwise", "Counter-clockwise", "Seen from above."},
          {Spin::Clockwise, "clockwise", "Clockwise", "Seen from above."}};
}

template <class P>
void describeRing(schema::Builder<P>& b, const char* armSource, const char* firstHelp) {
  b.choice("count", &P::count, "Number of rotors",
           std::vector<schema::Named<RingCount>>{
               {RingCount::Four, "quad", "4 (quadrotor)", "Every 90 degrees."},
               {RingCount::Six, "hexa", "6 (hexarotor)", "Every 60 degrees."},
               {RingCount::Eight, "octo", "8 (octorotor)", "Every 45 degrees."}})
      .help("Counter-clockwise from the front at equal angles, neighbours turning oppositely.");
  b.number("arm", &P::arm, "Arm length", "r", "m")
      .range(schema::above(0), schema::upTo(20))
      .shownIn("cm")
      .help("From the centre to each hub.")
      .source(armSource);
  b.number("height", &P::height, "Hub height", "h", "m")
      .range(schema::atLeast(-10), schema::upTo(10))
      .shownIn("cm")
      .help("Of the rotor plane above the centre of the body frame.")
      .source(armSource);
  b.choice("firstSpin", &P::firstSpin, "First rotor turns", spins()).help(firstHelp);
}

}  // namespace

int rotorCount(const RotorLayout& layout) {
  if (const auto* plus = std::get_if<PlusLayout>(&layout)) return static_cast<int>(plus->count);
  if (const auto* cross = std::get_if<CrossLayout>(&layout)) return static_cast<int>(cross->count);
  return static_cast<int>(std::get<FreeLayout>(layout).rotors.size());
}

std::vector<RotorPlacement> placeRotors(const RotorLayout& layout) {
  if (const auto* plus = std::get_if<PlusLayout>(&layout)) return ring(*plus, 0);
  if (const auto* cross = std::get_if<CrossLayout>(&layout)) return ring(*cross, 0.5);
  std::vector<RotorPlacement> rotors = std::get<FreeLayout>(layout).rotors;
  for (auto& rotor : rotors) rotor.axis.normalize();
  return rotors;
}

void Describe<PlusLayout>::fields(schema::Builder<PlusLayout>& b) {
  b.title("plus", "Plus",
          "One rotor ahead on the x axis, the others counter-clockwise at equal angles; of four: 1 "
          "front, 2 left, 3 rear, 4 right.",
          "Thesis 2014, figure 3.2 and (3.3)-(3.6)");
  describeRing(b, "Half of the 450 mm diagonal of the DJI F450",
               "Rotor 1 is ahead; neighbours turn oppositely.");
}

void Describe<CrossLayout>::fields(schema::Builder<CrossLayout>& b) {
  b.title(
      "cross", "Cross",
      "Forward lies between the two front rotors, which are 1 on the left and the last one on the "
      "right; of four: 1 front left, 2 rear left, 3 rear right, 4 front right.");
  describeRing(b, "JSBSim aircraft F450, Propulsion.xml: 0.1651 m along x and y",
               "Rotor 1 is ahead on the left; neighbours turn oppositely.");
}

void Describe<RotorPlacement>::fields(schema::Builder<RotorPlacement>& b) {
  using P = RotorPlacement;
  b.title("placement", "Rotor place", "Where one rotor sits, its thrust axis and its spin.");
  b.vector("position", &P::position, "Hub", "r", "m")
      .range(schema::atLeast(-20), schema::upTo(20))
      .help("x forward, y left, z up.");
  b.vector("axis", &P::axis, "Thrust axis", "a", "1")
      .range(schema::atLeast(-1), schema::upTo(1))
      .help("Direction of the thrust; only the direction counts.");
  b.choice("spin", &P::spin, "Turns", spins());
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (!(p.axis.norm() > 1e-6)) {
      problems.push_back({"axis", "the thrust axis has no direction", "a vector other than zero"});
    }
  });
}

void Describe<FreeLayout>::fields(schema::Builder<FreeLayout>& b) {
  b.title("free", "Free", "Every hub, thrust axis and spin given by hand: 4, 6 or 8 of them.");
  b.list("rotors", &FreeLayout::rotors, "Rotors").items(4, 8).table();
  b.check([](const FreeLayout& p, std::vector<Problem>& problems) {
    if (p.rotors.size() % 2 == 0) return;
    problems.push_back(
        {"rotors", "there are " + std::to_string(p.rotors.size()), "4, 6 or 8 rotors"});
  });
}

}  // namespace rotorbench
