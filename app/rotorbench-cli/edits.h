// `--set path=value`, and what is doubtful of what came of it: shared by the commands that read a
// document.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/document/experiment.h"

namespace rotorbench::cli {

inline constexpr const char* kExperimentHelp =
    "Experiment file, or the name of a shipped experiment as list prints it";

/// Applies each path=value to a document; what follows from the changes (as many inputs as rotors)
/// then follows. Throws InputError naming the edit.
void applyEdits(schema::Ref document, const std::vector<std::string>& edits);

/// The file of an experiment that is given by its path, or by the name `list` prints for a shipped
/// one where no such file exists.
std::filesystem::path experimentFile(const std::string& given);

/// The experiment that experimentFile() finds, with the edits applied in order. Throws InputError
/// naming the file or the edit at fault; rules over several parameters are checked once, after the
/// last edit. What is doubtful, or will keep it from running, is said on stderr.
Experiment loadEdited(const std::string& file, const std::vector<std::string>& edits);

/// The problems of a document: warnings among them are said on stderr and returned, others thrown
/// as InputError.
std::vector<Problem> sayWarnings(const std::string& source, std::vector<Problem> problems);

}  // namespace rotorbench::cli
