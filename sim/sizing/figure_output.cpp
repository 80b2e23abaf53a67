#include "sim/sizing/figure_output.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/number_text.h"

namespace rotorbench {

namespace {

/// Characters on screen; names and units are UTF-8.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t columns) {
  return text + std::string(columns > width(text) ? columns - width(text) : 0, ' ');
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

}  // namespace

std::string sheetText(const FigureSheet& sheet, const NumberWriter& write) {
  std::size_t labels = 0, symbols = 0;
  for (const auto& f : sheet.figures) {
    labels = std::max(labels, width(f.label));
    symbols = std::max(symbols, width(f.symbol));
  }
  std::string text, group;
  for (const auto& f : sheet.figures) {
    if (f.group != group) {
      text += (text.empty() ? "" : "\n") + f.group + '\n';
      group = f.group;
    }
    text += "  " + padded(f.label, labels) + "  " + padded(f.symbol, symbols) + "  " +
            figureText(f, write) + '\n';
    if (!f.note.empty()) text += "      " + f.note.text(write) + '\n';
  }
  for (const auto& warning : sheet.warnings) text += "\nWarning: " + warning.text(write);
  return text + (sheet.warnings.empty() ? "" : "\n");
}

std::string sheetJson(const std::string& title, const FigureSheet& sheet) {
  nlohmann::ordered_json figures = nlohmann::ordered_json::array();
  for (const auto& f : sheet.figures) {
    nlohmann::ordered_json value = nullptr;
    if (std::isfinite(f.value)) value = f.value;
    figures.push_back({{"key", f.key},
                       {"group", f.group},
                       {"label", f.label},
                       {"symbol", f.symbol},
                       {"value", std::move(value)},
                       {"unit", f.unit},
                       {"formula", f.formula.text()},
                       {"source", f.source},
                       {"note", f.note.text()}});
  }
  nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
  for (const auto& warning : sheet.warnings) warnings.push_back(warning.text());
  const nlohmann::ordered_json root{
      {"title", title}, {"figures", std::move(figures)}, {"warnings", std::move(warnings)}};
  return root.dump(2) + '\n';
}

std::string sheetCsv(const FigureSheet& sheet) {
  std::string csv = "group,quantity,symbol,value,unit,formula,note\n";
  for (const auto& f : sheet.figures) {
    const std::string value = std::isfinite(f.value) ? numberText(f.value) : std::string();
    csv += quoted(f.group) + ',' + quoted(f.label) + ',' + quoted(f.symbol) + ',' + value + ',' +
           quoted(f.unit) + ',' + quoted(f.formula.text()) + ',' + quoted(f.note.text()) + '\n';
  }
  return csv;
}

}  // namespace rotorbench
