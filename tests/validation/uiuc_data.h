// The propellers of resources/validation/uiuc for tests, read once.
#pragma once

#include <QString>

#include "sim/validation/uiuc_data.h"

namespace uiuc {

inline const std::vector<rotorbench::validation::PropellerSet>& sets() {
  static const auto all =
      rotorbench::validation::readPropellerSets(EXPERIMENTS_DIR "/../validation/uiuc");
  return all;
}

/// The first set of that name in the database, "apcsf_10x4.7"; ends the test if there is none.
inline rotorbench::PropellerGeometry propeller(const QString& name) {
  for (const auto& set : sets()) {
    if (set.propeller == name.toStdString()) return set.geometry;
  }
  qFatal("no propeller %s", qPrintable(name));
}

}  // namespace uiuc
