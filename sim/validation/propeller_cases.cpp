// The 101 propellers of the UIUC Propeller Data Site, static and in flight, with one set of model
// constants; and the same with one twist offset per propeller that is fitted to its static
// coefficients.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sim/core/parallel.h"
#include "sim/validation/cases.h"
#include "sim/validation/propeller_scores.h"
#include "sim/validation/section_fit.h"
#include "sim/validation/statistics.h"
#include "sim/validation/text.h"

namespace rotorbench::validation {

namespace {

struct ScoredSet {
  const PropellerSet* set = nullptr;
  double offset = 0;  // rad
  PropellerScore score;
};

/// The figures of a score that are judged, in the order of the report.
struct Judged {
  const char* name;
  const char* unit;
  std::optional<double> (*of)(const PropellerScore&);
};
constexpr std::array<Judged, 6> kJudged{
    Judged{"static CT", "%", [](const PropellerScore& s) { return std::optional(s.thrust); }},
    Judged{"static CP", "%", [](const PropellerScore& s) { return std::optional(s.power); }},
    Judged{"CT/CT0 in flight", "%", [](const PropellerScore& s) { return s.flightThrust; }},
    Judged{"CP/CP0 in flight", "%", [](const PropellerScore& s) { return s.flightPower; }},
    Judged{"peak efficiency", "points", [](const PropellerScore& s) { return s.peak; }},
    Judged{"J at zero thrust", "%", [](const PropellerScore& s) { return s.zeroThrust; }}};

/// Most of median and 90 % quantile; none: only reported.
using Limits = std::array<std::optional<std::array<double, 2>>, kJudged.size()>;

/// Pitch over diameter as printed.
struct PitchClass {
  const char* name;
  double low, high;
};
constexpr double kEdge = 1e-9;  // of printed ratios such as 7/10
constexpr std::array<PitchClass, 4> kClasses{PitchClass{"P/D not printed", -1, kEdge},
                                             PitchClass{"P/D below 0.5", kEdge, 0.5 - kEdge},
                                             PitchClass{"P/D 0.5 to 0.7", 0.5 - kEdge, 0.7 + kEdge},
                                             PitchClass{"P/D above 0.7", 0.7 + kEdge, 10}};

std::vector<ScoredSet> scored(const std::vector<PropellerSet>& sets, bool fitted) {
  return inParallel(sets.size(), [&](std::size_t i) {
    ScoredSet result{&sets[i], fitted ? fittedTwistOffset(sets[i]) : 0, {}};
    PropellerGeometry geometry = sets[i].geometry;
    geometry.twistOffset = result.offset;
    result.score = scoreOf(sets[i], BladeElementRotor(geometry));
    return result;
  });
}

std::vector<double> errors(const std::vector<ScoredSet>& sets, const Judged& judged,
                           const PitchClass& pitch = {"", -HUGE_VAL, HUGE_VAL}) {
  std::vector<double> all;
  for (const ScoredSet& s : sets) {
    if (!(s.set->pitchRatio >= pitch.low && s.set->pitchRatio < pitch.high)) continue;
    if (const auto error = judged.of(s.score)) all.push_back(*error);
  }
  return all;
}

std::vector<ComparedFigure> figures(const std::vector<ScoredSet>& sets, const Limits& limits,
                                    Evidence evidence = Evidence::Fitted) {
  std::vector<ComparedFigure> result;
  for (std::size_t i = 0; i < kJudged.size(); ++i) {
    const std::vector<double> all = errors(sets, kJudged.at(i));
    const auto& limit = limits.at(i);
    const std::string name = kJudged.at(i).name;
    result.push_back({name + ", median", evidence, kJudged.at(i).unit, quantile(all, 0.5),
                      limit ? std::optional((*limit)[0]) : std::nullopt});
    result.push_back({name + ", 90 % quantile", evidence, kJudged.at(i).unit, quantile(all, 0.9),
                      limit ? std::optional((*limit)[1]) : std::nullopt});
  }
  return result;
}

Table classTable(const std::vector<ScoredSet>& sets) {
  Table table{"By pitch class: median/90 % quantile over sets", {"Class", "Sets"}, {}};
  for (const Judged& judged : kJudged) {
    table.header.push_back(std::string(judged.name) + ", " + judged.unit);
  }
  const auto addRow = [&](const std::string& name, const PitchClass& pitch) {
    std::vector<std::string> row{name, std::to_string(errors(sets, kJudged[0], pitch).size())};
    for (const Judged& judged : kJudged) {
      const auto some = errors(sets, judged, pitch);
      row.push_back(fixed(quantile(some, 0.5), 1) + "/" + fixed(quantile(some, 0.9), 1));
    }
    table.rows.push_back(std::move(row));
  };
  for (const PitchClass& pitch : kClasses) addRow(pitch.name, pitch);
  addRow("all", {"", -HUGE_VAL, HUGE_VAL});
  return table;
}

std::string nameOf(const PropellerSet& set) {
  return set.propeller + " (volume " + std::to_string(set.volume) + ")";
}

Table setTable(const std::vector<ScoredSet>& sets) {
  Table table{"Every propeller", {"Propeller", "Static run", "P/D", "Twist offset, deg"}, {}, true};
  for (const Judged& judged : kJudged) {
    table.header.push_back(std::string(judged.name) + ", " + judged.unit);
  }
  for (const ScoredSet& s : sets) {
    std::vector<std::string> row{nameOf(*s.set), s.set->run, fixed(s.set->pitchRatio, 2),
                                 fixed(s.offset * 180 / std::numbers::pi, 1)};
    for (const Judged& judged : kJudged) {
      row.push_back(fixed(judged.of(s.score).value_or(std::nan("")), 1));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Static coefficients, the mean over the speeds of each set, model over measurement.
SvgChart staticScatter(const std::vector<ScoredSet>& sets, bool thrust) {
  const char* name = thrust ? "CT" : "CP";
  SvgChart chart{std::string("Static ") + name + ", mean over the speeds",
                 {std::string("Measured ") + name, 0, {}},
                 {std::string("Computed ") + name, 0, {}},
                 {}};
  SvgSeries points{"Propellers", SvgSeries::Style::Points, 0, {}};
  double most = 0;
  for (const ScoredSet& s : sets) {
    PropellerGeometry geometry = s.set->geometry;
    geometry.twistOffset = s.offset;
    const BladeElementRotor rotor(geometry);
    std::vector<double> model, measured;
    for (const PropellerPoint& p : s.set->still) {
      const Coefficients c = coefficients(rotor, p.speed, 0);
      model.push_back(thrust ? c.thrust : c.power);
      measured.push_back(thrust ? p.thrust : p.power);
    }
    points.points.push_back({mean(measured), mean(model)});
    most = std::max({most, mean(measured), mean(model)});
  }
  chart.series.push_back({"", SvgSeries::Style::Line, 6, {{0, 0}, {most, most}}});
  chart.series.push_back({"10 % apart", SvgSeries::Style::Dashed, 6, {{0, 0}, {most / 1.1, most}}});
  chart.series.push_back({"", SvgSeries::Style::Dashed, 6, {{0, 0}, {most, most / 1.1}}});
  chart.series.push_back(std::move(points));
  return chart;
}

SvgChart cumulative(const std::vector<ScoredSet>& sets) {
  constexpr double kMost = 40;  // beyond it lie single sets
  SvgChart chart{"Share of the propellers with at most this error",
                 {"Error, % (peak efficiency: points)", 0, kMost},
                 {"Share, %", 0, 100},
                 {}};
  int color = 0;
  for (const Judged& judged : kJudged) {
    std::vector<double> all = errors(sets, judged);
    std::sort(all.begin(), all.end());
    SvgSeries line{judged.name, SvgSeries::Style::Line, color++, {{0, 0}}};
    for (std::size_t i = 0; i < all.size() && all[i] <= kMost; ++i) {
      const double share = 100.0 * static_cast<double>(i + 1) / static_cast<double>(all.size());
      line.points.push_back({all[i], line.points.back()[1]});
      line.points.push_back({all[i], share});
    }
    chart.series.push_back(std::move(line));
  }
  return chart;
}

/// Thrust and power of all runs in flight of a propeller, points measured, lines computed.
SvgChart flightChart(const ScoredSet& s, const std::string& rank) {
  SvgChart chart{rank + ": " + nameOf(*s.set), {"Advance ratio J", 0, {}}, {"CT, CP", {}, {}}, {}};
  PropellerGeometry geometry = s.set->geometry;
  geometry.twistOffset = s.offset;
  const BladeElementRotor rotor(geometry);
  SvgSeries thrust{"CT measured", SvgSeries::Style::Points, 0, {}};
  SvgSeries power{"CP measured", SvgSeries::Style::Points, 1, {}};
  SvgSeries modelThrust{"CT computed", SvgSeries::Style::Line, 0, {}};
  SvgSeries modelPower{"CP computed", SvgSeries::Style::Line, 1, {}};
  for (const auto& run : s.set->flights) {
    for (const PropellerPoint& p : run) {
      thrust.points.push_back({p.advance, p.thrust});
      power.points.push_back({p.advance, p.power});
      const Coefficients c = coefficients(rotor, p.speed, p.advance);
      modelThrust.points.push_back({p.advance, c.thrust});
      modelPower.points.push_back({p.advance, c.power});
    }
    modelThrust.points.push_back({std::nan(""), 0});
    modelPower.points.push_back({std::nan(""), 0});
  }
  chart.series = {modelThrust, modelPower, thrust, power};
  return chart;
}

/// Best, median and worst by the mean of the errors at rest and in flight.
std::vector<SvgChart> representatives(const std::vector<ScoredSet>& sets) {
  std::vector<std::pair<double, const ScoredSet*>> order;
  for (const ScoredSet& s : sets) {
    if (!s.score.flightThrust || !s.score.flightPower) continue;
    order.emplace_back(
        (s.score.thrust + s.score.power + *s.score.flightThrust + *s.score.flightPower) / 4, &s);
  }
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  if (order.empty()) return {};
  return {flightChart(*order.front().second, "Best"),
          flightChart(*order[order.size() / 2].second, "Median"),
          flightChart(*order.back().second, "Worst")};
}

CaseResult propellers(const std::filesystem::path& resources, bool fitted, const Limits& limits) {
  const auto sets = readPropellerSets(resources / "validation" / "uiuc");
  const auto scores = scored(sets, fitted);
  CaseResult result;
  result.figures = figures(scores, limits);
  result.tables = {classTable(scores), setTable(scores)};
  result.charts = {staticScatter(scores, true), staticScatter(scores, false), cumulative(scores)};
  for (SvgChart& chart : representatives(scores)) result.charts.push_back(std::move(chart));
  result.sources = {
      "J. B. Brandt, R. W. Deters, G. K. Ananda, O. D. Dantsker, M. S. Selig, UIUC Propeller "
      "Database, volumes 1 to 4, University of Illinois at Urbana-Champaign"};
  return result;
}

}  // namespace

CaseResult propellersWithGlobalConstants(const std::filesystem::path& resources) {
  CaseResult result = propellers(
      resources, false,
      {{{{6.5, 18}}, {{9.6, 25}}, {{8.2, 19}}, {{9.6, 28}}, {{4.1, 10.5}}, {{5.2, 14.5}}}});
  result.key = "uiuc-global";
  result.title = "101 propellers with one set of constants";
  result.method =
      "Blade elements with the analytic section, from the measured chord and twist and the printed "
      "pitch. Nothing is fitted to a single propeller; the section's constants and the momentum "
      "factor are one fit to all of them. Error of a set: mean over its points; in flight over the "
      "measured static coefficient. Median and 90 % quantile are over the sets.";
  result.verdict =
      "Most of the scatter is the section, which is not known: specimens of one design differ by "
      "4 to 6 % in CT, and one degree of twist is 5 % of CT and 9 % of CP.";
  return result;
}

CaseResult propellersWithTwistOffset(const std::filesystem::path& resources) {
  CaseResult result = propellers(
      resources, true, {{{{4.2, 7.5}}, {{3.1, 7.2}}, {{5.6, 10}}, {{6.4, 12.6}}, {}, {}}});
  result.key = "uiuc-offset";
  result.title = "101 propellers with one twist offset each";
  result.method =
      "As before, but one number is fitted to each propeller: an angle added to its twist "
      "everywhere, by least squares of ln(computed/measured) of CT and CP at rest, both alike. "
      "What is measured in flight is predicted.";
  return result;
}

namespace {

/// "apcsf" of "apcsf_10x4.7".
std::map<std::string, std::vector<const PropellerSet*>> familiesOf(
    const std::vector<PropellerSet>& sets) {
  std::map<std::string, std::vector<const PropellerSet*>> families;
  for (const PropellerSet& set : sets)
    families[set.propeller.substr(0, set.propeller.find('_'))].push_back(&set);
  return families;
}

std::vector<ScoredSet> scoredWith(const std::vector<const PropellerSet*>& sets,
                                  const BladeConstants& constants) {
  return inParallel(sets.size(), [&](std::size_t i) {
    return ScoredSet{sets[i], 0, scoreOf(*sets[i], rotorWith(sets[i]->geometry, constants))};
  });
}

}  // namespace

CaseResult propellersOfHeldOutFamilies(const std::filesystem::path& resources) {
  const auto sets = readPropellerSets(resources / "validation" / "uiuc");
  const auto families = familiesOf(sets);
  std::vector<ScoredSet> all;
  Table table{"By family: median over its sets", {"Family", "Sets"}, {}};
  for (const Judged& judged : kJudged) {
    table.header.push_back(std::string(judged.name) + ", " + judged.unit);
  }
  for (const auto& [name, family] : families) {
    std::vector<const PropellerSet*> others;
    for (const auto& [other, some] : families) {
      if (other != name) others.insert(others.end(), some.begin(), some.end());
    }
    const auto scores = scoredWith(family, fittedConstants(others));
    std::vector<std::string> row{name, std::to_string(family.size())};
    for (const Judged& judged : kJudged)
      row.push_back(fixed(quantile(errors(scores, judged), 0.5), 1));
    table.rows.push_back(std::move(row));
    all.insert(all.end(), scores.begin(), scores.end());
  }
  CaseResult result;
  result.key = "uiuc-families";
  result.title = "101 propellers, each family held out";
  result.method =
      "The families of the data site one by one: the section's constants, the momentum factor and "
      "the weight of the printed pitch are fitted to all the others, from textbook values, and the "
      "family is predicted. So a propeller of a make the program has not seen is met. The fit is "
      "simpler than the one that gave the program's own constants: robust least squares, a few "
      "points of each run, every propeller with the same weight.";
  result.verdict =
      "A family whose sections are unlike all others', such as the DA4052, is met worst: no "
      "constants of other blades know it.";
  result.sources = {
      "J. B. Brandt, R. W. Deters, G. K. Ananda, O. D. Dantsker, M. S. Selig, UIUC Propeller "
      "Database, volumes 1 to 4, University of Illinois at Urbana-Champaign"};
  result.figures = figures(all, {}, Evidence::HeldOut);
  result.tables = {std::move(table), setTable(all)};
  result.charts = {cumulative(all)};
  return result;
}

}  // namespace rotorbench::validation
