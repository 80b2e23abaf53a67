// performance, data-sheet: what a vehicle or a drive comes to, without flying it.
#include <iostream>
#include <memory>

#include "app/rotorbench-cli/commands.h"
#include "app/rotorbench-cli/edits.h"
#include "sim/core/schema_tree.h"
#include "sim/document/experiment.h"
#include "sim/document/flight.h"
#include "sim/io/file.h"
#include "sim/io/json_document.h"
#include "sim/sizing/apply_data_sheet.h"
#include "sim/sizing/data_sheet_figures.h"
#include "sim/sizing/figure_output.h"
#include "sim/sizing/performance.h"

namespace rotorbench::cli {

namespace {

struct SizingOptions {
  std::string file, experiment;
  std::vector<std::string> edits;
  bool json = false;
};

void addEdits(CLI::App& command, SizingOptions& options) {
  command.add_option("--set", options.edits, "Change a parameter: path=value (repeatable)")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  command.add_flag("--json", options.json, "Print one JSON object instead of a table");
}

void print(const std::string& title, const FigureSheet& sheet, bool json) {
  std::cout << (json ? sheetJson(title, sheet) : sheetText(sheet));
  std::cout.flush();
}

void performance(const SizingOptions& options) {
  const Experiment experiment = loadEdited(options.file, options.edits);
  const auto* flight = alternativeIf<Flight>(experiment.setup);
  if (flight == nullptr) {
    throw InputError(options.file, {{"setup", "has no vehicle", "an experiment that flies one"}});
  }
  print(experiment.title, performanceSheet(flight->vehicle, flight->environment), options.json);
}

DataSheet startingSheet(const SizingOptions& options) {
  DataSheet sheet;
  if (!options.experiment.empty()) {
    const auto found = dataSheetOf(loadEdited(options.experiment, {}));
    if (!found) {
      throw InputError(options.experiment,
                       {{"setup", "has no motor", "an experiment with a vehicle or a stand"}});
    }
    sheet = *found;
  }
  if (!options.file.empty()) {
    readDocument(schema::ref(sheet), readTextFile(options.file), options.file);
  }
  return sheet;
}

void dataSheet(const SizingOptions& options) {
  DataSheet sheet = startingSheet(options);
  applyEdits(schema::ref(sheet), options.edits);
  const std::string source = options.edits.empty() ? options.file : "--set";
  const auto warnings = sayWarnings(source, schema::validate(schema::ref(sheet)));
  FigureSheet figures = figuresOf(sheet);
  for (const Problem& warning : warnings) figures.warnings.emplace_back(warning.message());
  print("Data sheet", figures, options.json);
}

}  // namespace

void addPerformanceCommand(CLI::App& app, int& code) {
  auto options = std::make_shared<SizingOptions>();
  auto* command =
      app.add_subcommand("performance", "Print the performance sheet of an experiment's vehicle");
  command->add_option("FILE", options->file, kExperimentHelp)->required();
  addEdits(*command, *options);
  command->callback([options, &code] {
    performance(*options);
    code = kOk;
  });
}

void addDataSheetCommand(CLI::App& app, int& code) {
  auto options = std::make_shared<SizingOptions>();
  auto* command = app.add_subcommand(
      "data-sheet", "Print what follows from the data sheets of motor, propeller and battery");
  command->add_option("FILE", options->file, "Data sheet as JSON (default: an E305 on an F450)");
  command->add_option("--experiment", options->experiment, "Start from this experiment's motor")
      ->type_name("FILE");
  addEdits(*command, *options);
  command->callback([options, &code] {
    dataSheet(*options);
    code = kOk;
  });
}

}  // namespace rotorbench::cli
