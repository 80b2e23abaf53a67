#include "sim/environment/wind.h"

namespace rotorbench {

using schema::above;
using schema::atLeast;
using schema::upTo;

void Describe<StillAir>::fields(schema::Builder<StillAir>& b) {
  b.title("still", "Still air", "No wind.");
}

void Describe<SteadyWind>::fields(schema::Builder<SteadyWind>& b) {
  b.title("steady", "Steady wind", "The air moves at the same velocity everywhere and always.");
  b.vector("velocity", &SteadyWind::velocity, "Wind velocity", "w", "m/s")
      .range(atLeast(-100), upTo(100))
      .help(
          "Where the air goes, over the ground: x forward, y left, z up. Wind from ahead has a "
          "negative x.")
      .live();
}

void Describe<LogarithmicWind>::fields(schema::Builder<LogarithmicWind>& b) {
  using P = LogarithmicWind;
  b.title("logarithmic", "Wind over height",
          "Wind over flat ground: its speed rises with the logarithm of the height, w(h) = w_r "
          "ln(h/z\u2080)/ln(h_r/z\u2080), and is 0 below z\u2080.",
          "Stull, An Introduction to Boundary Layer Meteorology, 1988, chapter 9");
  b.vector("velocity", &P::velocity, "Wind velocity", "w_r", "m/s")
      .range(atLeast(-100), upTo(100))
      .components({"x", "y"})
      .help("At the reference height. Where the air goes: x forward, y left.")
      .live();
  b.number("referenceHeight", &P::referenceHeight, "Reference height", "h_r", "m")
      .range(above(0), upTo(1000))
      .help("Above the ground; weather stations measure at 10 m.")
      .live()
      .source("WMO-No. 8, Guide to Instruments and Methods of Observation");
  b.number("roughness", &P::roughness, "Roughness length", "z\u2080", "m")
      .range(above(0), upTo(10))
      .help(
          "0.0002 over open sea, 0.03 over short grass, 0.1 over low crops, 0.5 over bushes, 1 and "
          "more over towns and forests.")
      .live()
      .source("Davenport classification, WMO-No. 8");
  b.number("ground", &P::ground, "Ground", "", "m")
      .range(atLeast(-1e5), upTo(1e5))
      .help("Height of the ground in the coordinates of the flight.")
      .advanced()
      .live();
  b.check([](const P& p, std::vector<Problem>& problems) {
    if (p.roughness < p.referenceHeight) return;
    problems.push_back({"roughness", "is not below the reference height",
                        "a roughness length below the reference height"});
  });
}

}  // namespace rotorbench
