#include "sim/propulsion/rotor/lane_rotor.h"

#include "sim/numerics/cubic_table.h"

namespace rotorbench {

namespace {

constexpr float kTolerance = 1e-6F;  // of the section's speed
constexpr float kCellsPerAngle = SectionTable::kCells / 4.F;

/// The annuli of a block in one state; speeds over one reference speed.
struct Stream {
  FloatLanes axial, inPlane, turning, turned, hoverFactor, speed, rowWeight, freeSlope;
  std::array<const float*, kFloatLanes> lift, loads;  // rows of the table
  std::span<const float> azimuths;

  /// Place in the table of the flow at one azimuth.
  struct Cell {
    FloatMask index;
    FloatLanes fraction, square;

    [[nodiscard]] std::array<const float*, kFloatLanes> from(
        const std::array<const float*, kFloatLanes>& rows, int numbers) const {
      std::array<const float*, kFloatLanes> places;
      for (int l = 0; l < kFloatLanes; ++l)
        places[static_cast<std::size_t>(l)] =
            rows[static_cast<std::size_t>(l)] + static_cast<std::ptrdiff_t>(numbers) * index[l];
      return places;
    }
  };
  [[nodiscard]] Cell locate(FloatLanes induced, FloatLanes swirl, float azimuth) const {
    const FloatLanes a = axial + induced, t = turning - swirl - inPlane * azimuth;
    const FloatLanes d = a / (lane::size(a) + lane::size(t) + lane::kTiny);
    const FloatLanes back = (a < 0.F ? lane::all(-2) : lane::all(2)) - d;
    // What is no number must not lead out of the table.
    const FloatLanes place =
        lane::least(lane::most(((t < 0.F ? back : d) + 2.F) * kCellsPerAngle, lane::all(0)),
                    lane::all(SectionTable::kCells));
    const FloatMask index = __builtin_convertvector(place, FloatMask);
    return {index, place - __builtin_convertvector(index, FloatLanes), a * a + t * t};
  }
  [[nodiscard]] FloatLanes swirls(FloatLanes v) const {
    return turned * lane::swirl(v, axial, turning);
  }

