// An experiment with a drive on a stand: one run in time, or several side by side that differ in
// one respect. Kinds derive from it to add their curves.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/run/drive_run.h"
#include "sim/run/simulation.h"
#include "sim/run/simulation_base.h"

namespace rotorbench {

template <DriveCommander Commander>
class DriveSimulation : public SimulationBase {
 public:
  struct Part {
    std::string name;
    DriveTrain train;
    Commander commander;
  };

  /// At least one part; `recordings` of them and of the kind's curves divide the memory limit.
  DriveSimulation(const DriveRunSettings& run, double deadTime, const OutputSettings& outputs,
                  std::vector<Part> parts, std::size_t recordings)
      : SimulationBase(run.tick) {
    for (Part& part : parts) {
      drives_.push_back({std::make_unique<DriveRun<Commander>>(std::move(part.train), deadTime, run,
                                                               std::move(part.commander),
                                                               ticksPerRow(outputs, run.tick))});
      DriveRun<Commander>& drive = *drives_.back().run;
      drive.start(addRun(std::move(part.name), drive.channels(), outputs, recordings));
    }
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    for (const RunOutput& run : runs()) run.recording->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override {
    const auto least = std::ranges::min_element(
        drives_, {}, [](const Drive& d) { return d.ended ? 2.0 : d.run->fraction(); });
    return {least->run->fraction(), least->run->time(), "running"};
  }

  [[nodiscard]] MetricTable metrics() const override {
    MetricTable table;
    for (std::size_t i = 0; i < drives_.size(); ++i)
      table.push_back({runs()[i].name, drives_[i].run->figures()});
    return table;
  }

 protected:
  [[nodiscard]] const DriveTrain& train() const { return drives_.front().run->train(); }
  [[nodiscard]] Commander& commander() { return drives_.front().run->commander(); }

 private:
  struct Drive {
    std::unique_ptr<DriveRun<Commander>> run;
    bool ended = false;
  };

  void tick() {
    bool going = false;
    for (Drive& drive : drives_) {
      if (drive.ended) continue;
      switch (drive.run->tick()) {
        case DriveProgress::Failed:
          return fail(drive.run->failure());
        case DriveProgress::Full:
          return failFull(drive.run->time());
        case DriveProgress::Ended:
          drive.ended = true;
          break;
        case DriveProgress::Going:
          going = true;
      }
    }
    if (!going) end(SimulationState::Finished);
  }

  std::vector<Drive> drives_;
};

}  // namespace rotorbench
