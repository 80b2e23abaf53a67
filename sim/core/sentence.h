// A sentence with figures in it: words and numbers kept apart until somebody reads it, so that a
// window writes the numbers as the rest of it does (decimal comma) and the command line with
// points.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/core/number_text.h"

namespace rotorbench {

/// Writes a number with this many significant digits.
using NumberWriter = std::function<std::string(double value, int digits)>;

class Sentence {
 public:
  Sentence() = default;
  Sentence(std::string words);  // NOLINT(google-explicit-constructor): words are a sentence
  Sentence(const char* words) : Sentence(std::string(words)) {}  // NOLINT: as above
  /// A number as a part of a sentence.
  static Sentence number(double value, int digits = 3);

  [[nodiscard]] bool empty() const { return parts_.empty(); }
  /// The sentence as read; with a point as decimal sign unless another writer is given.
  [[nodiscard]] std::string text(const NumberWriter& write = shortNumber) const;

  friend Sentence operator+(Sentence first, const Sentence& second);

 private:
  struct Part {
    std::string words;
    double value = 0;
    int digits = 0;  ///< 0: words
  };
  std::vector<Part> parts_;
};

}  // namespace rotorbench
