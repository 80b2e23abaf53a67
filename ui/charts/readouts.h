// What the cursors of a chart read: for each curve the last sample not after the cursor's time, and
// the difference between the two cursors.
#pragma once

#include <QLocale>
#include <QStringList>
#include <vector>

#include "ui/charts/chart_link.h"
#include "ui/charts/curves.h"

namespace rotorbench {

struct Readouts {
  QStringList heads;  ///< "A  1.25 s", "B  2 s", "B − A  0.75 s"; empty without cursors
  std::vector<QStringList> cells;  ///< per curve, as many as heads
};

Readouts makeReadouts(const std::vector<Curve>& curves, const ChartLink& link,
                      const QLocale& locale);

/// Five significant digits with the unit: "3.4213 N".
QString readoutText(double value, const std::string& unit, const QLocale& locale);

}  // namespace rotorbench
