#include "sim/io/metrics_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace rotorbench {

namespace {

std::string number(double value) {
  if (!std::isfinite(value)) return "-";
  if (value == std::floor(value) && std::abs(value) < 1e15) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f", value);
    return text.data();
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// Characters on screen; names and units are UTF-8.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t columns, bool right) {
  const std::string space(columns > width(text) ? columns - width(text) : 0, ' ');
  return right ? space + text : text + space;
}

using Grid = std::vector<std::vector<std::string>>;

/// First column left-aligned, the others right-aligned.
std::string aligned(const Grid& grid) {
  std::vector<std::size_t> columns;
  for (const auto& row : grid) {
    columns.resize(std::max(columns.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) columns[i] = std::max(columns[i], width(row[i]));
  }
  std::string out;
  for (const auto& row : grid) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) line += "  ";
      line += padded(row[i], columns[i], i > 0);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

std::string heading(const Metric& metric) {
  return metric.unit == "1" ? metric.name : metric.name + " [" + metric.unit + "]";
}

/// Every metric of the table once, in order of first appearance.
std::vector<const Metric*> allMetrics(const MetricTable& table) {
  std::vector<const Metric*> all;
  for (const auto& row : table) {
    for (const auto& metric : row.metrics) {
      const auto same = [&](const Metric* m) { return m->name == metric.name; };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(&metric);
    }
  }
  return all;
}

std::string valueIn(const MetricRow& row, const std::string& name) {
  for (const auto& metric : row.metrics) {
    if (metric.name == name) return number(metric.value);
  }
  return "";
}

}  // namespace

std::string metricsText(const MetricTable& table) {
  const auto all = allMetrics(table);
  Grid grid;
  if (table.size() > 1) {  // a comparison reads across: one line per run
    auto& head = grid.emplace_back();
    head.emplace_back("run");
    for (const auto* metric : all) head.push_back(heading(*metric));
    for (const auto& row : table) {
      auto& line = grid.emplace_back();
      line.push_back(row.run);
      for (const auto* metric : all) line.push_back(valueIn(row, metric->name));
    }
  } else if (!table.empty()) {
    for (const auto& metric : table.front().metrics) {
      grid.push_back({metric.name, number(metric.value), metric.unit == "1" ? "" : metric.unit});
    }
  }
  return aligned(grid);
}

std::string metricsJson(const std::string& experimentTitle, const RunSummary& summary) {
  using Json = nlohmann::ordered_json;
  Json document;
  document["experiment"] = experimentTitle;
  document["metrics"] = Json::array();
  document["units"] = Json::object();
  for (const auto& row : summary.metrics) {
    Json line;
    line["run"] = row.run;
    for (const auto& metric : row.metrics) {
      line[metric.name] = std::isfinite(metric.value) ? Json(metric.value) : Json(nullptr);
      document["units"][metric.name] = metric.unit;
    }
    document["metrics"].push_back(std::move(line));
  }
  document["verdicts"] = Json::array();
  for (const auto& verdict : summary.verdicts) {
    document["verdicts"].push_back(
        {{"time", verdict.time}, {"name", verdict.name}, {"what", verdict.what}});
  }
  document["events"] = Json::array();
  for (const auto& event : summary.events) {
    document["events"].push_back(
        {{"time", event.time}, {"end", event.end}, {"name", event.name}, {"what", event.what}});
  }
  document["warnings"] = Json::array();
  for (const auto& warning : summary.warnings) {
    document["warnings"].push_back(
        {{"path", warning.path}, {"what", warning.what}, {"allowed", warning.allowed}});
  }
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rotorbench
