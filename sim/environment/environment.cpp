#include "sim/environment/environment.h"

namespace rotorbench {

AirConstants buildAir(const AirModel& model) {
  return std::visit([](const UniformAir& air) { return AirConstants{air.density}; }, model);
}

void Describe<UniformAir>::fields(schema::Builder<UniformAir>& b) {
  b.title("uniform", "Uniform air", "Air of the same density at every height.");
  b.number("density", &UniformAir::density, "Air density", "\u03c1", "kg/m^3")
      .range(schema::atLeast(0), schema::upTo(100))
      .help("1.225 at sea level and 15 \u00b0C; 0 takes the air away.")
      .source("International Standard Atmosphere, ISO 2533:1975");
}

void Describe<EnvironmentParameters>::fields(schema::Builder<EnvironmentParameters>& b) {
  b.title("environment", "Environment", "Gravity and the air around the vehicle.");
  b.number("gravity", &EnvironmentParameters::gravity, "Gravity", "g", "m/s^2")
      .range(schema::atLeast(0), schema::upTo(100))
      .help("Acts straight down. 0 lets the vehicle float.")
      .source("Standard gravity, 3rd CGPM 1901");
  b.variant("air", &EnvironmentParameters::air, "Air");
}

}  // namespace rotorbench
