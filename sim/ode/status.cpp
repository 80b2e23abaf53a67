#include "sim/ode/status.h"

#include <cstdio>
#include <string>

namespace rotorbench::ode {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

}  // namespace

RunFailure describeFailure(const Failure& failure, std::string_view component) {
  const std::string at = " at t = " + number(failure.time) + " s";
  const std::string who(component);
  RunFailure result{failure.time, who, {}};
  switch (failure.kind) {
    case FailureKind::None:
      break;
    case FailureKind::NonFinite:
      result.message = "The solution is no longer finite" + at + " (state " + who +
                       "). A smaller step or an embedded method may help.";
      break;
    case FailureKind::StepUnderflow:
      result.message = "The solver would need a step below " + number(failure.step) + " s" + at +
                       " to keep the error of state " + who + " within the tolerance.";
      break;
    case FailureKind::BudgetExceeded:
      result.message = "The budget of " + std::to_string(failure.steps) +
                       " solver steps was used up" + at +
                       ". A larger step, tolerance or budget is needed.";
      break;
  }
  return result;
}

}  // namespace rotorbench::ode
