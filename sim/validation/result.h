// What a case of the validation gives: figures with the limits they must keep, tables, charts, and
// words on how they came about. Plain values; a page, a JSON file and the tests are made of the
// same ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/io/svg_chart.h"

namespace rotorbench::validation {

/// What a figure is evidence of.
enum class Evidence {
  Fitted,     ///< something was fitted or chosen with what it compares with in view
  SelfCheck,  ///< the program against itself: nothing measured
  HeldOut     ///< against measurements that nothing was fitted to or chosen by
};

/// "fitted", "self-check", "held out".
inline const char* evidenceText(Evidence evidence) {
  switch (evidence) {
    case Evidence::Fitted:
      return "fitted";
    case Evidence::SelfCheck:
      return "self-check";
    case Evidence::HeldOut:
      return "held out";
  }
  return "";
}

/// A figure and the most it may be; without a limit it is only reported.
struct ComparedFigure {
  std::string metric;
  Evidence evidence = Evidence::Fitted;  ///< stands before the unit so that none is left out
  std::string unit;                      ///< "%", "points" of efficiency in percent, "1"
  double value = 0;
  std::optional<double> limit;

  /// NaN passes nothing.
  [[nodiscard]] bool passed() const { return !limit || value <= *limit; }
};

struct Table {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  bool folded = false;  ///< long: shown when asked for
};

struct CaseResult {
  std::string key;      ///< "uiuc-global"
  std::string title;    ///< in words
  std::string method;   ///< what was computed, against what, and what was fitted
  std::string verdict;  ///< why it is worse where it is; empty if there is nothing to say
  std::vector<std::string> sources;
  std::vector<ComparedFigure> figures;
  std::vector<Table> tables;
  std::vector<SvgChart> charts;

  [[nodiscard]] bool passed() const {
    for (const ComparedFigure& figure : figures) {
      if (!figure.passed()) return false;
    }
    return true;
  }
};

}  // namespace rotorbench::validation
