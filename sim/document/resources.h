// Where the files shipped with the program are: experiments, help pages, icons.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/error.h"

namespace rotorbench {

/// The resources folder: $ROTORBENCH_RESOURCES, else ../share/rotorbench beside an installed
/// program, else the folder of the source tree this program was built from. Empty if none exists.
std::filesystem::path resourceDirectory();

/// A ready experiment of the gallery.
struct ShippedExperiment {
  std::filesystem::path file;
  std::string name;  ///< file name without ending: "f450-hover-and-steps"
  std::string title;
  std::string summary;
  std::string kind;  ///< key of the setup alternative: "flight"
};

/// All shipped experiments in gallery order (the flagship first). One that cannot be read is left
/// out and told in `faults`, where given.
std::vector<ShippedExperiment> shippedExperiments(std::vector<InputError>* faults = nullptr);

}  // namespace rotorbench
