// A propeller for the 3D view: the blades as their geometry says, and a hub with nothing around it.
#pragma once

#include <vector>

#include "sim/propulsion/rotor/blade.h"
#include "sim/scene/scene_model.h"

namespace rotorbench {

/// The blade from the root cut-out to the tip, chord and twist as the blade-element model takes
/// them; m and rad.
std::vector<DrawnStation> drawnBlade(const PropellerGeometry& geometry);

/// Blade of a propeller of which only the radius in m is known: the planform and constant geometric
/// pitch of a typical moulded 10x4.5 propeller, for drawing and nothing else.
std::vector<DrawnStation> typicalBlade(double radius);

/// One rotor at the origin, thrust upwards, turning counter-clockwise seen from above.
SceneModel propellerScene(const PropellerGeometry& geometry);

/// The same on top of a pole, to be read from the recording of a stand.
SceneModel standScene(const PropellerGeometry& geometry);
/// A typical propeller of this radius in m there.
SceneModel standScene(double radius);

}  // namespace rotorbench
