#include "sim/ode/solver_settings.h"

#include <string>
#include <utility>

namespace rotorbench {
namespace {

using ode::Norm;
using ode::StepController;

constexpr const char* kHairer = "Hairer, Norsett, Wanner: Solving ODEs I (1993), section II.4";

std::vector<schema::Named<Norm>> norms() {
  return {{Norm::Rms, "rms", "Root mean square", "Root of the mean of the squares."},
          {Norm::Euclidean, "euclidean", "Euclidean", "Root of the sum of the squares."},
          {Norm::Maximum, "maximum", "Maximum", "The largest component."}};
}

}  // namespace

void Describe<ode::ScaledErrorControl>::fields(schema::Builder<ode::ScaledErrorControl>& b) {
  using T = ode::ScaledErrorControl;
  using namespace schema;
  b.title("scaled", "Relative and absolute tolerance",
          "The error of each state component is measured against absolute tolerance + relative "
          "tolerance * size of the component.",
          kHairer);
  b.number("relativeTolerance", &T::relativeTolerance, "Relative tolerance", "rtol", "1")
      .range(atLeast(1e-15), upTo(1))
      .help("Local error allowed per step, relative to the size of each state component.");
  b.number("absoluteTolerance", &T::absoluteTolerance, "Absolute tolerance", "atol", "1")
      .range(above(0), upTo(1e6))
      .help("Local error allowed per step where a state component is near zero, in its SI unit.");
  b.choice("norm", &T::norm, "Error norm", norms()).advanced();
  b.choice("controller", &T::controller, "Step controller",
           {{StepController::Elementary, "elementary", "Elementary",
             "The next step follows from the last error alone."},
            {StepController::ProportionalIntegral, "pi", "PI",
             "The next step follows from the last two errors: smoother near the stability limit."}})
      .source("Hairer, Wanner: Solving ODEs II (1996), section IV.2")
      .advanced();
  b.number("safety", &T::safety, "Safety factor", "", "1")
      .range(atLeast(0.1), upTo(1))
      .help("The next step is this fraction of the one the error estimate would allow.")
      .advanced();
  b.number("keptChange", &T::keptChange, "Kept change", "", "1")
      .range(atLeast(0), upTo(0.5))
      .help(
          "A step that would change by less than this fraction is kept: steps that change all the "
          "time cost more than they save.")
      .advanced();
  b.number("shrinkLimit", &T::shrinkLimit, "Shrink limit", "", "1")
      .range(atLeast(0.001), below(1))
      .help("A step is at least this fraction of the one before.")
      .advanced();
  b.number("growthLimit", &T::growthLimit, "Growth limit", "", "1")
      .range(above(1), upTo(1e6))
      .help("A step is at most this multiple of the one before.")
      .advanced();
}

void Describe<ode::ThesisErrorControl>::fields(schema::Builder<ode::ThesisErrorControl>& b) {
  using T = ode::ThesisErrorControl;
  using namespace schema;
  b.title("thesis-2014", "Thesis 2014",
          "h_new = 0.9 h (tolerance / error)^(1/5), absolute tolerance, no limit on growth.",
          "Quadrotor Simulator (University of Aveiro, 2014), eq. (1.50)");
  b.number("tolerance", &T::tolerance, "Tolerance", "delta", "1")
      .range(atLeast(1e-15), upTo(1e6))
      .help("Largest norm of the local error of the whole state, in SI units.");
  b.choice("norm", &T::norm, "Error norm", norms())
      .help(
          "The equation is printed with the maximum norm; the published step counts come from the "
          "Euclidean norm.")
      .advanced();
}

void Describe<ode::SolverSettings>::fields(schema::Builder<ode::SolverSettings>& b) {
  using T = ode::SolverSettings;
  using namespace schema;
  b.title("solver", "Solver", "The method that integrates the equations of motion, and its step.",
          "Dormand, Prince (1980); Hairer, Norsett, Wanner (1993); Cox, Matthews (2002)");
  std::vector<Named<ode::Method>> methods;
  for (const auto& m : ode::kMethods) {
    methods.push_back({m.method, std::string(m.key), std::string(m.name), std::string(m.help)});
  }
  b.choice("method", &T::method, "Method", std::move(methods));
  b.number("step", &T::step, "Step", "h", "s")
      .range(above(0), upTo(3600))
      .shownIn("ms")
      .help(
          "Step of the fixed-step methods. Between two samples the steps are made equal and never "
          "longer than this.");
  b.variant("errorControl", &T::errorControl, "Error control")
      .help("How the embedded methods choose their step.");
  b.number("initialStep", &T::initialStep, "First step", "h0", "s")
      .range(atLeast(0), upTo(3600))
      .shownIn("ms")
      .help("First step the embedded methods try. 0: chosen from the derivatives.")
      .source(kHairer)
      .advanced();
  b.number("minimumStep", &T::minimumStep, "Smallest step", "", "s")
      .range(atLeast(0), upTo(3600))
      .shownIn("ms")
      .help(
          "The run fails where an embedded method would need a smaller step. 0: no limit but the "
          "resolution of time.")
      .advanced();
  b.number("maximumStep", &T::maximumStep, "Largest step", "", "s")
      .range(atLeast(0), upTo(1e6))
      .shownIn("ms")
      .help("The embedded methods never take a longer step. 0: no limit.")
      .advanced();
  b.integer("maximumSteps", &T::maximumSteps, "Step budget")
      .range(atLeast(1), upTo(1e12))
      .help("The run fails when one advance needs more steps than this.")
      .advanced();
  b.check([](const T& s, std::vector<Problem>& problems) {
    if (s.maximumStep > 0 && s.minimumStep > s.maximumStep) {
      problems.push_back({"minimumStep", "the smallest step is larger than the largest step",
                          "at most maximumStep"});
    }
    if (s.maximumStep > 0 && s.initialStep > s.maximumStep) {
      problems.push_back(
          {"initialStep", "the first step is larger than the largest step", "at most maximumStep"});
    }
  });
}

}  // namespace rotorbench
