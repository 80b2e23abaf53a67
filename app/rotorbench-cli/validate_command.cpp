// validate: computes the cases of the validation and writes their report.
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>

#include "app/rotorbench-cli/commands.h"
#include "sim/document/resources.h"
#include "sim/validation/cases.h"
#include "sim/validation/page.h"

namespace rotorbench::cli {

namespace {

int validate(const std::string& output, const std::vector<std::string>& chosen) {
  std::vector<std::string> keys = chosen;
  if (keys.empty()) {
    for (const auto& c : validation::cases()) {
      if (!c.onDemand) keys.emplace_back(c.key);
    }
  }
  std::vector<validation::CaseResult> results;
  bool passed = true;
  for (const std::string& key : keys) {
    const auto begin = std::chrono::steady_clock::now();
    results.push_back(validation::runCase(key, resourceDirectory()));
    passed = passed && results.back().passed();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    std::fprintf(stderr, "%s: %.1f s\n", key.c_str(), spent.count());
  }
  for (const auto& file : validation::writeReport(output, results)) {
    std::cerr << "wrote " << file.string() << '\n';
  }
  std::cout << validation::resultsText(results) << std::flush;
  return passed && std::cout ? kOk : kRunFailed;
}

}  // namespace

void addValidateCommand(CLI::App& app, int& code) {
  struct Options {
    std::string output;
    std::vector<std::string> cases;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand(
      "validate", "Compare the models with measurements and write a report with plots");
  command
      ->add_option("--output,-o", options->output,
                   "Directory for index.html, results.json and results.csv")
      ->type_name("DIR")
      ->required();
  std::string known;
  for (const auto& c : validation::cases()) {
    known += (known.empty() ? "" : ", ") + std::string(c.key);
    if (c.onDemand) known += " (minutes; only where named)";
  }
  command->add_option("--case", options->cases, "Only this case (repeatable): " + known)
      ->allow_extra_args(false)
      ->type_name("NAME");
  command->callback([options, &code] { code = validate(options->output, options->cases); });
}

}  // namespace rotorbench::cli
