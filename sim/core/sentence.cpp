#include "sim/core/sentence.h"

namespace rotorbench {

Sentence::Sentence(std::string words) {
  if (!words.empty()) parts_.push_back({.words = std::move(words)});
}

Sentence Sentence::number(double value, int digits) {
  Sentence sentence;
  sentence.parts_.push_back({.words = {}, .value = value, .digits = digits});
  return sentence;
}

std::string Sentence::text(const NumberWriter& write) const {
  std::string text;
  for (const Part& part : parts_)
    text += part.digits > 0 ? write(part.value, part.digits) : part.words;
  return text;
}

Sentence operator+(Sentence first, const Sentence& second) {
  first.parts_.insert(first.parts_.end(), second.parts_.begin(), second.parts_.end());
  return first;
}

}  // namespace rotorbench
