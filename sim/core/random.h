// Named, reproducible random streams: the same run seed and stream name give the same bits on every machine
// and whatever the threads do.
#pragma once

#include <cstdint>
#include <string_view>

namespace rotorbench {

/// Counter-based splitmix64 stream (Steele, Lea, Flood 2014); its key is a hash of run seed and name.
class RandomStream {
 public:
  RandomStream(std::uint64_t runSeed, std::string_view name);

  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  /// Standard normal (mean 0, variance 1).
  double normal();

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
  double spare_ = 0;
  bool hasSpare_ = false;
};

}  // namespace rotorbench
