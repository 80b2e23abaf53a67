// Named, reproducible random streams: the same run seed and stream name give the same bits on every
// machine and whatever the threads do.
#pragma once

#include <cstdint>
#include <string_view>

namespace rotorbench {

/// Counter-based splitmix64 stream (Steele, Lea, Flood 2014); its key is a hash of run seed and
/// name.
class RandomStream {
 public:
  RandomStream(std::uint64_t runSeed, std::string_view name);

  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  /// Standard normal (mean 0, variance 1): the inverse distribution function of one uniform number,
  /// so each call takes exactly one draw from the stream.
  double normal();

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

/// Inverse of the standard normal distribution function for p in (0, 1), to about 16 digits
/// (Wichura 1988, Algorithm AS 241, PPND16). Uses only operations IEEE 754 rounds exactly: no libm,
/// whose last bit depends on the processor.
double inverseNormal(double p);

}  // namespace rotorbench
