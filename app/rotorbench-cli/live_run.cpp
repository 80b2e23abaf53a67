#include "app/rotorbench-cli/live_run.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <iostream>
#include <sstream>

#include "sim/core/number_text.h"

namespace rotorbench::cli {

const char* const kLiveHelp =
    "Lines on standard input, obeyed between two ticks:\n"
    "  PATH=VALUE             change a gain, a set-point or the wind now\n"
    "  at SECONDS PATH=VALUE  the same at a simulated time\n"
    "  pause, resume, step SECONDS, pace FACTOR (0: as fast as possible), stop\n"
    "control.byHand takes set-points from the timeline. What waits on the input at the start is "
    "obeyed before the first tick. --output keeps an experiment that repeats the run.";

namespace {

constexpr const char* kAllowed =
    "PATH=VALUE, at SECONDS PATH=VALUE, pause, resume, step SECONDS, pace FACTOR or stop";
constexpr int kWaitMs = 20;
constexpr double kShortestStep = 1e-6;  // s: that of the shortest tick

/// Lines of standard input as they come.
class InputLines {
 public:
  [[nodiscard]] bool open() const { return open_; }
  /// Waits at most so long for more and takes all that is there; returns whole lines, at the end of
  /// the input the rest.
  std::vector<std::string> read(int milliseconds) {
    // Of a line without an end, or of a writer that never stops, at a time.
    constexpr std::size_t kAtOnce = 1 << 20;
    std::vector<std::string> lines;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (open_ && text_.size() < kAtOnce && poll(&input, 1, milliseconds) > 0) {
      std::array<char, 4096> bytes;
      const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
      if (count > 0) text_.append(bytes.data(), static_cast<std::size_t>(count));
      open_ = count > 0;
      milliseconds = 0;
    }
    if ((!open_ || text_.size() >= kAtOnce) && !text_.empty()) text_ += '\n';
    for (std::size_t end = text_.find('\n'); end != std::string::npos; end = text_.find('\n')) {
      lines.push_back(text_.substr(0, end));
      text_.erase(0, end + 1);
    }
    return lines;
  }

 private:
  std::string text_;
  bool open_ = true;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

void LiveCommands::refuse(const std::string& what, const std::string& allowed) {
  ++wrong_;
  errors_ << "stdin:" << line_ << ": " << what << "; " << allowed << std::endl;
}

bool LiveCommands::number(const std::string& text, double least, bool zero, double& value) {
  const auto read = readNumber(trimmed(text));
  if (!read || !((*read >= least && *read <= kMost) || (zero && *read == 0))) {
    refuse(inQuotes(trimmed(text)) + " is not allowed",
           std::string("must be ") + (zero ? "0, or " : "") + "a number from " + numberText(least) +
               " to " + numberText(kMost));
    return false;
  }
  value = *read;
  return true;
}

void LiveCommands::obey(const std::string& line) {
  ++line_;
  std::string rest = trimmed(line);
  if (rest.empty() || rest.front() == '#') return;
  std::istringstream words(rest);
  std::string word, more;
  words >> word;
  std::getline(words, more);
  double value = 0;
  if (word == "pause" || word == "resume") {
    paused_ = word == "pause";
    paused_ ? worker_.pause() : worker_.resume();
  } else if (word == "stop") {
    worker_.stop();
  } else if (word == "step") {
    paused_ = true;
    if (number(more, kShortestStep, false, value)) worker_.step(value);
  } else if (word == "pace") {
    if (number(more, kLeastPace, true, value)) worker_.setPace({value});
  } else {
    Change change;
    if (word == "at") {
      std::istringstream timed(more);
      timed >> word;
      if (!number(word, 0, false, change.time)) return;
      std::getline(timed, more);
      rest = trimmed(more);
    }
    const auto equals = rest.find('=');
    if (equals == std::string::npos || equals == 0)
      return refuse(inQuotes(rest) + " is not a command", kAllowed);
    change.parameter = trimmed(rest.substr(0, equals));
    change.value = trimmed(rest.substr(equals + 1));
    worker_.change(change);
  }
}

LiveRun runLive(std::unique_ptr<Simulation> simulation, Pace pace,
                const std::function<bool()>& interrupted,
                const std::function<void(const Progress&)>& show) {
  const auto built = std::make_shared<std::unique_ptr<Simulation>>(std::move(simulation));
  RunWorker worker([built] { return std::move(*built); }, pace, true);
  LiveCommands commands(worker, std::cerr);
  InputLines input;
  std::size_t said = 0;
  RunStatus status = worker.status();
  const auto sayRefused = [&] {
    for (; said < status.refused.size(); ++said)
      std::cerr << "not changed: " << status.refused[said].message() << std::endl;
  };
  const auto obeyAll = [&](int milliseconds) {
    for (const std::string& line : input.read(milliseconds)) commands.obey(line);
  };
  obeyAll(0);
  if (!commands.paused()) worker.resume();
  while (isActive(status.state)) {
    const bool wasOpen = input.open();
    if (wasOpen) {
      obeyAll(kWaitMs);
    } else {
      poll(nullptr, 0, kWaitMs);
    }
    // Nobody is left to go on with it.
    if (wasOpen && !input.open()) worker.resume();
    if (interrupted()) worker.stop();
    status = worker.status();
    show(status.progress);
    sayRefused();
  }
  worker.wait();
  status = worker.status();
  sayRefused();
  return {status, commands.wrong() + static_cast<int>(status.refused.size())};
}

}  // namespace rotorbench::cli
