// The colours of runs: Okabe and Ito's palette (2008), which stays distinct for colour-blind
// readers, without its yellow and black, which vanish on a light or a dark ground.
#pragma once

#include <QColor>

namespace rotorbench {

inline constexpr int kRunColorCount = 7;

/// The colour of run number `index` (0-based); repeats after kRunColorCount.
QColor runColor(int index);

}  // namespace rotorbench
