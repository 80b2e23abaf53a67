#include "sim/logs/measured_table.h"

#include "sim/logs/quantity.h"

namespace rotorbench {

const std::vector<double>* MeasuredTable::find(std::string_view quantityKey) const {
  const auto at = findQuantity(channels, quantityKey);
  return at ? &columns[*at] : nullptr;
}

std::shared_ptr<const Recording> recordingOf(const MeasuredTable& table) {
  auto recording = std::make_shared<Recording>(table.channels);
  std::vector<double> row(table.channels.size());
  for (std::size_t r = 0; r < table.rows(); ++r) {
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = table.columns[c][r];
    if (!recording->append(row)) break;
  }
  recording->publish();
  recording->finish();
  return recording;
}

MeasuredTable tableOf(const Recording& recording, std::string source) {
  MeasuredTable table{std::move(source), recording.channels(), {}};
  const std::size_t rows = recording.rows();
  for (std::size_t c = 0; c < table.channels.size(); ++c) {
    std::vector<double>& column = table.columns.emplace_back();
    column.reserve(rows);
    while (column.size() < rows) {
      const auto piece = recording.column(c, column.size());
      const std::size_t count = std::min(piece.size(), rows - column.size());
      column.insert(column.end(), piece.begin(),
                    piece.begin() + static_cast<std::ptrdiff_t>(count));
    }
  }
  return table;
}

}  // namespace rotorbench
