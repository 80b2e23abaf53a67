// The costly tests have two sets of rows: the one everybody waits for holds the hardest of them,
// the full one all. `.ci/run --full` and ROTORBENCH_FULL_TESTS=1 ask for the full one.
#pragma once

#include <QtGlobal>

namespace rotorbench::test {

inline bool fullSet() {
  return qEnvironmentVariableIntValue("ROTORBENCH_FULL_TESTS") != 0;
}

}  // namespace rotorbench::test
