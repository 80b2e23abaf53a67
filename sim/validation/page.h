// The results of a validation as files: one HTML page that needs nothing beside it, and the raw
// numbers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/validation/result.h"

namespace rotorbench::validation {

/// A complete page, light or dark as the reader's system is, fit to be printed.
std::string pageHtml(const std::vector<CaseResult>& results);

/// {"passed": …, "cases": [{"case": …, "figures": […], "tables": […], "charts": […]}]} with every
/// point of the charts; what is no finite number is null.
std::string resultsJson(const std::vector<CaseResult>& results);

/// case,metric,evidence,unit,value,limit,passed; one figure a line, the limit empty
/// where there is none.
std::string resultsCsv(const std::vector<CaseResult>& results);

/// One line a figure, for a terminal.
std::string resultsText(const std::vector<CaseResult>& results);

/// Writes index.html, results.json and results.csv into `folder`, which is made if need be. Returns
/// the files. Throws InputError where that is not possible.
std::vector<std::filesystem::path> writeReport(const std::filesystem::path& folder,
                                               const std::vector<CaseResult>& results);

}  // namespace rotorbench::validation
