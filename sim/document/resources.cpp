#include "sim/document/resources.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment_file.h"

namespace rotorbench {

namespace fs = std::filesystem;

namespace {

/// Names of experiments in the order the gallery shows them: one a line in experiments/gallery.txt.
/// Those not named there follow by name.
std::vector<std::string> galleryOrder() {
  std::vector<std::string> names;
  std::ifstream file(resourceDirectory() / "experiments" / "gallery.txt");
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) names.push_back(line);
  }
  return names;
}

}  // namespace

fs::path resourceDirectory() {
  std::error_code error;
  if (const char* given = std::getenv("ROTORBENCH_RESOURCES"); given != nullptr && *given != '\0') {
    return given;
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "rotorbench";
  if (fs::is_directory(installed / "experiments", error)) return installed;
  const fs::path source = ROTORBENCH_SOURCE_RESOURCES;
  return fs::is_directory(source, error) ? source : fs::path();
}

std::vector<ShippedExperiment> shippedExperiments(std::vector<InputError>* faults) {
  std::vector<ShippedExperiment> all;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(resourceDirectory() / "experiments", error)) {
    if (entry.path().extension() != kExperimentSuffix) continue;
    try {
      const Experiment experiment = loadExperiment(entry.path());
      const auto kind = schema::get(schema::ref(experiment), "setup.type");
      all.push_back({entry.path(), entry.path().stem().string(), experiment.title,
                     experiment.summary, std::get<std::string>(kind)});
    } catch (const InputError& fault) {
      if (faults != nullptr) faults->push_back(fault);
    }
  }
  const auto order = galleryOrder();
  const auto rank = [&](const ShippedExperiment& e) {
    return std::pair(std::find(order.begin(), order.end(), e.name) - order.begin(), e.name);
  };
  std::sort(all.begin(), all.end(),
            [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return all;
}

}  // namespace rotorbench
