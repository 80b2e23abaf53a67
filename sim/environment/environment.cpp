#include "sim/environment/environment.h"

namespace rotorbench {

namespace {

struct WindInto {
  AirConstants& air;
  void operator()(const StillAir& /*wind*/) const {}
  void operator()(const SteadyWind& w) const {
    set(w.velocity.x(), w.velocity.y(), w.velocity.z());
  }
  void operator()(const LogarithmicWind& w) const {
    set(w.velocity.x(), w.velocity.y(), 0);
    air.overHeight = air.moving;
    air.ground = w.ground;
    air.inverseRoughness = 1 / w.roughness;
    air.inverseLogarithm = 1 / std::log(w.referenceHeight / w.roughness);
  }
  void set(double x, double y, double z) const {
    air.wind = {x, y, z};
    // Even a wind of 0: it may rise during a flight.
    air.moving = true;
  }
};

}  // namespace

AirConstants buildAir(const EnvironmentParameters& environment) {
  AirConstants air;
  if (const auto* uniform = std::get_if<UniformAir>(&environment.air)) {
    air.uniform = uniform->density;
  } else {
    const auto& standard = std::get<StandardAir>(environment.air);
    air.standard = true;
    air.elevation = standard.elevation;
    air.warmer = standard.warmer;
  }
  std::visit(WindInto{air}, environment.wind);
  return air;
}

void Describe<UniformAir>::fields(schema::Builder<UniformAir>& b) {
  b.title("uniform", "Uniform air", "Air of the same density at every height.");
  b.number("density", &UniformAir::density, "Air density", "\u03c1", "kg/m^3")
      .range(schema::atLeast(0), schema::upTo(100))
      .help("1.225 at sea level and 15 \u00b0C; 0 takes the air away.")
      .source("International Standard Atmosphere, ISO 2533:1975");
}

void Describe<StandardAir>::fields(schema::Builder<StandardAir>& b) {
  using P = StandardAir;
  b.title("standard", "Standard atmosphere",
          "Air that gets thinner with height. Beyond 5 km below and 20 km above mean sea level its "
          "density stays as it is there.",
          "International Standard Atmosphere, ISO 2533:1975");
  b.number("elevation", &P::elevation, "Elevation", "h\u2080", "m")
      .range(schema::atLeast(isa::kLow), schema::upTo(isa::kHigh))
      .help("Of height 0 of the flight above mean sea level.");
  b.number("warmer", &P::warmer, "Warmer than standard", "\u0394T", "K")
      .range(schema::atLeast(-80), schema::upTo(80))
      .help(
          "Difference to the standard temperature (15 \u00b0C at sea level, 6.5 K less each km) at "
          "the same pressure.");
}

void Describe<EnvironmentParameters>::fields(schema::Builder<EnvironmentParameters>& b) {
  b.title("environment", "Environment", "Gravity, the air around the vehicle and its wind.");
  b.number("gravity", &EnvironmentParameters::gravity, "Gravity", "g", "m/s^2")
      .range(schema::atLeast(0), schema::upTo(100))
      .help("Acts straight down. 0 lets the vehicle float.")
      .source("Standard gravity, 3rd CGPM 1901");
  b.variant("air", &EnvironmentParameters::air, "Air");
  b.variant("wind", &EnvironmentParameters::wind, "Wind");
}

}  // namespace rotorbench
