#include "ui/propeller/polar_import.h"

#include <QFileInfo>
#include <algorithm>

#include "sim/io/file.h"

namespace rotorbench {

PolarSection sectionFromFiles(const QStringList& files) {
  PolarSection section;
  section.polars.clear();
  for (const QString& file : files) {
    section.polars.push_back(readXfoilPolar(readTextFile(file.toStdString()), file.toStdString()));
  }
  std::ranges::sort(section.polars, {}, &Polar::reynolds);
  const auto twice = std::ranges::adjacent_find(section.polars, {}, &Polar::reynolds);
  if (twice != section.polars.end()) {
    throw InputError("polars", {{"", "two files have the same Reynolds number",
                                 "one file for each Reynolds number"}});
  }
  if (!files.isEmpty()) section.name = QFileInfo(files.front()).completeBaseName().toStdString();
  return section;
}

PropellerGeometry withSection(PropellerGeometry geometry, double radius, PolarSection section) {
  auto& sections = geometry.sections;
  const auto at = std::ranges::lower_bound(sections, radius, {}, &BladeSection::radius);
  if (at != sections.end() && at->radius == radius) {
    at->model = std::move(section);
  } else {
    sections.insert(at, BladeSection{radius, std::move(section)});
  }
  return geometry;
}

}  // namespace rotorbench
