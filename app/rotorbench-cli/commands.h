// The subcommands of rotorbench-cli. Each add…Command declares its options and, when chosen, does
// its work inside CLI11's parse and leaves its exit code in `code`; wrong input is thrown as
// InputError.
#pragma once

#include <CLI/CLI.hpp>

namespace rotorbench::cli {

inline constexpr int kOk = 0;
inline constexpr int kRunFailed = 1;
inline constexpr int kInputWrong = 2;

void addRunCommand(CLI::App& app, int& code);
void addListCommand(CLI::App& app, int& code);
void addSchemaCommand(CLI::App& app, int& code);
void addSetCommand(CLI::App& app, int& code);
void addPerformanceCommand(CLI::App& app, int& code);
void addDataSheetCommand(CLI::App& app, int& code);
void addLumpCommand(CLI::App& app, int& code);
void addValidateCommand(CLI::App& app, int& code);

}  // namespace rotorbench::cli
