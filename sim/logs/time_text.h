// Times written as text: dates with a time of day as ISO 8601 has them, and times of day alone.
//   2024-03-01T12:00:00.250   2024-03-01 12:00:00Z   2024-03-01T12:00+01:00   12:00:00.25
// Fractions of a second behind a point or comma, or as three digits behind a colon (logs of the
// AutoQuad ESC32); without a zone the clock is taken to run through.
#pragma once

#include <optional>
#include <string_view>

namespace rotorbench {

enum class TimeTextKind {
  Date,          ///< no zone written
  DateWithZone,  ///< Z, +01:00, +0100 or +01
  TimeOfDay,
};

struct TimeText {
  TimeTextKind kind = TimeTextKind::Date;
  int day = 0;         ///< since 1970-01-01; 0 for a time of day
  double seconds = 0;  ///< since midnight of that day, of the clock, or of UTC with a zone
};

/// The whole text as a time; empty if it is none, or there is no such date or hour.
std::optional<TimeText> readTimeText(std::string_view text);

/// True for text that has digits on both sides of a colon, as all times do, also those that
/// readTimeText refuses.
bool resemblesTime(std::string_view text);

/// Makes seconds since the first of the times read in the order of a file. Times of day that fall
/// back by more than half a day have passed midnight.
class TimeLine {
 public:
  /// Empty if the text is no time, or not of the same kind as the first.
  std::optional<double> read(std::string_view text);

 private:
  std::optional<TimeText> first_;
  double last_ = 0;       ///< s, since the first
  double midnights_ = 0;  ///< s, of the days passed
};

}  // namespace rotorbench
