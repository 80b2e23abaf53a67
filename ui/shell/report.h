// The pictures of a finished run without a window on a screen: the charts of the experiment as the
// window would export them, and the 3D view. Needs a QApplication (QT_QPA_PLATFORM=offscreen will
// do).
#pragma once

#include <filesystem>
#include <vector>

#include "sim/document/experiment.h"
#include "sim/run/simulation.h"

namespace rotorbench {

/// Writes "1-TITLE.png" and so on for outputs.charts and, where the experiment has a vehicle,
/// "scene.png" into `directory`, which is made if needed. Returns the files written. Throws
/// InputError if one cannot be written.
std::vector<std::filesystem::path> writeReportImages(const Experiment& experiment,
                                                     const std::vector<RunOutput>& runs,
                                                     const std::filesystem::path& directory);

}  // namespace rotorbench