  /// Square of the induced velocity the mean lift would have in hover.
  [[nodiscard]] FloatLanes hover(FloatLanes v) const {
    const FloatLanes swirl = swirls(v);
    FloatLanes sum{};
    for (const float azimuth : azimuths) {
      const Cell cell = locate(v, swirl, azimuth);
      FloatLanes at[4];
      lane::gather(cell.from(lift, 2), at);
      const FloatLanes low = at[0] + cell.fraction * (at[2] - at[0]);
      const FloatLanes high = at[1] + cell.fraction * (at[3] - at[1]);
      sum += cell.square * (low + rowWeight * (high - low));
    }
    return sum * hoverFactor;
  }
  [[nodiscard]] FloatLanes residual(FloatLanes v) const {
    return v - lane::momentum(hover(v), axial, inPlane);
  }
};

/// bracketedRoot() in all lanes; one whose ends are alike stays there.
FloatLanes bracketed(const Stream& stream, FloatLanes a, FloatLanes fa, FloatLanes b,
                     FloatLanes fb) {
  const FloatLanes half = lane::all(0.5F), tolerance = kTolerance * stream.speed;
  FloatLanes t = half;
  constexpr int kMost = 40;
  for (int i = 0; i < kMost; ++i) {
    const FloatLanes x = a + t * (b - a), fx = stream.residual(x);
    const FloatMask same = (fx > 0.F) == (fa > 0.F);
    const FloatLanes c = same ? a : b, fc = same ? fa : fb;
    b = same ? b : a, fb = same ? fb : fa;
    a = x, fa = fx;
    const FloatLanes width = lane::size(b - a);
    if (!lane::any((lane::size(fa) > tolerance) & (width > 2.F * tolerance))) break;
    const FloatLanes least = lane::least(tolerance / (width + lane::kTiny), half);
    const FloatLanes xi = (a - b) / (c - b), ratio = (fa - fb) / (fc - fb);
    const FloatLanes quadratic =
        fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    const FloatMask safe = (ratio * ratio < xi) & ((1.F - ratio) * (1.F - ratio) < 1.F - xi);
    t = lane::least(lane::most(safe ? quadratic : half, least), 1.F - least);
  }
  return lane::size(fa) < lane::size(fb) ? a : b;
}

using Samples = std::array<FloatLanes, ResidualSamples::kBefore + ResidualSamples::kSteps + 1>;

FloatLanes placeOf(FloatLanes end, int i) {
  return end * (static_cast<float>(i - ResidualSamples::kBefore) / ResidualSamples::kSteps);
}

/// alternatingRoots() in all lanes.
FloatLanes alternating(const Stream& stream, FloatLanes end, const Samples& samples) {
  FloatLanes sum{}, sign = lane::all(1);
  std::array<std::size_t, kFloatLanes> next;
  next.fill(ResidualSamples::kBefore);
  for (;;) {
    FloatLanes a{}, fa{}, b{}, fb{};
    FloatMask found{};
    for (int l = 0; l < kFloatLanes; ++l) {
      for (std::size_t& i = next[static_cast<std::size_t>(l)]; i + 1 < samples.size();) {
        const float from = samples[i][l], to = samples[i + 1][l];
        const int k = static_cast<int>(i++);
        if ((to > 0) == (from > 0)) continue;
        a[l] = placeOf(end, k)[l], fa[l] = from, b[l] = placeOf(end, k + 1)[l], fb[l] = to;
        found[l] = -1;
        break;
      }
    }
    if (!lane::any(found)) return sum;
    const FloatLanes root = bracketed(stream, a, fa, b, fb);
    sum += found ? sign * root : FloatLanes{};
    sign = found ? -sign : sign;
  }
}

/// softRoot() in all lanes.
FloatLanes soft(FloatLanes end, const Samples& samples) {
  constexpr float kEdge = 0.08F, kLevel = 0.01F;
  constexpr float kStep = 1 / (kEdge * ResidualSamples::kSteps);
  // R over the edge, and lengths over it.
  const FloatLanes edge = kEdge * end, scale = 1.F / edge;
  FloatLanes r = samples[0] * scale, area = lane::softplus(-r);
  FloatLanes sum = -kStep * ResidualSamples::kBefore - (r + area);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const FloatLanes next = samples[i] * scale, nextArea = lane::softplus(-next), rise = next - r;
    const FloatMask steep = lane::size(rise) > kLevel;
    const FloatLanes quotient = (area - nextArea) / (steep ? rise : lane::all(1));
    sum += kStep * (steep ? quotient : lane::logistic(-0.5F * (next + r)));
    r = next, area = nextArea;
  }
  return (sum + area) * edge;
}

/// inflowRoot() in all lanes.
FloatLanes inflow(const Stream& stream, const RootRule& rule) {
  constexpr float kLeastBracket = 0.02F, kGrowth = 1.4F;
  const FloatLanes atZero = stream.residual(FloatLanes{}), least = kLeastBracket * stream.speed;
  const FloatLanes reach = stream.turning * stream.freeSlope - stream.axial;
  const FloatLanes towards = atZero < 0.F ? reach : -reach;
  const FloatLanes size = lane::most(rule.many ? lane::size(reach) : towards, least);
  FloatLanes end = atZero < 0.F ? size : -size, atEnd = stream.residual(end);
  FloatLanes shorter = end, atShorter = atEnd;
  for (int i = 0; i < 60; ++i) {
    const FloatMask more = ((atEnd > 0.F) == (atZero > 0.F)) & (atEnd != 0.F) & (atZero != 0.F);
    if (!lane::any(more)) break;
    shorter = more ? end : shorter, atShorter = more ? atEnd : atShorter;
    end = more ? kGrowth * end : end;
    atEnd = stream.residual(end);
  }
  FloatLanes v;
  if (!rule.many) {
    v = bracketed(stream, FloatLanes{}, atZero, end, atEnd);
  } else {
    const FloatMask grown = shorter != end;
    if (lane::any(grown)) {
      end = grown ? bracketed(stream, shorter, atShorter, end, atEnd) : end;
      const FloatLanes beyond = atZero > 0.F ? lane::all(-lane::kTiny) : lane::all(lane::kTiny);
      atEnd = grown ? beyond : atEnd;
    }
    Samples samples;
    constexpr int kBefore = ResidualSamples::kBefore;
    constexpr int kLast = kBefore + ResidualSamples::kSteps;
    const int first = rule.softness > 0 ? 0 : kBefore;
    // Apart, so that the processor may work on several samples at once.
    for (int i = first; i < kLast; ++i)
      samples[static_cast<std::size_t>(i)] = stream.hover(placeOf(end, i));
    for (int i = first; i < kLast; ++i) {
      FloatLanes& r = samples[static_cast<std::size_t>(i)];
      r = placeOf(end, i) - lane::momentum(r, stream.axial, stream.inPlane);
    }
    samples[kBefore] = atZero;
    samples.back() = atEnd;
    const auto share = static_cast<float>(rule.softness);
    const FloatLanes blurred = share > 0 ? soft(end, samples) : FloatLanes{};
    const FloatLanes sharp = share < 1 ? alternating(stream, end, samples) : FloatLanes{};
    v = sharp + share * (blurred - sharp);
  }
  return atZero == 0.F ? FloatLanes{} : v;
}

/// Thrust, torque over the radius, and their parts at the sine of the azimuth.
struct LaneLoads {
  FloatLanes thrust{}, against{}, drag{}, roll{};
};

LaneLoads loadsAt(const Stream& stream, FloatLanes v) {
  const FloatLanes swirl = stream.swirls(v);
  LaneLoads sum;
  for (const float azimuth : stream.azimuths) {
    const Stream::Cell cell = stream.locate(v, swirl, azimuth);
    FloatLanes weight[4];
    catmullRom(cell.fraction, weight);
    FloatLanes thrust{}, against{};
    auto places = cell.from(stream.loads, 4);
    for (const float*& place : places) place -= 4;
    for (int k = 0; k < 4; ++k) {
      FloatLanes at[4];
      lane::gather(places, at);
      for (const float*& place : places) place += 4;
      thrust += weight[k] * (at[0] + stream.rowWeight * (at[2] - at[0]));
      against += weight[k] * (at[1] + stream.rowWeight * (at[3] - at[1]));
    }
    thrust *= cell.square, against *= cell.square;
    sum.thrust += thrust;
    sum.against += against;
    sum.drag -= against * azimuth;
    sum.roll += thrust * azimuth;
  }
  return sum;
}

}  // namespace

