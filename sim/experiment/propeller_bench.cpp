#include "sim/experiment/propeller_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/analysis/curve_figures.h"
#include "sim/experiment/simulation_base.h"
#include "sim/propulsion/advance_sweep.h"

namespace rotorbench {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

InputSignal signalOf(const PropellerBench& bench) {
  std::vector<InputSignal::Sample> samples;
  for (const PropellerSpeedRow& row : bench.speeds)
    samples.push_back({row.time, Eigen::Vector4d::Constant(row.speed)});
  return {std::move(samples), bench.interpolation};
}

InputSignal streamOf(const PropellerBench& bench) {
  if (const auto* steady = std::get_if<SteadyStream>(&bench.stream))
    return {{{0, Eigen::Vector4d::Constant(steady->speed)}}, Interpolation::Hold};
  const auto& profile = std::get<StreamProfile>(bench.stream);
  std::vector<InputSignal::Sample> samples;
  for (const AirSpeedRow& row : profile.rows)
    samples.push_back({row.time, Eigen::Vector4d::Constant(row.speed)});
  return {std::move(samples), profile.interpolation};
}

class PropellerBenchSimulation final : public SimulationBase {
 public:
  PropellerBenchSimulation(const PropellerBench& bench, const OutputSettings& outputs)
      : SimulationBase(bench.run.tick),
        rotor_(std::get<BladeElementSpecimen>(bench.propeller).geometry,
               std::get<BladeElementSpecimen>(bench.propeller).settings),
        air_{bench.airDensity, bench.airViscosity},
        at_(bench.curves),
        speed_(signalOf(bench)),
        stream_(streamOf(bench)),
        duration_(bench.run.duration),
        every_(ticksPerRow(outputs, bench.run.tick)),
        ticks_(std::max<std::int64_t>(1, std::llround(bench.run.duration / bench.run.tick))),
        diameter_(2 * rotor_.radius()) {
    run_ = &addRun("Run", runChannels(), outputs, kRuns);
    addCurves(outputs);
    static_ = rotor_.axial(at_.speed, 0, air_);
    alongBlade_.resize(static_cast<std::size_t>(rotor_.elements()));
    chosen_ = rotor_.axial(at_.speed, at_.airSpeed, air_, nullptr, alongBlade_);
    record(0);
    run_->publish();
  }

  SimulationState advance(std::int64_t ticks) override {
    for (; ticks > 0 && state() == SimulationState::Running; --ticks) tick();
    for (const RunOutput& run : runs()) run.recording->publish();
    return state();
  }

  [[nodiscard]] Progress progress() const override {
    return {static_cast<double>(done_) / static_cast<double>(ticks_), time(done_), "turning"};
  }

  [[nodiscard]] MetricTable metrics() const override;

 private:
  static constexpr std::size_t kRuns = 5;
  /// A curve with its next point, filled in step with the run in time so that no slice of work is long.
  struct Curve {
    Recording* recording;
    std::int64_t points;
    void (PropellerBenchSimulation::*add)(Recording&, double place);
    std::int64_t done = 0;
  };

  static std::vector<Channel> runChannels();
  void addCurves(const OutputSettings& outputs);
  void overSpeed(Recording& r, double place);
  void overAdvance(Recording& r, double place);
  void alongBlade(Recording& r, double place);
  void edgewise(Recording& r, double place);

  [[nodiscard]] double time(std::int64_t tick) const {
    return tick == ticks_ ? duration_ : static_cast<double>(tick) * tickSeconds();
  }
  void tick() {
    ++done_;
    for (Curve& curve : curves_) {
      const auto due = static_cast<std::int64_t>(
          std::ceil(static_cast<double>(curve.points) * static_cast<double>(done_) /
                    static_cast<double>(ticks_)));
      for (; curve.done < std::min(due, curve.points); ++curve.done) {
        (this->*curve.add)(*curve.recording,
                           static_cast<double>(curve.done) / static_cast<double>(curve.points - 1));
      }
    }
    const bool last = done_ == ticks_;
    if ((done_ % every_ == 0 || last) && !record(time(done_))) return failFull(time(done_));
    if (last) end(SimulationState::Finished);
  }
  bool record(double t) {
    const double w = speed_.at(t)[0], v = stream_.at(t)[0];
    const AxialLoad load = rotor_.axial(w, v, air_, &memory_);
    return run_->append(
        std::array{t, w, v, load.thrust, load.torque, load.torque * w, load.vortexRingShare});
  }

