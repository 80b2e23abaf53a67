#include "sim/validation/uiuc_data.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/core/error.h"
#include "sim/io/csv.h"
#include "sim/io/file.h"

namespace rotorbench::validation {

namespace {

namespace fs = std::filesystem;

/// A column of small whole numbers, each below `limit`.
std::vector<std::size_t> indices(const CsvTable& table, const char* name, std::size_t limit) {
  std::vector<std::size_t> whole;
  for (const double value : table.values(name, "1")) {
    if (!(value >= 0) || value >= static_cast<double>(limit)) {
      throw InputError(table.source,
                       {{name, "a number is out of range", "0 to " + std::to_string(limit - 1)}});
    }
    whole.push_back(static_cast<std::size_t>(value));
  }
  return whole;
}

std::vector<PropellerSet> readHeads(const fs::path& folder) {
  const CsvTable table = readCsvFile(folder / "sets.csv");
  const auto volume = table.values("volume", "1"), blades = table.values("blades", "1");
  const auto diameter = table.values("diameter", "m"), pitch = table.values("pitch_ratio", "1");
  const auto slow = table.values("slow_flyer", "1");
  std::istringstream names(readTextFile(folder / "names.txt"));
  std::vector<PropellerSet> sets(table.rows());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    PropellerSet& set = sets[i];
    if (!(names >> set.propeller >> set.run)) {
      throw InputError((folder / "names.txt").string(), {{{}, "a name is missing", {}}});
    }
    set.volume = static_cast<int>(volume[i]);
    set.pitchRatio = pitch[i];
    PropellerGeometry& g = set.geometry;
    g.blades = static_cast<int>(blades[i]);
    g.diameter = diameter[i];
    g.pitch = pitch[i] * diameter[i];
    g.line = slow[i] != 0 ? BladeLine::SlowFlyer : BladeLine::Standard;
    g.stations.clear();
  }
  return sets;
}

void readStations(const fs::path& folder, std::vector<PropellerSet>& sets) {
  const CsvTable table = readCsvFile(folder / "geometry.csv");
  const auto set = indices(table, "set", sets.size());
  const auto radius = table.values("r_R", "1"), chord = table.values("c_R", "1");
  const auto twist = table.values("beta", "rad");
  for (std::size_t i = 0; i < set.size(); ++i) {
    sets[set[i]].geometry.stations.push_back({radius[i], chord[i], twist[i]});
  }
}

void readPoints(const fs::path& folder, std::vector<PropellerSet>& sets) {
  constexpr std::size_t kMostRuns = 100;
  const CsvTable table = readCsvFile(folder / "performance.csv");
  const auto set = indices(table, "set", sets.size()), run = indices(table, "run", kMostRuns);
  const auto speed = table.values("speed", "rad/s"), advance = table.values("J", "1");
  const auto thrust = table.values("CT", "1"), power = table.values("CP", "1");
  for (std::size_t i = 0; i < set.size(); ++i) {
    PropellerSet& s = sets[set[i]];
    if (run[i] > s.flights.size()) s.flights.resize(run[i]);
    auto& rows = run[i] == 0 ? s.still : s.flights[run[i] - 1];
    rows.push_back({speed[i], advance[i], thrust[i], power[i]});
  }
}

}  // namespace

std::vector<PropellerSet> readPropellerSets(const fs::path& folder) {
  std::vector<PropellerSet> sets = readHeads(folder);
  readStations(folder, sets);
  readPoints(folder, sets);
  for (PropellerSet& set : sets) {
    if (set.geometry.stations.empty() || set.still.empty()) {
      throw InputError(folder.string(), {{set.propeller, "has no geometry or no static run", {}}});
    }
    std::stable_sort(set.still.begin(), set.still.end(),
                     [](const auto& a, const auto& b) { return a.speed < b.speed; });
  }
  return sets;
}

}  // namespace rotorbench::validation