LaneRotor::LaneRotor(const BladeElementRotor& rotor, double leastReynolds, double mostReynolds)
    : table_(rotor, leastReynolds, mostReynolds), radius_(rotor.radius()) {
  for (const double azimuth : rotor.azimuthSines())
    azimuths_.push_back(static_cast<float>(azimuth));
  const auto& annuli = rotor.annuli();
  const double share = 1 / static_cast<double>(azimuths_.size());
  for (std::size_t first = 0; first < annuli.size(); first += kFloatLanes) {
    Block block{};
    for (std::size_t l = 0; l < kFloatLanes; ++l) {
      // FloatLanes beyond the last annulus repeat it without a chord.
      const bool real = first + l < annuli.size();
      const std::size_t i = std::min(first + l, annuli.size() - 1);
      const auto& e = annuli[i];
      const int k = static_cast<int>(l);
      block.annulus[l] = i;
      block.chord[l] = e.chord / radius_;
      block.radius[k] = static_cast<float>(e.radius / radius_);
      block.hoverFactor[k] =
          real ? static_cast<float>(e.solidity / (4 * rotor.momentumFactor()) * share) : 0;
      block.area[k] =
          real
              ? static_cast<float>(rotor.blades() * e.chord * e.width / (radius_ * radius_) * share)
              : 0;
    }
    blocks_.push_back(block);
  }
}

ObliqueLoad LaneRotor::oblique(double omega, double axialSpeed, double inPlaneSpeed,
                               const AirState& air) const {
  const double tip = omega * radius_;
  const double speed = std::sqrt(tip * tip + axialSpeed * axialSpeed + inPlaneSpeed * inPlaneSpeed);
  const RootRule rule = RootRule::at(advanceRatio(axialSpeed, std::hypot(tip, inPlaneSpeed)),
                                     inPlaneSpeed / std::max(tip, 1e-9 * speed));
  const double logReynolds = std::log(air.density * speed * radius_ / air.viscosity);
  Stream stream{};
  stream.azimuths = azimuths_;
  stream.axial = lane::all(static_cast<float>(axialSpeed / speed));
  stream.inPlane = lane::all(static_cast<float>(inPlaneSpeed / speed));
  const auto tipShare = static_cast<float>(tip / speed);
  const FloatLanes inPlaneMean = stream.inPlane * stream.inPlane / 2.F;
  ObliqueLoad load;
  for (const Block& block : blocks_) {
    stream.hoverFactor = block.hoverFactor;
    stream.turning = tipShare * block.radius;
    const FloatLanes square = stream.turning * stream.turning;
    stream.turned = square / (square + inPlaneMean);
    stream.speed = lane::root(square + stream.axial * stream.axial + inPlaneMean);
    for (int l = 0; l < kFloatLanes; ++l) {
      const auto k = static_cast<std::size_t>(l);
      const SectionTable::Place place = table_.at(
          block.annulus[k], logReynolds + std::log(double{stream.speed[l]} * block.chord[k]));
      stream.lift[k] = table_.lift(place.row);
      stream.loads[k] = table_.loads(place.row);
      stream.rowWeight[l] = place.weight;
      const float slope = table_.freeSlope(place.row);
      stream.freeSlope[l] = slope + place.weight * (table_.freeSlope(place.row + 1) - slope);
    }
    const LaneLoads sum = loadsAt(stream, inflow(stream, rule));
    for (int l = 0; l < kFloatLanes; ++l) {
      const double area = block.area[l], lever = area * block.radius[l];
      load.thrust += area * sum.thrust[l];
      load.torque += lever * sum.against[l];
      load.drag += area * sum.drag[l];
      load.rollMoment += lever * sum.roll[l];
    }
  }
  const double force = 0.5 * air.density * speed * speed * radius_ * radius_;
  load.thrust *= force;
  load.drag *= force;
  load.torque *= force * radius_;
  load.rollMoment *= force * radius_;
  return load;
}

}  // namespace rotorbench
