#include "app/rotorbench-cli/edits.h"

#include <algorithm>

#include "sim/core/schema_tree.h"
#include "sim/experiment/experiment_file.h"

namespace rotorbench::cli {

void applyEdit(schema::Ref document, const std::string& edit) {
  const auto equals = edit.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("--set", {{edit, "is not an assignment",
                                "write path=value, for example setup.duration=20"}});
  }
  try {
    schema::setFromText(document, edit.substr(0, equals), edit.substr(equals + 1));
  } catch (const InputError& error) {
    throw InputError("--set", error.problems());
  }
}

Experiment loadEdited(const std::string& file, const std::vector<std::string>& edits) {
  Experiment experiment = loadExperiment(file);
  for (const auto& edit : edits) applyEdit(schema::ref(experiment), edit);
  auto problems = schema::validate(schema::ref(experiment));
  std::erase_if(problems, [](const Problem& p) { return p.warning; });
  if (!problems.empty()) throw InputError(edits.empty() ? file : "--set", problems);
  return experiment;
}

}  // namespace rotorbench::cli
