// The hybrid simulation of a flight. The order of a tick at time t: the plant's derivative and
// forces, the tasks on them, the command to the plant, a row of the recording, the plant exactly to
// t + h. The derivative is the first stage of the step.
#pragma once

#include <memory>
#include <vector>

#include "sim/control/controller.h"
#include "sim/run/drive_watch.h"
#include "sim/run/flight_watch.h"
#include "sim/run/live_changes.h"
#include "sim/run/plant_handle.h"
#include "sim/run/scheduler.h"
#include "sim/run/simulation.h"
#include "sim/run/simulation_base.h"

namespace rotorbench {

class Timeline;

/// What flies, and with which tasks.
struct FlightParts {
  std::unique_ptr<PlantHandle> plant;
  std::vector<std::unique_ptr<Task>> tasks;
  std::vector<HeldQuantity> held;      ///< by the controller among the tasks, if there is one
  const Timeline* timeline = nullptr;  ///< among the tasks, or none: figures are made of its steps
  std::vector<LivePart> live;          ///< of plant and tasks
};

class FlightSimulation final : public SimulationBase {
 public:
  FlightSimulation(const Flight& flight, const OutputSettings& outputs, FlightParts parts);

  SimulationState advance(std::int64_t ticks) override;
  [[nodiscard]] Progress progress() const override;
  [[nodiscard]] MetricTable metrics() const override;
  [[nodiscard]] std::vector<Verdict> verdicts() const override;
  [[nodiscard]] std::vector<RunEvent> events() const override;
  std::optional<Problem> change(const Change& change) override;
  [[nodiscard]] const std::vector<Change>& changes() const override { return changes_.all(); }

 private:
  void tick();
  /// The row of an event between two ticks: tasks keep what they last said.
  void endAtEvent();
  /// Everything of a tick but the integration. False if the run has ended.
  bool prepare(const ClockTick& tick);
  /// Keeps the row of this tick; false if there is no room.
  bool keep(const ClockTick& tick);
  /// What may end the flight at this tick: an empty battery, energy out of nothing, numbers of no
  /// vehicle.
  [[nodiscard]] std::optional<RunFailure> endedBy(const ClockTick& tick, double bus);

  double duration_;
  std::unique_ptr<PlantHandle> plant_;
  Scheduler scheduler_;
  std::vector<HeldQuantity> held_;
  const Timeline* timeline_;
  LiveChanges changes_;
  Board board_;
  FlightWatch watch_;  ///< of board_
  DriveWatch drives_;  ///< likewise
  EnergyWatch energy_;
  std::int64_t every_, everyEnergy_, ticks_, done_ = 0;
  bool endedAtEvent_ = false;
  std::vector<RunEvent> instants_;  ///< what happened once
  std::vector<double> row_;         ///< time, the plant's, the tasks'
  std::size_t firstOfTasks_ = 0;
  /// Where a task says that the rotors cannot give what it asks for; null: none does.
  const double* limited_ = nullptr;
  Recording* recording_ = nullptr;
};

}  // namespace rotorbench
