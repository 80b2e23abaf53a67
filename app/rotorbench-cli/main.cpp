// rotorbench-cli: everything that a button of the window computes, from the same file and without a
// display. Exit codes: 0 ok, 1 the run failed, was interrupted or could not be written, 2 the input
// is wrong.
#include <CLI/CLI.hpp>
#include <iostream>

#include "app/rotorbench-cli/commands.h"
#include "sim/core/error.h"
#include "sim/io/output_error.h"

int main(int argc, char** argv) {
  using namespace rotorbench::cli;
  CLI::App app("Simulates and analyses quadrotors and their parts, from experiment files.",
               "rotorbench-cli");
  app.set_version_flag("--version", "rotorbench-cli " ROTORBENCH_VERSION);
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  int code = kOk;
  addRunCommand(app, code);
  addListCommand(app, code);
  addSchemaCommand(app, code);
  addSetCommand(app, code);
  addPerformanceCommand(app, code);
  addDataSheetCommand(app, code);
  addLumpCommand(app, code);
  addValidateCommand(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kOk : kInputWrong;
  } catch (const rotorbench::OutputError& error) {
    std::cerr << error.what() << '\n';
    return kRunFailed;
  } catch (const rotorbench::InputError& error) {
    for (const auto& problem : error.problems()) {
      std::cerr << error.source() << (error.source().empty() ? "" : ":") << problem.message()
                << '\n';
    }
    return kInputWrong;
  } catch (const std::exception& error) {
    std::cerr << "rotorbench-cli: " << error.what() << '\n';
    return kRunFailed;
  }
  // What nobody could read is not done.
  std::cout.flush();
  if (!std::cout && code == kOk) {
    std::cerr << "rotorbench-cli: standard output cannot be written\n";
    return kRunFailed;
  }
  return code;
}
