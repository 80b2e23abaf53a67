// Inputs laid down in advance, made ready for a run: read from the experiment or from a file.
#pragma once

#include <filesystem>

#include "sim/core/place.h"
#include "sim/document/prescribed_inputs.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

/// One value per rotor; lanes beyond the number of rotors are 0.
using RotorInputs = InputSignal<PerRotor>;

/// Reads the source; files are looked for relative to `directory`. The inputs are described at
/// `place`. Throws InputError (missing file, wrong columns, times that do not rise).
RotorInputs loadInputs(const SpeedInputs& inputs, int rotors,
                       const std::filesystem::path& directory, const Place& place = {});
RotorInputs loadInputs(const VoltageInputs& inputs, int rotors,
                       const std::filesystem::path& directory, const Place& place = {});

}  // namespace rotorbench
