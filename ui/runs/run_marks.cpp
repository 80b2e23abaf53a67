#include "ui/runs/run_marks.h"

#include <algorithm>

#include "sim/document/changes.h"
#include "ui/runs/run_list.h"

namespace rotorbench {

std::vector<RunMark> marksOf(const RunRecord& record) {
  std::vector<RunMark> marks;
  if (record.status.changes) {
    for (const Change& change : *record.status.changes)
      marks.push_back({change.time, QStringLiteral("%1 = %2").arg(
                                        QString::fromStdString(flightPath(change.parameter)),
                                        QString::fromStdString(change.value))});
  }
  for (const RunEvent& event : record.status.events)
    marks.push_back({event.time, QString::fromStdString(event.what)});
  std::ranges::stable_sort(marks, {}, &RunMark::time);
  return marks;
}

QString chartRunId(int id, std::size_t part) {
  return QStringLiteral("%1/%2").arg(id).arg(part);
}

}  // namespace rotorbench
