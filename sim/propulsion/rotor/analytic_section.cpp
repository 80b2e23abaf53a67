#include "sim/propulsion/rotor/analytic_section.h"

namespace rotorbench {

namespace {

constexpr double kReynoldsOfFit = 1e5;  // L = 0
constexpr double kChordOfFit = 0.18;    // c/R at which zeroLiftChord has no effect
constexpr double kLeastReynolds = 5e3;  // below and above the measured range
constexpr double kMostReynolds = 5e5;   // the constants stay as they are

/// ln(Re/1e5), the Reynolds number kept within its range without a kink at the ends: the sixth
/// powers are added below, their inverses above.
double limitedLog(double reynolds) {
  const auto sixth = [](double x) { return x * x * x * x * x * x; };
  const double raised = sixth(reynolds / kReynoldsOfFit) + sixth(kLeastReynolds / kReynoldsOfFit);
  return std::log(raised / (1 + raised / sixth(kMostReynolds / kReynoldsOfFit))) / 6;
}

}  // namespace

AnalyticCurve::AnalyticCurve(const SectionConstants& c, const SectionPlace& place,
                             double reynolds) {
  const double l = limitedLog(reynolds);
  slope_ = c.liftSlope * std::exp(c.liftSlopeReynolds * l);
  zeroLift_ = c.zeroLift + c.zeroLiftReynolds * l +
              c.zeroLiftChord * (place.chordToTipRadius - kChordOfFit) -
              (place.slowFlyer ? c.slowFlyerCamber : 0);
  inverseWidth_ = 1 / c.stallWidth;
  const double positiveStall = zeroLift_ + c.stallLift * std::exp(c.stallLiftReynolds * l) / slope_;
  const double negativeStall = zeroLift_ - c.negativeStallLift / slope_;
  positiveStallPower_ = std::exp(positiveStall * inverseWidth_);
  negativeStallPower_ = std::exp(negativeStall * inverseWidth_);
  delay_ = std::min(c.stallDelayLimit, c.stallDelay * place.chordToRadius * place.chordToRadius);
  fade_ = c.stallDelayFade;
  broadside_ = c.broadside;
  profileDrag_ = c.profileDrag * std::exp(c.profileDragReynolds * l);
  separatedDrag_ = c.separatedDragFactor * profileDrag_;
}

void Describe<SectionConstants>::fields(schema::Builder<SectionConstants>& b) {
  using C = SectionConstants;
  b.title("constants", "Constants of the section",
          "Lift slope, zero-lift angle, stall and drag of a typical model-propeller section, with "
          "L = ln(Re/100 000).",
          "One fit to 101 propellers of the UIUC Propeller Data Site");
  const auto number = [&b](const char* key, double C::*member, const char* label,
                           const char* symbol, const char* unit, double low, double high) {
    return b.number(key, member, label, symbol, unit)
        .range(schema::atLeast(low), schema::upTo(high));
  };
  number("liftSlope", &C::liftSlope, "Lift slope", "c_l\u03b1", "1", 0.1, 20)
      .help("Per radian, at a Reynolds number of 100 000.");
  number("liftSlopeReynolds", &C::liftSlopeReynolds, "Lift slope with Reynolds number", "", "1", -1,
         1)
      .help("The slope goes with exp(this L).");
  number("zeroLift", &C::zeroLift, "Zero-lift angle", "\u03b1_0", "rad", -0.5, 0.5)
      .shownIn("deg")
      .help("At a Reynolds number of 100 000 and a chord of 0.18 tip radii.");
  number("zeroLiftReynolds", &C::zeroLiftReynolds, "Zero-lift angle with Reynolds number", "",
         "rad", -0.5, 0.5)
      .help("Added per L.");
  number("zeroLiftChord", &C::zeroLiftChord, "Zero-lift angle with chord", "", "rad", -5, 5)
      .help("Added per chord in tip radii beyond 0.18: wide blades are thinner.");
  number("slowFlyerCamber", &C::slowFlyerCamber, "Camber of slow-flyer blades", "s", "rad", -0.5,
         0.5)
      .shownIn("deg")
      .help("Taken off the zero-lift angle of slow-flyer blades.");
  number("stallLift", &C::stallLift, "Lift at stall", "", "1", 0.1, 5)
      .help("At a Reynolds number of 100 000.");
  number("stallLiftReynolds", &C::stallLiftReynolds, "Lift at stall with Reynolds number", "", "1",
         -1, 1)
      .help("The stall lift goes with exp(this L).");
  number("negativeStallLift", &C::negativeStallLift, "Downward lift at stall", "", "1", 0.1, 5)
      .help("As a positive number.");
  number("stallWidth", &C::stallWidth, "Softness of the stall", "", "rad", 0.005, 0.5)
      .shownIn("deg")
      .help("Angle over which the flow separates.");
  number("stallDelay", &C::stallDelay, "Stall delay by rotation", "", "1", 0, 50)
      .help("Times (c/r)\u00b2: the share of the lift lost in stall that rotation keeps.")
      .source("Snel, Houwink, Bosschers, ECN-C-93-052: 3 (c/r)\u00b2");
  number("stallDelayLimit", &C::stallDelayLimit, "Largest stall delay", "", "1", 0, 1)
      .help("Largest share that rotation keeps.");
  number("stallDelayFade", &C::stallDelayFade, "Stall delay fades at", "", "rad", 0.1, 1.6)
      .shownIn("deg")
      .help("Angle of attack at which the delay has faded to one half.");
  number("profileDrag", &C::profileDrag, "Profile drag", "c_d0", "1", 0, 1)
      .help("Of attached flow at a Reynolds number of 100 000.");
  number("profileDragReynolds", &C::profileDragReynolds, "Profile drag with Reynolds number", "",
         "1", -2, 2)
      .help("The drag goes with exp(this L).");
  number("broadside", &C::broadside, "Force broadside to the flow", "", "1", 0.5, 4)
      .help("Normal-force coefficient of separated flow at 90 degrees.")
      .source("Hoerner, Fluid-Dynamic Drag, 1965: 2.0 for a plate without ends");
  number("separatedDragFactor", &C::separatedDragFactor, "Drag added by separation", "", "1", 0,
         100)
      .help("In profile drags, on top of the flat plate's.");
}

void Describe<AnalyticSection>::fields(schema::Builder<AnalyticSection>& b) {
  b.title("analytic", "Typical section",
          "A typical model-propeller section, for blades whose true section is unknown.");
  b.group("constants", &AnalyticSection::constants, "Constants").advanced();
}

}  // namespace rotorbench
