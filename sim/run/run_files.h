// The files a finished run leaves in a directory: the same names and bytes from the window and the
// command line.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "sim/core/run_summary.h"
#include "sim/document/experiment.h"
#include "sim/run/simulation.h"

namespace rotorbench {

/// "recording.csv" for an experiment with one run, "recording-RK5-4-7M.csv" where it has several.
std::string recordingFileName(const std::string& runName, std::size_t runCount);

/// Makes the directory if needed. Throws InputError if that is impossible, so that a long run does
/// not find out at its end.
void prepareRunDirectory(const std::filesystem::path& directory);

/// Writes experiment.json, metrics.json, metrics.txt and one CSV per run; returns the files. Throws
/// InputError.
std::vector<std::filesystem::path> writeRunFiles(const std::filesystem::path& directory,
                                                 const Experiment& experiment,
                                                 const std::vector<RunOutput>& runs,
                                                 const RunSummary& summary);

/// The runs as one CSV. Those that share their channels with the most others stand below each
/// other behind a first column `run`: the compared methods. Where each run has its own, as on a
/// bench, the one of them that is over time. writeRunFiles() keeps all.
void writeRunsCsv(std::ostream& out, const std::vector<RunOutput>& runs);

}  // namespace rotorbench
