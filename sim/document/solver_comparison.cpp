#include <algorithm>

#include "sim/document/solver_comparison.h"

namespace rotorbench {

namespace {

/// Steps of the reference that fit into memory comfortably.
constexpr double kMostReferenceSteps = 5e6;

void checkComparison(const SolverComparison& c, std::vector<Problem>& problems) {
  for (std::size_t i = 0; i < c.methods.size(); ++i) {
    const std::string path = "methods[" + std::to_string(i) + "].method";
    if (c.methods[i].method == ode::Method::ExponentialRk4) {
      problems.push_back(
          {path, "Exponential RK4 needs motors, and a birotor has none", "choose another method"});
    }
    if (std::find(c.methods.begin(), c.methods.begin() + static_cast<std::ptrdiff_t>(i),
                  c.methods[i]) != c.methods.begin() + static_cast<std::ptrdiff_t>(i)) {
      problems.push_back({path, "is compared twice", "name each method once"});
    }
  }
  if (c.duration / c.referenceStep > kMostReferenceSteps) {
    problems.push_back({"referenceStep", "the reference would take more than 5 million steps",
                        "a larger step or a shorter duration"});
  }
  if (c.sampleInterval > c.duration) {
    problems.push_back({"sampleInterval", "is longer than the duration", "at most the duration"});
  }
}

}  // namespace

void Describe<ComparedMethod>::fields(schema::Builder<ComparedMethod>& b) {
  b.title("method", "Method", "One solver of the comparison.");
  std::vector<schema::Named<ode::Method>> methods;
  for (const auto& m : ode::kMethods) {
    methods.push_back({m.method, std::string(m.key), std::string(m.name), std::string(m.help)});
  }
  b.choice("method", &ComparedMethod::method, "Method", std::move(methods));
}

void Describe<SolverComparison>::fields(schema::Builder<SolverComparison>& b) {
  using T = SolverComparison;
  b.title(
      "solver-comparison", "Solver comparison",
      "One problem integrated by several methods, each compared with a reference of small step.",
      "Thesis 2014, experiments 1 and 2");
  b.variant("plant", &T::plant, "Problem");
  b.choice<DrivingMode>(
      "mode", &T::mode, "Driving",
      {{DrivingMode::Sampled, "sampled", "Sampled",
        "A step never crosses a sample instant, as where a controller reads the state there. "
        "Errors are taken at the instants."},
       {DrivingMode::Free, "free", "Free",
        "Each method runs over the whole span in one go and chooses its steps. Errors are taken at "
        "its own steps, against the reference at exactly that time."}});
  b.number("sampleInterval", &T::sampleInterval, "Step and sample interval", "h", "s")
      .range(schema::atLeast(1e-9), schema::upTo(10))
      .shownIn("ms")
      .help("Interval of the sample instants, and the step of the fixed-step methods.");
  b.number("duration", &T::duration, "Duration", "T", "s")
      .range(schema::above(0), schema::upTo(36000));
  b.list("methods", &T::methods, "Methods").items(1, 16).table();
  b.variant("errorControl", &T::errorControl, "Error control")
      .help("How the embedded methods choose their step.");
  b.number("referenceStep", &T::referenceStep, "Reference step", "", "s")
      .range(schema::above(0), schema::upTo(1))
      .shownIn("ms")
      .help("Step of the RK4 solution every method is compared with.")
      .source("Thesis 2014, section 2.2: 0.2 ms");
  b.boolean("workPrecision", &T::workPrecision, "Work-precision diagram")
      .help("Runs every method again with seven steps or tolerances, to show error against cost.");
  b.check(checkComparison);
}

}  // namespace rotorbench
