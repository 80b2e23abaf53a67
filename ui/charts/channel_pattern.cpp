#include "ui/charts/channel_pattern.h"

#include <algorithm>

namespace rotorbench {
namespace {

bool match(std::string_view pattern, std::string_view name, std::vector<std::string>& found) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == name;
  if (name.substr(0, star) != pattern.substr(0, star)) return false;
  const std::string_view rest = name.substr(star);
  const std::size_t longest = std::min(rest.find('.'), rest.size());
  for (std::size_t length = longest + 1; length-- > 0;) {
    found.emplace_back(rest.substr(0, length));
    if (match(pattern.substr(star + 1), rest.substr(length), found)) return true;
    found.pop_back();
  }
  return false;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\n\r";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// The x channel that goes with a y channel whose stars stand for `stars`.
std::optional<std::size_t> findX(const std::string& pattern, const std::vector<std::string>& stars,
                                 const std::vector<Channel>& channels) {
  if (pattern.empty()) return 0;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto found = matchPattern(pattern, channels[i].name);
    if (found && (found->empty() || stars.empty() || *found == stars)) return i;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<std::string>> matchPattern(std::string_view pattern,
                                                     std::string_view name) {
  std::vector<std::string> found;
  if (!match(pattern, name, found)) return std::nullopt;
  return found;
}

std::vector<std::string> splitPatterns(std::string_view patterns) {
  std::vector<std::string> parts;
  while (!patterns.empty()) {
    const std::size_t comma = std::min(patterns.find(','), patterns.size());
    if (const auto part = trimmed(patterns.substr(0, comma)); !part.empty())
      parts.emplace_back(part);
    patterns.remove_prefix(std::min(comma + 1, patterns.size()));
  }
  return parts;
}

std::string joinPatterns(const std::vector<std::string>& patterns) {
  std::string text;
  for (const auto& pattern : patterns) text += (text.empty() ? "" : ", ") + pattern;
  return text;
}

std::vector<CurveChannels> resolveCurves(const ChartSpec& spec,
                                         const std::vector<Channel>& channels) {
  std::vector<CurveChannels> curves;
  const std::string xPattern =
      spec.kind == ChartKind::XY ? std::string(trimmed(spec.x)) : std::string();
  for (const auto& pattern : splitPatterns(spec.channels)) {
    for (std::size_t y = 0; y < channels.size(); ++y) {
      const auto stars = matchPattern(pattern, channels[y].name);
      if (!stars) continue;
      const auto x = findX(xPattern, *stars, channels);
      if (!x || *x == y) continue;
      const CurveChannels curve{*x, y};
      if (std::find(curves.begin(), curves.end(), curve) == curves.end()) curves.push_back(curve);
    }
  }
  return curves;
}

ChartSpec withChannel(ChartSpec spec, const std::string& name) {
  auto patterns = splitPatterns(spec.channels);
  for (const auto& pattern : patterns) {
    if (matchPattern(pattern, name)) return spec;
  }
  patterns.push_back(name);
  spec.channels = joinPatterns(patterns);
  return spec;
}

ChartSpec withoutChannel(ChartSpec spec, const std::string& name,
                         const std::vector<Channel>& channels) {
  std::vector<std::string> kept;
  for (const auto& pattern : splitPatterns(spec.channels)) {
    if (!matchPattern(pattern, name)) {
      kept.push_back(pattern);
      continue;
    }
    for (const auto& channel : channels) {
      if (channel.name != name && matchPattern(pattern, channel.name)) kept.push_back(channel.name);
    }
  }
  spec.channels = joinPatterns(kept);
  return spec;
}

}  // namespace rotorbench
