// Figures of a step response as control engineers read them (Ogata, Modern Control Engineering,
// section 5.3), from a recorded signal.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/core/recording.h"

namespace rotorbench {

/// The piece of a recorded signal that answers one set-point step: rows [firstRow, endRow) of
/// `channel`, the set-point going from `before` to `after` at the first row. Units are the
/// channel's.
struct StepWindow {
  std::size_t channel = 0;
  std::size_t firstRow = 0;
  std::size_t endRow = 0;
  double before = 0;
  double after = 0;
};

/// NaN marks a figure that does not exist (the signal never got there).
struct StepFigures {
  double riseTime;  ///< s from 10 % to 90 % of the step
  /// Largest excess beyond the set-point as a fraction of the step, never negative.
  double overshoot;
  /// s from the step until the signal stays within 2 % of the step around the set-point.
  double settlingTime;
  /// Largest |signal - set-point| in the last tenth of the window, in the channel's unit.
  double restError;
};

/// Needs at least two rows and before != after for the relative figures; restError exists with one
/// row.
StepFigures stepFigures(const Recording& recording, const StepWindow& window);

/// The set-point takes a value at a time in s and keeps it until the next change.
struct SetPointChange {
  double time = 0;
  double value = 0;
};

/// The worst of each figure over a timeline of set-points, from the channel's first value on. The
/// settling time is NaN if one step never settled.
StepFigures worstFigures(const Recording& recording, std::size_t channel,
                         const std::vector<SetPointChange>& changes);

}  // namespace rotorbench
