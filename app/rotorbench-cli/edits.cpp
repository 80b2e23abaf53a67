#include "app/rotorbench-cli/edits.h"

#include <algorithm>
#include <iostream>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment_file.h"
#include "sim/document/resources.h"
#include "sim/run/preflight.h"

namespace rotorbench::cli {

namespace {

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

}  // namespace

void applyEdits(schema::Ref document, const std::vector<std::string>& edits) {
  for (const auto& edit : edits) applyEdit(document, edit);
  if (edits.empty()) return;
  for (const auto& loose : schema::looseFollowers(document))
    loose.follower->follow(loose.owner.object);
}

std::filesystem::path experimentFile(const std::string& given) {
  std::error_code error;
  if (given.find('/') != std::string::npos || std::filesystem::exists(given, error)) return given;
  std::vector<std::string> names;
  for (const ShippedExperiment& e : shippedExperiments()) {
    if (e.name == given) return e.file;
    names.push_back(e.name);
  }
  const auto near = schema::nearest(given, names);
  throw InputError(given,
                   {{{},
                     "there is no such file, and no shipped experiment of this name",
                     near ? "nearest is " + *near : "rotorbench-cli list prints the names"}});
}

Experiment loadEdited(const std::string& file, const std::vector<std::string>& edits) {
  Experiment experiment = loadExperiment(experimentFile(file));
  applyEdits(schema::ref(experiment), edits);
  const std::string source = edits.empty() ? file : "--set";
  sayWarnings(source, schema::validate(schema::ref(experiment)));
  std::vector<Problem> found = runWarnings(experiment);
  // What only the run refuses must not keep a file from being changed.
  for (Problem& problem : found) problem.warning = true;
  sayWarnings(source, std::move(found));
  return experiment;
}

std::vector<Problem> sayWarnings(const std::string& source, std::vector<Problem> problems) {
  std::vector<Problem> warnings, errors;
  for (Problem& problem : problems)
    (problem.warning ? warnings : errors).push_back(std::move(problem));
  if (!errors.empty()) throw InputError(source, std::move(errors));
  for (const Problem& warning : warnings) {
    std::cerr << source << (source.empty() ? "" : ":") << "warning: " << warning.message() << '\n';
  }
  return warnings;
}

}  // namespace rotorbench::cli