  BladeElementRotor rotor_;
  AirState air_;
  PropellerCurves at_;
  InputSignal speed_, stream_;
  double duration_;
  std::int64_t every_, ticks_, done_ = 0;
  double diameter_;
  InflowMemory memory_;
  AxialLoad static_, chosen_;
  std::vector<ElementLoad> alongBlade_;
  std::vector<Curve> curves_;
  Recording* run_ = nullptr;
};

std::vector<Channel> PropellerBenchSimulation::runChannels() {
  return {{"time", "s", "Time"},
          {"speed", "rad/s", "Angular speed"},
          {"air_speed", "m/s", "Air speed along the axis, positive in climb"},
          {"thrust", "N", "Thrust along the axis"},
          {"torque", "N*m", "Torque of the air, against the rotation"},
          {"power", "W", "Power on the shaft"},
          {"vortex_ring_share", "1", "Part of the disc in the vortex ring state"}};
}

void PropellerBenchSimulation::addCurves(const OutputSettings& outputs) {
  using Sim = PropellerBenchSimulation;
  const auto add = [&](const char* name, std::vector<Channel> channels, std::int64_t points,
                       void (Sim::*row)(Recording&, double)) {
    curves_.push_back({&addRun(name, std::move(channels), outputs, kRuns), points, row});
  };
  add("Over speed",
      {{"over_speed.speed", "rad/s", "Angular speed"},
       {"over_speed.thrust", "N", "Thrust"},
       {"over_speed.torque", "N*m", "Torque"},
       {"over_speed.power", "W", "Power on the shaft"},
       {"over_speed.ct", "1", "Thrust coefficient, T/(rho n^2 D^4)"},
       {"over_speed.cp", "1", "Power coefficient, P/(rho n^3 D^5)"}},
      at_.points, &Sim::overSpeed);
  add("Over advance ratio",
      {{"over_advance.j", "1", "Advance ratio J = V/(n D)"},
       {"over_advance.air_speed", "m/s", "Air speed along the axis"},
       {"over_advance.thrust", "N", "Thrust"},
       {"over_advance.torque", "N*m", "Torque"},
       {"over_advance.power", "W", "Power on the shaft"},
       {"over_advance.ct", "1", "Thrust coefficient, T/(rho n^2 D^4)"},
       {"over_advance.cp", "1", "Power coefficient, P/(rho n^3 D^5)"},
       {"over_advance.efficiency", "1", "Thrust times air speed over power, where both are given"},
       {"over_advance.vortex_ring_share", "1", "Part of the disc in the vortex ring state"}},
      at_.points, &Sim::overAdvance);
  add("Along the blade",
      {{"along_blade.radius", "1", "Radius r/R"},
       {"along_blade.alpha", "rad", "Angle of attack"},
       {"along_blade.phi", "rad", "Inflow angle, from the plane of rotation"},
       {"along_blade.twist", "rad", "Pitch of the section, from the plane of rotation"},
       {"along_blade.induced", "m/s", "Induced velocity"},
       {"along_blade.swirl", "m/s", "Swirl at the section"},
       {"along_blade.cl", "1", "Lift coefficient"},
       {"along_blade.cd", "1", "Drag coefficient"},
       {"along_blade.reynolds", "1", "Reynolds number of the chord"},
       {"along_blade.dt_dr", "N/m", "Thrust per radius, all blades"},
       {"along_blade.dq_dr", "N", "Torque per radius, all blades"}},
      rotor_.elements(), &Sim::alongBlade);
  add("Edgewise",
      {{"edgewise.ratio", "1", "Air speed in the plane of rotation over the tips' speed"},
       {"edgewise.air_speed", "m/s", "Air speed in the plane of rotation"},
       {"edgewise.thrust", "N", "Thrust along the axis"},
       {"edgewise.torque", "N*m", "Torque against the rotation"},
       {"edgewise.power", "W", "Power on the shaft"},
       {"edgewise.drag", "N", "In-plane force against the motion of the hub (H-force)"},
       {"edgewise.roll", "N*m", "Hub moment, thrust across the motion of the hub"}},
      at_.points, &Sim::edgewise);
}

void PropellerBenchSimulation::overSpeed(Recording& r, double place) {
  const double w = at_.topSpeed * place;
  const AxialLoad load = rotor_.axial(w, at_.airSpeed, air_);
  const AdvancePoint c = coefficientsOf(load, w, at_.airSpeed, diameter_, air_.density);
  r.append(std::array{w, load.thrust, load.torque, load.torque * w, c.thrustCoefficient,
                      c.powerCoefficient});
}

void PropellerBenchSimulation::overAdvance(Recording& r, double place) {
  const double j = at_.leastAdvanceRatio + (at_.mostAdvanceRatio - at_.leastAdvanceRatio) * place;
  const double v = j * diameter_ * at_.speed / (2 * kPi);
  const AxialLoad load = rotor_.axial(at_.speed, v, air_);
  const AdvancePoint c = coefficientsOf(load, at_.speed, v, diameter_, air_.density);
  const double power = load.torque * at_.speed;
  r.append(std::array{j, v, load.thrust, load.torque, power, c.thrustCoefficient,
                      c.powerCoefficient, c.efficiency, load.vortexRingShare});
}

void PropellerBenchSimulation::alongBlade(Recording& r, double place) {
  const auto last = static_cast<double>(alongBlade_.size() - 1);
  const ElementLoad& e = alongBlade_[static_cast<std::size_t>(std::lround(place * last))];
  r.append(std::array{e.radius, e.angleOfAttack, e.inflowAngle, e.angleOfAttack + e.inflowAngle,
                      e.inducedVelocity, e.swirl, e.lift, e.drag, e.reynolds, e.thrustPerRadius,
                      e.torquePerRadius});
}

void PropellerBenchSimulation::edgewise(Recording& r, double place) {
  const double ratio = at_.mostEdgewiseRatio * place;
  const double v = ratio * at_.speed * rotor_.radius();
  const ObliqueLoad load = rotor_.oblique(at_.speed, at_.airSpeed, v, air_);
  r.append(std::array{ratio, v, load.thrust, load.torque, load.torque * at_.speed, load.drag,
                      load.rollMoment});
}

MetricTable PropellerBenchSimulation::metrics() const {
  const Recording& advance = *runs()[2].recording;
  const std::size_t j = *advance.find("over_advance.j");
  const CurvePeak peak = peakOf(advance, j, *advance.find("over_advance.efficiency"));
  const AdvancePoint still = coefficientsOf(static_, at_.speed, 0, diameter_, air_.density);
  const double area = kPi * rotor_.radius() * rotor_.radius();
  const double power = static_.torque * at_.speed;
  const double ideal = static_.thrust * std::sqrt(static_.thrust / (2 * air_.density * area));
  return {
      {"Run",
       {{"static_ct", "1", "Thrust coefficient at rest in the air, at the speed of the curves",
         still.thrustCoefficient},
        {"static_cp", "1", "Power coefficient at rest in the air", still.powerCoefficient},
        {"static_thrust", "N", "Thrust at rest in the air", static_.thrust},
        {"static_torque", "N*m", "Torque at rest in the air", static_.torque},
        {"figure_of_merit", "1", "Ideal hover power of the thrust over the power at rest",
         static_.thrust > 0 && power > 0 ? ideal / power : kNone},
        {"peak_efficiency", "1", "Best efficiency over the advance ratio", peak.y},
        {"peak_efficiency_advance_ratio", "1", "Advance ratio of the best efficiency", peak.x},
        {"zero_thrust_advance_ratio", "1", "Advance ratio at which the thrust ends",
         fallsThroughZero(advance, j, *advance.find("over_advance.ct"))},
        {"vortex_ring_share", "1",
         "Largest part of the disc in the vortex ring state over the advance ratio",
         largestValue(advance, "over_advance.vortex_ring_share")},
        {"chosen_thrust", "N", "Thrust at the speed and air speed of the curves", chosen_.thrust},
        {"chosen_torque", "N*m", "Torque at the speed and air speed of the curves", chosen_.torque},
        {"peak_thrust", "N", "Largest thrust of the run", largestValue(*run_, "thrust")},
        {"peak_torque", "N*m", "Largest torque of the run", largestValue(*run_, "torque")},
        {"peak_power", "W", "Largest power of the run", largestValue(*run_, "power")}}}};
}

}  // namespace

std::unique_ptr<Simulation> buildPropellerBench(const PropellerBench& bench,
                                                const OutputSettings& outputs) {
  return std::make_unique<PropellerBenchSimulation>(bench, outputs);
}

}  // namespace rotorbench
