#include "sim/fitting/duty_source.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "sim/core/number_text.h"

namespace rotorbench {

namespace {

/// Rows within this part of the largest throttle are the upper ones.
constexpr double kUpper = 0.95;
/// The lower ones ask for a voltage between these parts of what the upper ones ask for.
constexpr double kLeast = 0.7, kMost = 0.85;
/// At kMost of the voltage a steady motor has at most sqrt(kMost) = 0.922 of the speed; more than
/// this it cannot be.
constexpr double kSameSpeed = 0.95;

double asked(const DutyRow& row) {
  return row.throttle * row.voltage;
}

/// Some rows may be of a motor that still speeds up or slows down: the middle one is not.
template <class Value>
double median(const std::vector<DutyRow>& rows, Value value) {
  std::vector<double> values;
  for (const DutyRow& row : rows) values.push_back(std::invoke(value, row));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Two throttles at which the motor turns alike.
struct Contradiction {
  double low, high;
};

std::optional<Contradiction> contradictionIn(const std::vector<DutyRow>& rows) {
  if (rows.empty()) return std::nullopt;
  const double top = std::ranges::max(rows, {}, &DutyRow::throttle).throttle;
  std::vector<DutyRow> upper, lower;
  for (const DutyRow& row : rows) {
    if (row.throttle >= kUpper * top) upper.push_back(row);
  }
  const double most = median(upper, asked);
  for (const DutyRow& row : rows) {
    if (asked(row) >= kLeast * most && asked(row) <= kMost * most) lower.push_back(row);
  }
  if (lower.empty()) return std::nullopt;
  if (median(lower, &DutyRow::speed) < kSameSpeed * median(upper, &DutyRow::speed))
    return std::nullopt;
  return Contradiction{median(lower, &DutyRow::throttle), median(upper, &DutyRow::throttle)};
}

bool hasFullThrottle(const std::vector<DutyRow>& rows) {
  return std::ranges::any_of(rows,
                             [](const DutyRow& row) { return row.throttle >= kFullThrottle; });
}

}  // namespace

DutyFrom dutySourceOf(const std::vector<DutyRow>& rows) {
  if (!contradictionIn(rows)) return DutyFrom::Throttle;
  return hasFullThrottle(rows) ? DutyFrom::FullThrottle : DutyFrom::Unknown;
}

std::string dutySourceText(const std::vector<DutyRow>& rows) {
  const auto found = contradictionIn(rows);
  if (!found) return {};
  return "At " + shortNumber(100 * found->low, 2) + " % throttle the motor turns as fast as at " +
         shortNumber(100 * found->high, 3) +
         " %: the throttle is not the duty, which is taken as " +
         (hasFullThrottle(rows) ? "1 at full throttle and as unknown below." : "unknown.");
}

}  // namespace rotorbench
