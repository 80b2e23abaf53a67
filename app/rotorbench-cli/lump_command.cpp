// lump: coefficients that stand for a propeller given by its blades or by tables.
#include <iostream>
#include <memory>

#include "app/rotorbench-cli/commands.h"
#include "app/rotorbench-cli/edits.h"
#include "sim/core/constants.h"
#include "sim/core/schema_tree.h"
#include "sim/core/units.h"
#include "sim/document/experiment_file.h"
#include "sim/sizing/figure_output.h"
#include "sim/sizing/lumping.h"

namespace rotorbench::cli {

namespace {

struct LumpOptions {
  std::string file, output, rotor, speed, inPlane, axial;
  std::vector<std::string> edits;
  bool json = false;
};

/// The rotor that is meant: the only one, or the one at the path.
RotorModelAt chosenRotor(const Experiment& experiment, const LumpOptions& options) {
  std::vector<RotorModelAt> all = rotorModelsIn(schema::ref(experiment));
  std::string paths;
  for (RotorModelAt& one : all) {
    if (one.path == options.rotor || (options.rotor.empty() && all.size() == 1)) return one;
    paths += (paths.empty() ? "" : ", ") + one.path;
  }
  if (all.empty())
    throw InputError(options.file, {{"setup", "has no propeller that could be lumped",
                                     "an experiment with a propeller by its blades or tables"}});
  throw InputError(options.file,
                   {{"--rotor",
                     options.rotor.empty() ? "is needed, for there are several"
                                           : "'" + options.rotor + "' is none of them",
                     "one of " + paths}});
}

/// A quantity above 0 as typed, in SI; `text` may be empty. Without a unit it is in `shown`.
void readInto(double& value, const std::string& text, const char* option, const char* unit,
              const char* shown) {
  if (text.empty()) return;
  const ParsedQuantity read = parseQuantity(text, unit, shown);
  if (!read.value) throw InputError({}, {{option, "'" + text + "': " + read.error, {}}});
  if (!(*read.value > 0))
    throw InputError({}, {{option, "'" + text + "' is not allowed", "a speed above 0"}});
  value = *read.value;
}

LumpingRange rangeOf(const Experiment& experiment, const RotorModelAt& rotor,
                     const LumpOptions& options) {
  const auto hover = lumpingRangeOf(experiment, rotor);
  if (!hover && options.speed.empty())
    throw InputError(options.file, {{"--speed", "is needed, for nothing hovers here",
                                     "the speed about which the coefficients are to hold"}});
  double speed = hover ? hover->speed : 0;
  readInto(speed, options.speed, "--speed", "rad/s", "rpm");
  LumpingRange range = lumpingRange(rotor.model, speed, hover ? hover->density : kStandardDensity);
  readInto(range.inPlane, options.inPlane, "--air-speed", "m/s", "m/s");
  readInto(range.axial, options.axial, "--climb", "m/s", "m/s");
  return range;
}

void lump(const LumpOptions& options) {
  Experiment experiment = loadEdited(options.file, options.edits);
  const RotorModelAt rotor = chosenRotor(experiment, options);
  const LumpingRange range = rangeOf(experiment, rotor, options);
  const LumpedEquivalent lumped = lumpedEquivalent(rotor.model, range);
  const FigureSheet sheet = lumpingSheet(lumped, range);
  std::cout << (options.json ? sheetJson("Lumped coefficients", sheet) : sheetText(sheet));
  std::cout.flush();
  if (options.output.empty()) return;
  useLumped(schema::ref(experiment), rotor.path, lumped.coefficients);
  saveExperiment(experiment, options.output);
}

}  // namespace

void addLumpCommand(CLI::App& app, int& code) {
  auto options = std::make_shared<LumpOptions>();
  auto* command = app.add_subcommand(
      "lump", "Print lumped coefficients that stand for a propeller given by blades or tables");
  command->add_option("FILE", options->file, kExperimentHelp)->required();
  command->add_option("--rotor", options->rotor, "Path of the rotor's model, where there are more")
      ->type_name("PATH");
  command
      ->add_option(
          "--speed", options->speed,
          "Rotor speed about which they hold, in rpm unless it says another unit (default: that of "
          "the hover)")
      ->type_name("SPEED");
  command
      ->add_option("--air-speed", options->inPlane,
                   "Largest in-plane air speed (default: a tenth of the tips')")
      ->type_name("SPEED");
  command
      ->add_option("--climb", options->axial,
                   "Largest climb and descent (default: 0.4 of the induced velocity)")
      ->type_name("SPEED");
  command->add_option("--output,-o", options->output,
                      "Write the experiment with these coefficients in the propeller's place");
  command->add_option("--set", options->edits, "Change a parameter: path=value (repeatable)")
      ->allow_extra_args(false)
      ->type_name("PATH=VALUE");
  command->add_flag("--json", options->json, "Print one JSON object instead of a table");
  command->callback([options, &code] {
    lump(*options);
    code = kOk;
  });
}

}  // namespace rotorbench::cli
