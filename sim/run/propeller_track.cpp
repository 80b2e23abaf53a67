#include "sim/run/propeller_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/analysis/curve_figures.h"
#include "sim/core/constants.h"
#include "sim/propulsion/rotor/advance_sweep.h"

namespace rotorbench {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

PropellerTrack::PropellerTrack(const BenchPropeller& propeller, const PropellerBench& bench,
                               std::string name, const AddRun& addRun)
    : propeller_(aerodynamicsOf(propeller)),
      air_{bench.airDensity, bench.airViscosity},
      at_(bench.curves),
      name_(std::move(name)),
      diameter_(2 * propeller_.radius()),
      blades_(propeller_.bladeElements() != nullptr),
      measured_(propeller_.limits(0).has_value()) {
  run_ = &addRun(titled("Run"), runChannels());
  static_ = known(at_.speed, 0);
  chosen_ = known(at_.speed, at_.airSpeed);
  if (const BladeElementRotor* blades = propeller_.bladeElements()) {
    alongBlade_.resize(static_cast<std::size_t>(blades->elements()));
    chosen_ = blades->axial(at_.speed, at_.airSpeed, air_, nullptr, alongBlade_);
  }
  addCurves(addRun);
}

std::size_t PropellerTrack::runsOf(const BenchPropeller& propeller) {
  return std::holds_alternative<BladeElementSpecimen>(propeller) ? 5 : 4;
}

std::vector<AbsentChannels> PropellerTrack::absent() const {
  std::vector<AbsentChannels> absent;
  if (!blades_) {
    const char* reason = "Only a propeller by blade elements has them: choose that model.";
    for (const char* beginning :
         {"along_blade.", "vortex_ring_share", "over_advance.vortex_ring_share"})
      absent.push_back({beginning, reason});
  }
  if (!measured_)
    absent.push_back({"beyond_measured", "Only a measured propeller has limits to go beyond."});
  return absent;
}

std::string PropellerTrack::titled(const std::string& title) const {
  return name_.empty() ? title : title + ", " + name_;
}

std::vector<Channel> PropellerTrack::runChannels() const {
  std::vector<Channel> channels{{"time", "s", "Time"},
                                {"speed", "rad/s", "Angular speed"},
                                {"air_speed", "m/s", "Air speed along the axis, positive in climb"},
                                {"thrust", "N", "Thrust along the axis"},
                                {"torque", "N*m", "Torque of the air, against the rotation"},
                                {"power", "W", "Power on the shaft"}};
  if (blades_)
    channels.push_back({"vortex_ring_share", "1", "Part of the disc in the vortex ring state"});
  if (measured_)
    channels.push_back({"beyond_measured", "1",
                        "1 where speed or advance ratio lie outside what was measured and the "
                        "coefficients are continued, else 0"});
  return channels;
}

void PropellerTrack::addCurve(const AddRun& addRun, const char* title,
                              std::vector<Channel> channels, int points,
                              void (PropellerTrack::*add)(Recording&, double)) {
  curves_.push_back({&addRun(titled(title), std::move(channels)), points, add});
}

void PropellerTrack::addCurves(const AddRun& addRun) {
  using Track = PropellerTrack;
  addCurve(addRun, "Over speed",
           {{"over_speed.speed", "rad/s", "Angular speed"},
            {"over_speed.thrust", "N", "Thrust"},
            {"over_speed.torque", "N*m", "Torque"},
            {"over_speed.power", "W", "Power on the shaft"},
            {"over_speed.ct", "1", "Thrust coefficient, T/(rho n^2 D^4)"},
            {"over_speed.cp", "1", "Power coefficient, P/(rho n^3 D^5)"}},
           at_.points, &Track::overSpeed);
  std::vector<Channel> advance{
      {"over_advance.j", "1", "Advance ratio J = V/(n D)"},
      {"over_advance.air_speed", "m/s", "Air speed along the axis"},
      {"over_advance.thrust", "N", "Thrust"},
      {"over_advance.torque", "N*m", "Torque"},
      {"over_advance.power", "W", "Power on the shaft"},
      {"over_advance.ct", "1", "Thrust coefficient, T/(rho n^2 D^4)"},
      {"over_advance.cp", "1", "Power coefficient, P/(rho n^3 D^5)"},
      {"over_advance.efficiency", "1", "Thrust times air speed over power, where both are given"}};
  if (blades_)
    advance.push_back(
        {"over_advance.vortex_ring_share", "1", "Part of the disc in the vortex ring state"});
  addCurve(addRun, "Over advance ratio", std::move(advance), at_.points, &Track::overAdvance);
  advance_ = curves_.back().recording;
  if (blades_) {
    addCurve(addRun, "Along the blade",
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
             static_cast<int>(alongBlade_.size()), &Track::alongBlade);
  }
  std::vector<Channel> edgewise{
      {"edgewise.ratio", "1", "Air speed in the plane of rotation over the tips' speed"},
      {"edgewise.air_speed", "m/s", "Air speed in the plane of rotation"},
      {"edgewise.thrust", "N", "Thrust along the axis"},
      {"edgewise.torque", "N*m", "Torque against the rotation"},
      {"edgewise.power", "W", "Power on the shaft"},
      {"edgewise.drag", "N", "In-plane force against the motion of the hub (H-force)"},
      {"edgewise.roll", "N*m", "Hub moment, thrust across the motion of the hub"},
      {"edgewise.side", "N", "In-plane force across the motion of the hub, the retreating side +"},
      {"edgewise.pitch", "N*m", "Hub moment, below 0 where thrust is ahead of the hub"}};
  addCurve(addRun, "Edgewise", std::move(edgewise), at_.points, &Track::edgewise);
}

bool PropellerTrack::record(double t, double w, double v) {
  const AxialLoad load = propeller_.axial(w, v, air_, &memory_);
  row_.assign({t, w, v, load.thrust, load.torque, load.torque * w});
  if (blades_) row_.push_back(load.vortexRingShare);
  if (measured_) row_.push_back(propeller_.knows(w, v) ? 0 : 1);
  return run_->append(row_);
}

void PropellerTrack::fillCurves(double share) {
  for (Curve& curve : curves_) {
    const int due = std::min(curve.points, static_cast<int>(std::ceil(share * curve.points)));
    for (; curve.done < due; ++curve.done)
      (this->*curve.add)(*curve.recording, static_cast<double>(curve.done) / (curve.points - 1));
  }
}

/// Nothing where the advance ratio was not measured.
AxialLoad PropellerTrack::known(double w, double v) const {
  if (!propeller_.knowsAdvance(w, v)) return {kNone, kNone, kNone};
  return propeller_.axial(w, v, air_);
}

void PropellerTrack::overSpeed(Recording& r, double place) {
  double from = 0, to = at_.topSpeed;
  if (const auto measured = propeller_.limits(0)) {
    from = measured->leastSpeed;
    to = std::min(to, measured->mostSpeed);
  }
  const double w = std::lerp(from, to, place);
  const AxialLoad load = known(w, at_.airSpeed);
  const AdvancePoint c = coefficientsOf(load, w, at_.airSpeed, diameter_, air_.density);
  r.append(std::array{w, load.thrust, load.torque, load.torque * w, c.thrustCoefficient,
                      c.powerCoefficient});
}

void PropellerTrack::overAdvance(Recording& r, double place) {
  double from = at_.leastAdvanceRatio, to = at_.mostAdvanceRatio;
  if (const auto measured = propeller_.limits(at_.speed)) {
    from = std::max(from, measured->leastAdvance);
    to = std::min(to, measured->mostAdvance);
  }
  const double j = std::lerp(from, to, place);
  const double v = j * diameter_ * at_.speed / (2 * kPi);
  const AxialLoad load = propeller_.axial(at_.speed, v, air_);
  const AdvancePoint c = coefficientsOf(load, at_.speed, v, diameter_, air_.density);
  row_.assign({j, v, load.thrust, load.torque, load.torque * at_.speed, c.thrustCoefficient,
               c.powerCoefficient, c.efficiency});
  if (blades_) row_.push_back(load.vortexRingShare);
  r.append(row_);
}

void PropellerTrack::alongBlade(Recording& r, double place) {
  const auto last = static_cast<double>(alongBlade_.size() - 1);
  const ElementLoad& e = alongBlade_[static_cast<std::size_t>(std::lround(place * last))];
  r.append(std::array{e.radius, e.angleOfAttack, e.inflowAngle, e.angleOfAttack + e.inflowAngle,
                      e.inducedVelocity, e.swirl, e.lift, e.drag, e.reynolds, e.thrustPerRadius,
                      e.torquePerRadius});
}

void PropellerTrack::edgewise(Recording& r, double place) {
  const double ratio = at_.mostEdgewiseRatio * place;
  const double v = ratio * at_.speed * propeller_.radius();
  const EdgewiseLoad load = propeller_.oblique(at_.speed, at_.airSpeed, v, air_);
  row_.assign({ratio, v, load.thrust, load.torque, load.torque * at_.speed, load.drag,
               load.rollMoment, load.side, load.pitchMoment});
  r.append(row_);
}

void PropellerTrack::addLimits(std::vector<Metric>& metrics) const {
  if (blades_) {
    metrics.push_back({"vortex_ring_share", "1",
                       "Largest part of the disc in the vortex ring state over the advance ratio",
                       largestValue(*advance_, "over_advance.vortex_ring_share")});
  }
  const auto measured = propeller_.limits(at_.speed);
  if (!measured) return;
  const std::size_t column = *run_->find("beyond_measured"), rows = run_->rows();
  double beyond = 0;
  for (std::size_t row = 0; row < rows; ++row) beyond += run_->value(column, row);
  metrics.insert(
      metrics.end(),
      {{"beyond_measured_share", "1",
        "Part of the run's rows outside what was measured, where the coefficients are "
        "continued",
        rows > 0 ? beyond / static_cast<double>(rows) : kNone},
       {"least_measured_speed", "rad/s", "Slowest measured speed, less 2 %", measured->leastSpeed},
       {"most_measured_speed", "rad/s", "Fastest measured speed, more 2 %",
        std::isfinite(measured->mostSpeed) ? measured->mostSpeed : kNone},
       {"least_measured_advance_ratio", "1",
        "Lowest measured advance ratio at the speed of the curves", measured->leastAdvance},
       {"most_measured_advance_ratio", "1",
        "Highest measured advance ratio at the speed of the curves", measured->mostAdvance}});
}

MetricRow PropellerTrack::metrics() const {
  const std::size_t j = *advance_->find("over_advance.j");
  const CurvePeak peak = peakOf(*advance_, j, *advance_->find("over_advance.efficiency"));
  const AdvancePoint still = coefficientsOf(static_, at_.speed, 0, diameter_, air_.density);
  const double area = kPi * propeller_.radius() * propeller_.radius();
  const double power = static_.torque * at_.speed;
  const double ideal = static_.thrust * std::sqrt(static_.thrust / (2 * air_.density * area));
  MetricRow row{
      titled("Run"),
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
        fallsThroughZero(*advance_, j, *advance_->find("over_advance.ct"))},
       {"chosen_thrust", "N", "Thrust at the speed and air speed of the curves", chosen_.thrust},
       {"chosen_torque", "N*m", "Torque at the speed and air speed of the curves", chosen_.torque},
       {"peak_thrust", "N", "Largest thrust of the run", largestValue(*run_, "thrust")},
       {"peak_torque", "N*m", "Largest torque of the run", largestValue(*run_, "torque")},
       {"peak_power", "W", "Largest power of the run", largestValue(*run_, "power")}}};
  addLimits(row.metrics);
  return row;
}

}  // namespace rotorbench
