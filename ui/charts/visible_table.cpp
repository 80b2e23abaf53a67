#include "ui/charts/visible_table.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/number_text.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"

namespace rotorbench {
namespace {

/// Columns of one recording over one abscissa, and the rows of it in view.
struct Block {
  std::shared_ptr<const Recording> recording;
  std::string prefix;
  std::size_t x = 0;
  std::vector<std::size_t> channels;
  std::vector<std::size_t> rows;
};

std::vector<std::size_t> rowsInView(const Recording& recording, std::size_t x, Span view) {
  std::vector<std::size_t> rows;
  const std::size_t count = recording.rows();
  // Channel 0 is sorted; any other has to be looked through.
  for (std::size_t row = x == 0 ? std::min(recording.lowerBound(view.low), count) : 0; row < count;
       ++row) {
    const double value = recording.value(x, row);
    if (x == 0 && value > view.high) break;
    if (value >= view.low && value <= view.high) rows.push_back(row);
  }
  return rows;
}

std::vector<Block> visibleBlocks(const ChartPane& pane) {
  const auto& curves = pane.curves().curves;
  const bool severalRuns = std::any_of(curves.begin(), curves.end(), [&](const Curve& curve) {
    return curve.runId != curves.front().runId;
  });
  const Span view = pane.frameFor({400, 300}, 1, QLocale::c()).x.scale.span;
  std::vector<Block> blocks;
  for (const auto& curve : curves) {
    if (curve.hidden) continue;
    auto block = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) {
      return b.recording == curve.recording && b.x == curve.xChannel;
    });
    if (block == blocks.end()) {
      blocks.push_back({curve.recording,
                        severalRuns ? curve.runName.toStdString() + ": " : "",
                        curve.xChannel,
                        {curve.xChannel},
                        rowsInView(*curve.recording, curve.xChannel, view)});
      block = blocks.end() - 1;
    }
    block->channels.push_back(curve.yChannel);
  }
  return blocks;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

}  // namespace

std::size_t visibleCells(const ChartPane& pane) {
  std::size_t cells = 0;
  for (const auto& block : visibleBlocks(pane)) cells += block.rows.size() * block.channels.size();
  return cells;
}

QString paneCsv(const ChartPane& pane) {
  const auto blocks = visibleBlocks(pane);
  std::string text;
  std::size_t rows = 0;
  for (const auto& block : blocks) {
    rows = std::max(rows, block.rows.size());
    for (const std::size_t channel : block.channels) {
      const Channel& c = block.recording->channels()[channel];
      if (!text.empty()) text += ',';
      text += quoted(block.prefix + c.name + " [" + c.unit + "]");
    }
  }
  text += '\n';
  for (std::size_t i = 0; i < rows; ++i) {
    bool first = true;
    for (const auto& block : blocks) {
      for (const std::size_t channel : block.channels) {
        if (!std::exchange(first, false)) text += ',';
        if (i < block.rows.size())
          text += numberText(block.recording->value(channel, block.rows[i]));
      }
    }
    text += '\n';
  }
  return QString::fromStdString(text);
}

}  // namespace rotorbench
