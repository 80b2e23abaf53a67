// A channel is declared where it is computed; recording, signal tree, charts, CSV headers and
// metrics all follow from that declaration.
#pragma once

#include <string>
#include <vector>

namespace rotorbench {

/// Names are paths with dots ("rotor1.thrust", "position.z"); the signal tree splits them there.
struct Channel {
  std::string name;
  std::string unit;  ///< SI unit symbol, "1" for plain numbers
  std::string description;
  bool operator==(const Channel&) const = default;
};

}  // namespace rotorbench
