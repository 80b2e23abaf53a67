// What went wrong, where, and what is allowed: the one exception type of the boundaries (files,
// command line, forms). The hot loop throws nothing; a failed run reports a RunFailure as a value.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rotorbench {

/// One violation. `path` is the place inside the document ("vehicle.rotors[2].arm"), empty for the
/// whole file; `what` names the fault and the given value, `allowed` what would be accepted
/// (empty if nothing sensible can be said).
struct Problem {
  std::string path;
  std::string what;
  std::string allowed;
  bool warning = false;  ///< a warning is shown but does not block a run

  /// "path: what; allowed" without the parts that are empty.
  [[nodiscard]] std::string message() const;
  bool operator==(const Problem&) const = default;
};

/// The input is wrong. Holds every problem found, not just the first.
class InputError : public std::runtime_error {
 public:
  /// `source` names the file or field the problems belong to (may be empty).
  InputError(std::string source, std::vector<Problem> problems);

  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::string source_;
  std::vector<Problem> problems_;
};

/// Throws an InputError of one problem that concerns all of `source`.
[[noreturn]] void refuse(std::string source, std::string what, std::string allowed = {});

/// Why a run stopped early: the simulated time in s, the state component or part that failed, and a
/// sentence for the user.
struct RunFailure {
  double time = 0;
  std::string component;
  std::string message;
};

}  // namespace rotorbench
