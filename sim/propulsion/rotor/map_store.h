// Propeller maps kept on disk, so that a propeller is tabulated once and not in every session. The
// files are a cache: whatever is wrong with one (cut, old, of another machine) means that the map
// is made anew, and a folder that cannot be written keeps nothing. Two programs may write at once:
// a file comes into being whole or not at all. The least used go when they take too much room.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "sim/propulsion/rotor/rotor_models.h"

namespace rotorbench {

class MapStore {
 public:
  static constexpr std::uintmax_t kMostBytes = 300'000'000;

  /// An empty folder: nothing is kept. It is made when it is first needed.
  explicit MapStore(std::filesystem::path folder, std::uintmax_t mostBytes = kMostBytes)
      : folder_(std::move(folder)), most_(mostBytes) {}

  /// Where the user's maps are: ROTORBENCH_CACHE (empty: nowhere), else "rotorbench/maps" in
  /// XDG_CACHE_HOME or in ~/.cache.
  static std::filesystem::path userFolder();

  /// The map of this propeller, of whose settings `rotor` was made; nothing if it is not there.
  [[nodiscard]] std::optional<PropellerMap> find(const MapPropeller& propeller,
                                                 const BladeElementRotor& rotor) const;
  void keep(const MapPropeller& propeller, const BladeElementRotor& rotor,
            const PropellerMap& map) const;

  /// Name of the file: it follows from every parameter and from loads of the rotor at some states,
  /// so that neither another propeller nor another version of the blade elements finds it.
  static std::string fileName(const MapPropeller& propeller, const BladeElementRotor& rotor);

 private:
  void makeRoom() const;

  std::filesystem::path folder_;
  std::uintmax_t most_;
};

}  // namespace rotorbench
