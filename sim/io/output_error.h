// What is wrong with an output, not with the input: whoever tells them apart (the command line's
// exit code) catches this first.
#pragma once

#include "sim/core/error.h"

namespace rotorbench {

/// The disk does not take what is written: it is full, or broken. Thrown by the functions of
/// file.h that write.
class OutputError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace rotorbench
