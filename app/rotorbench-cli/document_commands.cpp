// schema, set: commands about files; nothing is simulated.
#include <iostream>
#include <memory>

#include "app/rotorbench-cli/commands.h"
#include "app/rotorbench-cli/edits.h"
#include "sim/document/experiment_file.h"

namespace rotorbench::cli {

void addSchemaCommand(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("schema", "Print the JSON Schema of experiment files");
  command->callback([&code] {
    std::cout << experimentJsonSchema();
    code = kOk;
  });
}

void addSetCommand(CLI::App& app, int& code) {
  struct Options {
    std::string file, output;
    std::vector<std::string> edits;
  };
  auto options = std::make_shared<Options>();
  auto* set = app.add_subcommand("set", "Write an experiment file with some parameters changed");
  set->add_option("FILE", options->file, kExperimentHelp)->required();
  set->add_option("EDITS", options->edits, "path=value, as for run --set")->required();
  set->add_option("--output,-o", options->output, "File to write (default: standard output)");
  set->callback([options, &code] {
    const Experiment experiment = loadEdited(options->file, options->edits);
    if (options->output.empty()) {
      std::cout << writeExperiment(experiment);
    } else {
      saveExperiment(experiment, options->output);
    }
    code = kOk;
  });
}

}  // namespace rotorbench::cli
