// What a solver tells about its work: how a call ended, what failed and where, and what it cost.
// Nothing is thrown inside a run; failures are values. Times in s.
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/core/error.h"

namespace rotorbench::ode {

enum class Status {
  Done,     ///< the end of the span was reached
  Stopped,  ///< a terminal event or the observer ended the span early
  Failed    ///< see failure(); the state is the last good one
};

enum class FailureKind { None, NonFinite, StepUnderflow, BudgetExceeded };

struct Failure {
  FailureKind kind = FailureKind::None;
  double time = 0;         ///< start of the step that failed
  int component = -1;      ///< state component to blame, -1 if none can be named
  double step = 0;         ///< length of the step that failed
  std::int64_t steps = 0;  ///< steps taken in this call
};

/// The failure as a sentence for the user; `component` is the name of the state component, if any.
RunFailure describeFailure(const Failure& failure, std::string_view component);

/// Counted since construction or reset().
struct Statistics {
  std::int64_t steps = 0;        ///< accepted steps
  std::int64_t rejected = 0;     ///< steps tried and thrown away
  std::int64_t evaluations = 0;  ///< calls of the right-hand side
  [[nodiscard]] std::int64_t attempts() const { return steps + rejected; }
};

}  // namespace rotorbench::ode
