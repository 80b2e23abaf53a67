#include "sim/logs/time_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>

#include "sim/io/csv_cells.h"

namespace rotorbench {

namespace {

constexpr double kMinute = 60, kHour = 3600, kDay = 86400;

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Takes pieces off the front of a text; each tells whether it was there.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool atEnd() const { return rest_.empty(); }
  [[nodiscard]] char front() const { return rest_.empty() ? '\0' : rest_.front(); }

  bool take(char sign) {
    if (front() != sign) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// From `least` to `most` digits.
  bool digits(std::size_t least, std::size_t most, int& value) {
    std::size_t count = 0;
    while (count < std::min(most, rest_.size()) && isDigit(rest_[count])) ++count;
    if (count < least) return false;
    std::from_chars(rest_.data(), rest_.data() + count, value);
    rest_.remove_prefix(count);
    return true;
  }
  /// Digits behind a point or comma, or three behind a colon, if there are any, as a part of 1.
  bool fraction(double& value) {
    if (take(':')) {
      int thousandths = 0;
      if (!digits(3, 3, thousandths)) return false;
      value = 1e-3 * thousandths;
      return true;
    }
    if (!take('.') && !take(',')) return true;
    if (!isDigit(front())) return false;
    for (double place = 0.1; isDigit(front()); place /= 10) {
      value += place * (rest_.front() - '0');
      rest_.remove_prefix(1);
    }
    return true;
  }

 private:
  std::string_view rest_;
};

/// "2024-03-01", as days since 1970.
std::optional<int> takeDate(Scanner& text) {
  int year = 0, month = 0, day = 0;
  if (!text.digits(4, 4, year) || !text.take('-') || !text.digits(2, 2, month) || !text.take('-') ||
      !text.digits(2, 2, day)) {
    return {};
  }
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return {};
  return std::chrono::sys_days(date).time_since_epoch().count();
}

/// "12:00", "12:00:00.25", as seconds since midnight. A minute may have a leap second.
std::optional<double> takeTimeOfDay(Scanner& text, bool needsSeconds) {
  int hour = 0, minute = 0, second = 0;
  double part = 0;
  if (!text.digits(1, 2, hour) || !text.take(':') || !text.digits(2, 2, minute)) return {};
  const bool seconds = text.take(':');
  if (seconds && (!text.digits(2, 2, second) || !text.fraction(part))) return {};
  if ((needsSeconds && !seconds) || hour > 23 || minute > 59 || second > 60) return {};
  return kHour * hour + kMinute * minute + second + part;
}

/// "Z", "+01:00", "-0530", "+01": what the zone is ahead of UTC, in s.
std::optional<double> takeZone(Scanner& text) {
  if (text.take('Z') || text.take('z')) return 0;
  const double sign = text.front() == '-' ? -1 : 1;
  int hours = 0, minutes = 0;
  if ((!text.take('+') && !text.take('-')) || !text.digits(2, 2, hours)) return {};
  const bool more = text.take(':') || !text.atEnd();
  if (more && !text.digits(2, 2, minutes)) return {};
  if (hours > 14 || minutes > 59) return {};
  return sign * (kHour * hours + kMinute * minutes);
}

}  // namespace

std::optional<TimeText> readTimeText(std::string_view text) {
  Scanner rest(trimmedCell(text));
  Scanner dated = rest;
  const auto date = takeDate(dated);
  if (!date) {
    const auto time = takeTimeOfDay(rest, true);
    if (!time || !rest.atEnd()) return {};
    return TimeText{TimeTextKind::TimeOfDay, 0, *time};
  }
  if (!dated.take('T') && !dated.take('t') && !dated.take(' ')) return {};
  const auto time = takeTimeOfDay(dated, false);
  if (!time) return {};
  if (dated.atEnd()) return TimeText{TimeTextKind::Date, *date, *time};
  const auto zone = takeZone(dated);
  if (!zone || !dated.atEnd()) return {};
  return TimeText{TimeTextKind::DateWithZone, *date, *time - *zone};
}

bool resemblesTime(std::string_view text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == ':' && isDigit(text[i - 1]) && isDigit(text[i + 1])) return true;
  }
  return false;
}

std::optional<double> TimeLine::read(std::string_view text) {
  const auto time = readTimeText(text);
  if (!time || (first_ && time->kind != first_->kind)) return {};
  if (!first_) first_ = time;
  double seconds = kDay * (time->day - first_->day) + (time->seconds - first_->seconds);
  if (time->kind == TimeTextKind::TimeOfDay) {
    seconds += midnights_;
    if (seconds < last_ - kDay / 2) {
      midnights_ += kDay, seconds += kDay;
    } else if (midnights_ > 0 && seconds > last_ + kDay / 2) {
      seconds -= kDay;  // a row of before midnight that comes late
    }
  }
  last_ = seconds;
  return seconds;
}

}  // namespace rotorbench
