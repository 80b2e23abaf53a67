#include "sim/validation/page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/io/file.h"
#include "sim/validation/text.h"

namespace rotorbench::validation {

namespace {

const char* const kStyle = R"(
:root { color-scheme: light dark; --text: #22262a; --soft: #5b636b; --line: #d9dee3; --ground:
  #ffffff;
  --card: #f6f8fa; --good: #00694b; --bad: #b34700; }
@media (prefers-color-scheme: dark) { :root { --text: #e4e7ea; --soft: #a3abb3; --line: #3a4148;
  --ground: #16191c; --card: #1f2327; --good: #4cc9a0; --bad: #ff9b57; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 72rem; background: var(--ground);
  color: var(--text);
  font: 15px/1.5 "Noto Sans", "DejaVu Sans", system-ui, sans-serif; }
h1 { font-size: 1.6rem; margin: 0 0 .3rem; }
h2 { font-size: 1.2rem; margin: 2.6rem 0 .4rem; padding-top: 1rem; border-top: 1px solid
  var(--line); }
p { max-width: 54rem; margin: .4rem 0; }
.soft { color: var(--soft); }
a { color: inherit; }
table { border-collapse: collapse; margin: .6rem 0; font-variant-numeric: tabular-nums; font-size:
  .92em; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { padding: .22rem .8rem .22rem 0; border-bottom: 1px solid var(--line); text-align: right;
  vertical-align: top; }
th { color: var(--soft); font-weight: 600; }
th:first-child, td:first-child { text-align: left; }
.scroll { overflow-x: auto; }
.good { color: var(--good); font-weight: 600; } .bad { color: var(--bad); font-weight: 600; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(20rem, 1fr)); gap: 1rem;
  margin: 1rem 0; }
.charts svg { width: 100%; height: auto; background: var(--card); border-radius: 6px; padding:
  .3rem; }
.chart .grid { stroke: var(--line); stroke-width: 1; } .chart .axis { stroke: var(--soft);
  stroke-width: 1; }
details summary { cursor: pointer; color: var(--soft); }
@media print { body { padding: 0; max-width: none; font-size: 10.5pt; } .charts svg, table {
  break-inside: avoid; }
  h2 { break-after: avoid; } }
)";

constexpr std::size_t kEvidenceWidth = 10;  // of the longest, "self-check"

/// Enough digits to compare with a limit.
std::string shown(double value) {
  return fixed(value, std::abs(value) < 0.1 ? 3 : 2);
}

std::string outcome(const ComparedFigure& figure) {
  if (!figure.limit) return "<td class=\"soft\">reported</td>";
  return figure.passed() ? "<td class=\"good\">\u2713 holds</td>"
                         : "<td class=\"bad\">\u2717 missed</td>";
}

std::string figureRows(const CaseResult& result) {
  std::string html;
  for (const ComparedFigure& f : result.figures) {
    html += "<tr><td>" + escapedMarkup(f.metric) + "</td><td>" + evidenceText(f.evidence) +
            "</td><td>" + shown(f.value) + "</td><td>" + (f.limit ? numberText(*f.limit) : "") +
            "</td><td>" + escapedMarkup(f.unit == "1" ? "" : f.unit) + "</td>" + outcome(f) +
            "</tr>\n";
  }
  return html;
}

std::string tableHtml(const Table& table) {
  std::string html = "<div class=\"scroll\"><table><caption>" + escapedMarkup(table.title) +
                     "</caption><thead><tr>";
  for (const std::string& head : table.header) html += "<th>" + escapedMarkup(head) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const std::string& cell : row) html += "<td>" + escapedMarkup(cell) + "</td>";
    html += "</tr>\n";
  }
  html += "</tbody></table></div>\n";
  if (!table.folded) return html;
  return "<details><summary>" + escapedMarkup(table.title) + "</summary>" + html + "</details>\n";
}

std::string section(const CaseResult& result) {
  std::string html = "<h2 id=\"" + escapedMarkup(result.key) + "\">" + escapedMarkup(result.title) +
                     "</h2>\n<p>" + escapedMarkup(result.method) + "</p>\n";
  html +=
      "<div class=\"scroll\"><table><thead><tr><th>Figure</th><th>Evidence</th><th>Value</th>"
      "<th>Limit</th>"
      "<th>Unit</th><th></th></tr></thead><tbody>\n" +
      figureRows(result) + "</tbody></table></div>\n";
  if (!result.verdict.empty()) html += "<p>" + escapedMarkup(result.verdict) + "</p>\n";
  for (const Table& table : result.tables) html += tableHtml(table);
  if (!result.charts.empty()) {
    html += "<div class=\"charts\">\n";
    for (const SvgChart& chart : result.charts) html += svgChart(chart);
    html += "</div>\n";
  }
  for (const std::string& source : result.sources) {
    html += "<p class=\"soft\">Source: " + escapedMarkup(source) + ".</p>\n";
  }
  return html;
}

std::size_t limitsOf(const CaseResult& result, bool onlyMissed) {
  std::size_t count = 0;
  for (const ComparedFigure& f : result.figures) {
    if (f.limit && !(onlyMissed && f.passed())) ++count;
  }
  return count;
}

/// "12 fitted", "2 held out, 4 fitted".
std::string evidenceOf(const CaseResult& result) {
  std::string text;
  for (const Evidence kind : {Evidence::HeldOut, Evidence::Fitted, Evidence::SelfCheck}) {
    const auto count = std::ranges::count(result.figures, kind, &ComparedFigure::evidence);
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + ' ' + evidenceText(kind);
  }
  return text;
}

/// One line a case, with links to the sections.
std::string overview(const std::vector<CaseResult>& results) {
  std::string html =
      "<div "
      "class=\"scroll\"><table><thead><tr><th>Case</th><th>Figures</th><th>Limits</th><th></th></"
      "tr>"
      "</thead><tbody>\n";
  for (const CaseResult& r : results) {
    const std::size_t limits = limitsOf(r, false), missed = limitsOf(r, true);
    html += "<tr><td><a href=\"#" + escapedMarkup(r.key) + "\">" + escapedMarkup(r.title) +
            "</a></td><td>" + evidenceOf(r) + "</td><td>" + std::to_string(limits) + "</td>";
    if (limits == 0) {
      html += "<td class=\"soft\">reported</td>";
    } else if (missed == 0) {
      html += "<td class=\"good\">\u2713 all hold</td>";
    } else {
      html += "<td class=\"bad\">\u2717 " + std::to_string(missed) + " missed</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

nlohmann::ordered_json chartJson(const SvgChart& chart) {
  nlohmann::ordered_json series = nlohmann::ordered_json::array();
  for (const SvgSeries& s : chart.series) {
    series.push_back({{"name", s.name}, {"points", s.points}});
  }
  return {{"title", chart.title}, {"x", chart.x.label}, {"y", chart.y.label}, {"series", series}};
}

nlohmann::ordered_json caseJson(const CaseResult& result) {
  nlohmann::ordered_json figures = nlohmann::ordered_json::array();
  for (const ComparedFigure& f : result.figures) {
    nlohmann::ordered_json figure{{"metric", f.metric},
                                  {"evidence", evidenceText(f.evidence)},
                                  {"unit", f.unit},
                                  {"value", f.value}};
    figure["limit"] = f.limit ? nlohmann::ordered_json(*f.limit) : nlohmann::ordered_json();
    figure["passed"] = f.passed();
    figures.push_back(std::move(figure));
  }
  nlohmann::ordered_json tables = nlohmann::ordered_json::array(), charts = tables;
  for (const Table& t : result.tables) {
    tables.push_back({{"title", t.title}, {"header", t.header}, {"rows", t.rows}});
  }
  for (const SvgChart& chart : result.charts) charts.push_back(chartJson(chart));
  return {{"case", result.key},      {"title", result.title},    {"passed", result.passed()},
          {"method", result.method}, {"remark", result.verdict}, {"sources", result.sources},
          {"figures", figures},      {"tables", tables},         {"charts", charts}};
}

bool allPassed(const std::vector<CaseResult>& results) {
  for (const CaseResult& r : results) {
    if (!r.passed()) return false;
  }
  return true;
}

/// Quoted where a comma or a quote is inside.
std::string csvText(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string pageHtml(const std::vector<CaseResult>& results) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>Rotorbench validation</title><style>" +
      std::string(kStyle) + "</style></head><body>\n<h1>Rotorbench validation</h1>\n";
  html +=
      "<p class=\"soft\">Models of this program against measurements of others. Points are "
      "measured, lines are computed. A figure is held out where nothing was fitted to what it "
      "compares with, fitted where something was fitted to it or chosen with it in view, and a "
      "self-check where the program is compared with itself.</p>\n";
  html += overview(results);
  for (const CaseResult& r : results) html += section(r);
  return html + "</body></html>\n";
}

std::string resultsJson(const std::vector<CaseResult>& results) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CaseResult& r : results) list.push_back(caseJson(r));
  const nlohmann::ordered_json json{{"passed", allPassed(results)}, {"cases", list}};
  return json.dump(1) + '\n';
}

std::string resultsCsv(const std::vector<CaseResult>& results) {
  std::string csv = "case,metric,evidence,unit,value,limit,passed\n";
  for (const CaseResult& r : results) {
    for (const ComparedFigure& f : r.figures) {
      csv += r.key + ',' + csvText(f.metric) + ',' + evidenceText(f.evidence) + ',' +
             csvText(f.unit) + ',' + numberText(f.value) + ',' +
             (f.limit ? numberText(*f.limit) : "") + ',' + (f.passed() ? "1" : "0") + '\n';
    }
  }
  return csv;
}

std::string resultsText(const std::vector<CaseResult>& results) {
  std::string text;
  for (const CaseResult& r : results) {
    text += r.title + '\n';
    for (const ComparedFigure& f : r.figures) {
      const std::string unit = f.unit == "1" ? "" : " " + f.unit;
      std::string evidence = evidenceText(f.evidence);
      evidence.resize(kEvidenceWidth, ' ');
      const char* held = !f.limit ? "      " : f.passed() ? "holds " : "MISSED";
      text.append("  ").append(evidence).append("  ").append(held).append("  ");
      text.append(shown(f.value)).append(unit);
      if (f.limit) text += " (limit " + numberText(*f.limit) + ")";
      text += "  " + f.metric + '\n';
    }
  }
  return text;
}

std::vector<std::filesystem::path> writeReport(const std::filesystem::path& folder,
                                               const std::vector<CaseResult>& results) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw InputError(folder.string(), {{{}, "the folder cannot be made", {}}});
  }
  const std::vector<std::filesystem::path> files{folder / "index.html", folder / "results.json",
                                                 folder / "results.csv"};
  writeFileAtomically(files[0], pageHtml(results));
  writeFileAtomically(files[1], resultsJson(results));
  writeFileAtomically(files[2], resultsCsv(results));
  return files;
}

}  // namespace rotorbench::validation
