// `--set path=value`, shared by the commands that change an experiment before they use it.
#pragma once

#include <string>
#include <vector>

#include "sim/experiment/experiment.h"

namespace rotorbench::cli {

/// One path=value applied to a document. Throws InputError naming the edit.
void applyEdit(schema::Ref document, const std::string& edit);

/// The file with the edits applied in order. Throws InputError naming the file or the edit at fault; rules over
/// several parameters are checked once, after the last edit.
Experiment loadEdited(const std::string& file, const std::vector<std::string>& edits);

}  // namespace rotorbench::cli
