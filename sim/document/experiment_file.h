// Experiment files: versioned JSON, read with every violation reported at once, written so that
// they read back equal.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/document/experiment.h"

namespace rotorbench {

/// Ending of experiment files on disk, with the dot.
inline constexpr std::string_view kExperimentSuffix = ".json";

/// Reads an experiment from text; `source` names it in messages. Throws InputError with every
/// problem.
Experiment readExperiment(std::string_view text, const std::string& source);

/// Reads an experiment from a file. Throws InputError.
Experiment loadExperiment(const std::filesystem::path& file);

/// The text of an experiment file; reads back equal.
std::string writeExperiment(const Experiment& experiment);

/// Writes the file in one step: a crash leaves the old or the new file, never half of one. Throws
/// InputError.
void saveExperiment(const Experiment& experiment, const std::filesystem::path& file);

/// JSON Schema of experiment files.
std::string experimentJsonSchema();

}  // namespace rotorbench
