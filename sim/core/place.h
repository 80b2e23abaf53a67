// Where a value sits in its document, so that whoever finds a fault can name it: handed down to
// where values are used instead of being patched together on the way back.
#pragma once

#include <string>
#include <string_view>

#include "sim/core/error.h"

namespace rotorbench {

class Place {
 public:
  Place() = default;
  explicit Place(std::string path) : path_(std::move(path)) {}
  /// The member `key` of what is here; itself for an empty key.
  [[nodiscard]] Place operator/(std::string_view key) const {
    if (key.empty()) return *this;
    return Place(path_.empty() ? std::string(key) : path_ + "." + std::string(key));
  }
  /// Element `index` of the list that is here.
  [[nodiscard]] Place operator[](std::size_t index) const {
    return Place(path_ + "[" + std::to_string(index) + "]");
  }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Problems with paths below this place, named from the root of the document.
  [[nodiscard]] InputError error(std::vector<Problem> problems) const {
    for (Problem& problem : problems) problem.path = (*this / problem.path).path_;
    return InputError({}, std::move(problems));
  }

 private:
  std::string path_;
};

}  // namespace rotorbench
