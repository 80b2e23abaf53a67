// Lists whose rows come in the order of one column: times of a timeline, radii of a blade. The
// description of such a list, its check and the words for both.
//
//   schema::risingList(b, "rows", &P::rows, "Throttle", &Row::time, schema::kRisingTimes)
//       .items(1, 100000)
//       .table();
#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench::schema {

/// How the column is spoken of.
struct RisingColumn {
  std::string_view key;               ///< of the member that must rise, as its description names it
  std::string_view plural;            ///< "times"
  std::string_view beyond = "above";  ///< "later than"
};

inline constexpr RisingColumn kRisingTimes{"time", "times", "later than"};

/// "times must rise from row to row"
inline std::string risingRule(const RisingColumn& column) {
  return std::string(column.plural) + " must rise from row to row";
}

/// What a row is told, at `path`, that is not beyond the row before.
inline Problem notRising(std::string path, const RisingColumn& column) {
  return {std::move(path), "is not " + std::string(column.beyond) + " the row before",
          risingRule(column)};
}

/// Indices, 1 or more, of the rows whose `member` is not above that of the row before; NaN is above
/// nothing.
template <class Row>
std::vector<std::size_t> rowsNotRising(const std::vector<Row>& rows, double Row::*member) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!(rows[i].*member > rows[i - 1].*member)) found.push_back(i);
  }
  return found;
}

/// Describes a list of rows whose `member` must rise strictly: the list, the check, which names
/// every row that is in the wrong place, and the rule at the end of its help. `help` may be empty.
template <class T, class Row>
FieldBuilder risingList(Builder<T>& b, const std::string& key, std::vector<Row> T::*rows,
                        std::string label, double Row::*member, const RisingColumn& column,
                        std::string help = {}) {
  b.check([key, rows, member, column](const T& object, std::vector<Problem>& problems) {
    for (const std::size_t i : rowsNotRising(object.*rows, member)) {
      problems.push_back(
          notRising(key + "[" + std::to_string(i) + "]." + std::string(column.key), column));
    }
  });
  std::string rule = risingRule(column);
  rule.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(rule.front())));
  help += (help.empty() ? "" : " ") + rule + ".";
  return b.list(key, rows, std::move(label)).help(std::move(help));
}

}  // namespace rotorbench::schema
