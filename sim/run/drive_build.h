// The plant of a stand with a single motor, and the channels it is recorded in.
#pragma once

#include <vector>

#include "sim/core/channel.h"
#include "sim/document/drive_stand.h"
#include "sim/propulsion/drive/drive_train.h"

namespace rotorbench {

DriveTrain buildDriveTrain(const DriveStand& stand);
/// The same drive without saturation: an ideal supply of the voltage the real one has at first, any
/// duty, any current.
DriveTrain buildUnlimitedDriveTrain(const DriveStand& stand);
/// With a propeller known at few speeds only: quick, where its poles are judged.
DriveTrain buildCoarseDriveTrain(const DriveStand& stand);

/// Time in s and everything that can be read on the stand.
std::vector<Channel> driveChannels();
/// The row that belongs to the channels; `asked` is the throttle commanded, which a dead time may
/// still hold back.
void driveRow(const DriveTrain& train, double time, double asked, const DriveTrain::State& y,
              double* out);

}  // namespace rotorbench
