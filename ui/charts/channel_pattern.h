// Which channels a chart specification means: patterns with * against the channel names of a
// recording.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/channel.h"
#include "sim/document/chart_spec.h"

namespace rotorbench {

/// One curve a specification asks of a recording: indices into its channels.
struct CurveChannels {
  std::size_t x = 0;
  std::size_t y = 0;
  bool operator==(const CurveChannels&) const = default;
};

/// The text each * of `pattern` stands for in `name`, or nothing if the name does not match. A *
/// stands for any text without a dot, also none.
std::optional<std::vector<std::string>> matchPattern(std::string_view pattern,
                                                     std::string_view name);

/// "a, b*" as its trimmed, non-empty parts.
std::vector<std::string> splitPatterns(std::string_view patterns);
std::string joinPatterns(const std::vector<std::string>& patterns);

/// The curves of `spec` over `channels`, in the order of the patterns and without repeats. Channel
/// 0 is the abscissa; it is not drawn over itself.
std::vector<CurveChannels> resolveCurves(const ChartSpec& spec,
                                         const std::vector<Channel>& channels);

/// `spec` with `name` added as a further channel; unchanged if a pattern already names it.
ChartSpec withChannel(ChartSpec spec, const std::string& name);
/// `spec` without `name`; a wildcard that matched it is replaced by the other names it matches in
/// `channels`.
ChartSpec withoutChannel(ChartSpec spec, const std::string& name,
                         const std::vector<Channel>& channels);

}  // namespace rotorbench
