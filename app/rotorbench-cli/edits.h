// `--set path=value`, shared by the commands that change an experiment before they use it.
#pragma once

#include <string>
#include <vector>

#include "sim/experiment/experiment.h"

namespace rotorbench::cli {

/// The file with the edits applied in order. Throws InputError naming the file or the edit at fault; rules over
/// several parameters are checked once, after the last edit.
Experiment loadEdited(const std::string& file, const std::vector<std::string>& edits);

}  // namespace rotorbench::cli
