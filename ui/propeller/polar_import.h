// XFOIL and XFLR5 polar files become a section of a blade.
#pragma once

#include <QString>
#include <QStringList>

#include "sim/propulsion/rotor/blade.h"

namespace rotorbench {

/// One section of all the polars, named after the first file, in the order of their Reynolds
/// numbers. Throws InputError naming the file and line at fault, or two files of one Reynolds
/// number.
PolarSection sectionFromFiles(const QStringList& files);

/// The geometry with this section from `radius` (r/R) on; a section that begins there is replaced.
PropellerGeometry withSection(PropellerGeometry geometry, double radius, PolarSection section);

}  // namespace rotorbench
