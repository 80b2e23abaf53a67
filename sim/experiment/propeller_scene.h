// A propeller for the 3D view: the blades as their geometry says, and a hub with nothing around it.
#pragma once

#include <vector>

#include "sim/experiment/scene_model.h"
#include "sim/propulsion/blade.h"

namespace rotorbench {

/// The blade from the root cut-out to the tip, chord and twist as the blade-element model takes them; m and rad.
std::vector<DrawnStation> drawnBlade(const PropellerGeometry& geometry);

/// One rotor at the origin, thrust upwards, turning counter-clockwise seen from above.
SceneModel propellerScene(const PropellerGeometry& geometry);

}  // namespace rotorbench
