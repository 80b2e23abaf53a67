// What happened to a run at an instant, for charts and playback.
#pragma once

#include <QString>
#include <vector>

namespace rotorbench {

struct RunRecord;

struct RunMark {
  double time = 0;  ///< s
  QString text;     ///< "control.controller.roll.kp = 30", "motor 2 saturated"
};

/// All that has changed while the run went on, or is going to, and what happened on the way (sim's
/// RunEvent), in the order of time.
std::vector<RunMark> marksOf(const RunRecord& record);

/// Id by which charts know output `part` of a run.
QString chartRunId(int id, std::size_t part);

}  // namespace rotorbench
