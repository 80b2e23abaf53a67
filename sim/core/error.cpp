#include "sim/core/error.h"

namespace rotorbench {

std::string Problem::message() const {
  std::string text = path;
  if (!what.empty()) text += (text.empty() ? "" : ": ") + what;
  if (!allowed.empty()) text += (text.empty() ? "" : "; ") + allowed;
  return text;
}

namespace {

std::string joined(const std::string& source, const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    if (!source.empty()) text += source + ": ";
    text += problem.message();
  }
  return text.empty() ? source : text;
}

}  // namespace

InputError::InputError(std::string source, std::vector<Problem> problems)
    : std::runtime_error(joined(source, problems)),
      source_(std::move(source)),
      problems_(std::move(problems)) {}

void refuse(std::string source, std::string what, std::string allowed) {
  throw InputError(std::move(source), {{{}, std::move(what), std::move(allowed)}});
}

}  // namespace rotorbench
