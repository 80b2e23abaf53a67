// The flight that the tests of changes change: a second in which every limit is met.
#pragma once

#include <string>

#include "sim/document/controlled_inputs.h"
#include "sim/document/experiment_file.h"
#include "sim/document/flight.h"

namespace rotorbench::test {

/// A second of a flight in which every limit is met: a step of all set-points that the rotors
/// cannot follow.
inline Experiment hardFlight(const char* wind, const char* more = "") {
  const std::string text = std::string(R"({"rotorbench": 1, "setup": {"type": "flight",
    "duration": 1, "control": {"type": "controlled",
      "controller": {"type": "pid", "altitude": {"limit": 1, "trackingTime": 0.1},
        "roll": {"limit": 5, "trackingTime": 0.1}, "pitch": {"limit": 5, "trackingTime": 0.1},
        "yaw": {"limit": 0.7, "trackingTime": 0.1}},
      "motors": {"pid": {"kd": 0.02, "limit": 200, "trackingTime": 0.05}},
      "setPoints": [{"time": 0, "height": 0.4, "roll": 0, "pitch": 0, "yaw": 0},
        {"time": 0.25, "height": 2, "roll": 0.3, "pitch": 0.2, "yaw": 0.5}])") +
                           more + R"(}, "environment": {"wind": {)" + wind + "}}}}";
  return readExperiment(text, "flight.json");
}
inline constexpr const char* kSteady = R"("type": "steady", "velocity": [2, 1, 0])";
inline constexpr const char* kOverHeight =
    R"("type": "logarithmic", "velocity": [4, 1], "ground": -2)";
inline constexpr const char* kAllByHand = R"(, "byHand": {"heightByHand": true, "rollByHand": true,
  "pitchByHand": true, "yawByHand": true})";

inline Flight& flightOf(Experiment& e) {
  return alternative<Flight>(e.setup);
}

}  // namespace rotorbench::test
