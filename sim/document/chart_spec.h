// What one chart of an experiment shows, as kept in the experiment file. Channel patterns are names
// in which each * stands for any text without a dot: "rotor*.thrust".
#pragma once

#include <string>

#include "sim/core/schema.h"

namespace rotorbench {

/// Time: channels over the abscissa of the recording. XY: channels over the channel `x`; where both
/// hold a *, x and y pair up by the text it stands for ("*.evaluations" and "*.max_error_norm": one
/// curve per method).
enum class ChartKind { Time, XY };

struct ChartSpec {
  std::string title;
  ChartKind kind = ChartKind::Time;
  std::string x;
  std::string channels;  ///< patterns separated by commas
  bool logX = false;
  bool logY = false;
  bool markers = false;
  bool operator==(const ChartSpec&) const = default;
};

template <>
struct Describe<ChartSpec> {
  static void fields(schema::Builder<ChartSpec>& b) {
    b.title("chart", "Chart", "One chart of the experiment: which channels it shows over what.");
    b.text("title", &ChartSpec::title, "Title")
        .help("Stands above the chart and in exported figures.");
    b.choice("kind", &ChartSpec::kind, "Kind",
             {schema::Named<ChartKind>{ChartKind::Time, "time", "Over time",
                                       "The channels over the time of the run."},
              schema::Named<ChartKind>{ChartKind::XY, "xy", "One over another",
                                       "The channels over another channel."}});
    b.text("x", &ChartSpec::x, "Horizontal channel")
        .role(schema::TextRole::Channels)
        .help("Channel on the horizontal axis of a chart of kind xy; unused over time.");
    b.text("channels", &ChartSpec::channels, "Channels")
        .role(schema::TextRole::Channels)
        .help(
            "Channel names separated by commas; each * stands for any text without a dot, as in "
            "rotor*.thrust.");
    b.boolean("logX", &ChartSpec::logX, "Logarithmic horizontal axis");
    b.boolean("logY", &ChartSpec::logY, "Logarithmic vertical axis");
    b.boolean("markers", &ChartSpec::markers, "Markers")
        .help("Marks the samples as well as the line.");
  }
};

}  // namespace rotorbench
