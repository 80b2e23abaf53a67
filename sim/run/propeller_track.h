// One propeller's part in a propeller bench: its recordings, the run in time and the curves, and
// its figures. Where a measured propeller has nothing to say a curve ends; the run in time goes on
// and marks such rows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/core/metrics.h"
#include "sim/core/recording.h"
#include "sim/document/propeller_bench.h"
#include "sim/run/benched_propeller.h"
#include "sim/run/simulation.h"

namespace rotorbench {

class PropellerTrack {
 public:
  /// Gives the recording of a run with this name.
  using AddRun = std::function<Recording&(std::string name, std::vector<Channel> channels)>;

  /// `bench` must satisfy its schema; `name` tells the runs of two propellers apart and may be
  /// empty.
  PropellerTrack(const BenchPropeller& propeller, const PropellerBench& bench, std::string name,
                 const AddRun& addRun);

  /// Runs a propeller has, those in addRun's order: in time, then the curves.
  static std::size_t runsOf(const BenchPropeller& propeller);
  /// Channels of the bench that this propeller's runs do not have.
  [[nodiscard]] std::vector<AbsentChannels> absent() const;

  /// A row of the run in time at speed w, rad/s, and air speed v, m/s; false if the recording is
  /// full.
  bool record(double t, double w, double v);
  void publish() { run_->publish(); }
  /// Fills every curve up to this share of its points, 0 to 1.
  void fillCurves(double share);

  [[nodiscard]] MetricRow metrics() const;

 private:
  /// Filled in step with the run in time so that no slice of work is long.
  struct Curve {
    Recording* recording;
    int points;
    void (PropellerTrack::*add)(Recording&, double place);
    int done = 0;
  };

  [[nodiscard]] std::vector<Channel> runChannels() const;
  void addCurves(const AddRun& addRun);
  void addCurve(const AddRun& addRun, const char* title, std::vector<Channel> channels, int points,
                void (PropellerTrack::*add)(Recording&, double));
  [[nodiscard]] std::string titled(const std::string& title) const;
  [[nodiscard]] AxialLoad known(double w, double v) const;
  void overSpeed(Recording& r, double place);
  void overAdvance(Recording& r, double place);
  void alongBlade(Recording& r, double place);
  void edgewise(Recording& r, double place);
  void addLimits(std::vector<Metric>& metrics) const;

  BenchedPropeller propeller_;
  AirState air_;
  PropellerCurves at_;
  std::string name_;
  double diameter_;
  bool blades_, measured_;
  InflowMemory memory_;
  AxialLoad static_, chosen_;
  std::vector<ElementLoad> alongBlade_;
  std::vector<Curve> curves_;
  Recording* run_ = nullptr;
  Recording* advance_ = nullptr;
  std::vector<double> row_;
};

}  // namespace rotorbench
