#include "sim/run/run_files.h"

#include <algorithm>
#include <ostream>
#include <streambuf>
#include <utility>

#include "sim/document/experiment_file.h"
#include "sim/io/csv.h"
#include "sim/io/csv_quoting.h"
#include "sim/io/file.h"
#include "sim/io/metrics_output.h"

namespace rotorbench {

namespace fs = std::filesystem;

std::string recordingFileName(const std::string& runName, std::size_t runCount) {
  if (runCount <= 1) return "recording.csv";
  std::string name = "recording";
  bool gap = true;
  for (const char c : runName) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (plain && gap) name += '-';
    if (plain) name += c;
    gap = !plain;
  }
  return name + ".csv";
}

void prepareRunDirectory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error || !fs::is_directory(directory, error)) {
    throw InputError("--output", {{directory.string(), "cannot be used as a directory",
                                   "name one that can be written"}});
  }
}

std::vector<fs::path> writeRunFiles(const fs::path& directory, const Experiment& experiment,
                                    const std::vector<RunOutput>& runs, const RunSummary& summary) {
  prepareRunDirectory(directory);
  std::vector<fs::path> files;
  const auto writeText = [&](const char* name, const std::string& text) {
    writeFileAtomically(directory / name, text);
    files.push_back(directory / name);
  };
  writeText("experiment.json", writeExperiment(experiment));
  writeText("metrics.json", metricsJson(experiment.title, summary));
  writeText("metrics.txt", metricsText(summary.metrics));
  for (const auto& run : runs) {
    const fs::path file = directory / recordingFileName(run.name, runs.size());
    writeFileAtomically(file, [&](std::ostream& out) { writeCsv(out, *run.recording); });
    files.push_back(file);
  }
  return files;
}

namespace {

/// Puts a cell in front of every line that passes through, except the header of all runs but the
/// first.
class RunColumn : public std::streambuf {
 public:
  RunColumn(std::ostream& out, std::string run, bool first)
      : out_(out), run_(std::move(run)), skip_(!first) {}

 protected:
  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char character = traits_type::to_char_type(c);
    if (!skip_) {
      if (lineStart_) out_ << (header_ ? std::string("run") : run_) << ',';
      out_.put(character);
    }
    lineStart_ = character == '\n';
    if (lineStart_) header_ = skip_ = false;
    return c;
  }

 private:
  std::ostream& out_;
  std::string run_;
  bool skip_, header_ = true, lineStart_ = true;
};

/// The first run whose channels most runs have; at least one run. Among equals the one that tells
/// most over time: of a bench its series and not its curves, of a comparison a method and not the
/// reference.
const RunOutput& mostShared(const std::vector<RunOutput>& runs) {
  return *std::ranges::max_element(runs, {}, [&](const RunOutput& run) {
    const auto& channels = run.recording->channels();
    const auto sharers = std::ranges::count_if(
        runs, [&](const RunOutput& other) { return other.recording->channels() == channels; });
    const bool overTime = !channels.empty() && channels.front().name == "time";
    return std::pair(sharers, overTime ? channels.size() : 0);
  });
}

}  // namespace

void writeRunsCsv(std::ostream& out, const std::vector<RunOutput>& runs) {
  if (runs.size() == 1) return writeCsv(out, *runs.front().recording);
  const auto& wanted = mostShared(runs).recording->channels();
  const auto shares = [&](const RunOutput& run) { return run.recording->channels() == wanted; };
  if (std::ranges::count_if(runs, shares) == 1)
    return writeCsv(out, *std::ranges::find_if(runs, shares)->recording);
  bool first = true;
  for (const auto& run : runs) {
    if (!shares(run)) continue;
    RunColumn column(out, csvCell(run.name), first);
    std::ostream lines(&column);
    writeCsv(lines, *run.recording);
    first = false;
  }
}

}  // namespace rotorbench
