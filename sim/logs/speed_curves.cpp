#include "sim/logs/speed_curves.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/logs/quantity.h"

namespace rotorbench {

namespace {

constexpr double kSameSpeed = 0.02;

bool isOverAdvance(const MeasuredTable& table) {
  return !table.channels.empty() &&
         table.channels.front().name ==
             channelName(abscissaOf(ChannelGroup::OverAdvance), ChannelGroup::OverAdvance);
}

}  // namespace

std::vector<double> curveSpeeds(const MeasuredTable& table) {
  const std::vector<double>* column = table.find("motor.speed");
  if (!isOverAdvance(table) || column == nullptr) return {};
  std::vector<double> sorted;
  std::ranges::copy_if(*column, std::back_inserter(sorted),
                       [](double speed) { return std::isfinite(speed) && speed > 0; });
  std::ranges::sort(sorted);
  std::vector<double> speeds;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto end = std::upper_bound(first, sorted.end(), *first * (1 + kSameSpeed));
    double sum = 0;
    for (auto at = first; at != end; ++at) sum += *at;
    const auto count = end - first;
    if (count >= 2) speeds.push_back(sum / static_cast<double>(count));
    first = end;
  }
  if (speeds.size() < 2) speeds.clear();
  return speeds;
}

MeasuredTable curveAtSpeed(const MeasuredTable& table, double speed) {
  const std::vector<double>* measured = table.find("motor.speed");
  MeasuredTable curve{table.source, table.channels,
                      std::vector<std::vector<double>>(table.columns.size())};
  if (measured == nullptr) return curve;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    if (!(std::abs((*measured)[r] - speed) <= kSameSpeed * speed)) continue;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      curve.columns[c].push_back(table.columns[c][r]);
  }
  return curve;
}

}  // namespace rotorbench
