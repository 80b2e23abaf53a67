// Between a data sheet and the experiment that is open: what of it can be read as one, and where
// one can be put.
#pragma once

#include <optional>
#include <string>

#include "sim/document/experiment.h"
#include "sim/sizing/data_sheet.h"

namespace rotorbench {

/// Path of the part of the experiment that a data sheet fills ("setup.vehicle", "setup.stand");
/// empty if the experiment has no motor.
std::string dataSheetTarget(const Experiment& experiment);

/// The experiment's motor, propeller, supply and mass as a data sheet; empty if it has no motor. A
/// propeller that no data sheet describes stays the default one.
std::optional<DataSheet> dataSheetOf(const Experiment& experiment);

/// Puts motor, speed controller, supply, inertia and propeller into the experiment, which must have
/// a target. What the sheet says of the vehicle's mass is left out: an experiment knows its own. In
/// a vehicle all rotors become alike.
void applyDataSheet(const DataSheet& sheet, Experiment& experiment);

}  // namespace rotorbench
