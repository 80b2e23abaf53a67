#include "sim/document/changes.h"

#include <algorithm>
#include <cmath>

#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/experiment.h"
#include "sim/document/flight.h"

namespace rotorbench {

namespace {

constexpr const char* kAllowed =
    "gains, set-points and the numbers of a wind may change during a flight; all else needs a new "
    "run";

/// The first rule over several parameters that does not hold where changes may reach.
std::optional<Problem> brokenRule(const Flight& flight, std::string_view path) {
  const auto firstOf = [](schema::ConstRef node) -> std::optional<Problem> {
    for (Problem& problem : schema::validate(node))
      if (!problem.warning) return std::move(problem);
    return {};
  };
  if (path.starts_with("environment.")) return firstOf(schema::ref(flight.environment));
  const auto* inputs = std::get_if<Box<ControlledInputs>>(&flight.control);
  if (!path.starts_with("control.") || inputs == nullptr) return {};
  const ControlledInputs& all = **inputs;
  if (path.starts_with("control.setPoints")) return firstOf(schema::ref(all));
  // A timeline may have many thousand rows, of which none has changed.
  const ControlledInputs others{
      all.controller, all.motors, {all.setPoints.front()}, all.interpolation, all.byHand};
  return firstOf(schema::ref(others));
}

class Differences {
 public:
  LiveDifference found;

  void compare(schema::ConstRef from, schema::ConstRef to, const std::string& parent) {
    for (const schema::Field& field : from.type->fields) {
      const std::string path = schema::joinPath(parent, field.key);
      if (field.isLeaf()) {
        compareLeaf(field, from.object, to.object, path);
      } else if (field.kind == schema::Kind::List) {
        compareList(field, from.object, to.object, path);
      } else if (field.kind == schema::Kind::Variant &&
                 field.chosen(from.object) != field.chosen(to.object)) {
        other(field);
      } else {
        compare(child(field, from.object, 0), child(field, to.object, 0), path);
      }
    }
  }

 private:
  static schema::ConstRef child(const schema::Field& field, const void* owner, std::size_t index) {
    return {&field.childType(owner, index), field.constChild(owner, index)};
  }
  void other(const schema::Field& field) {
    if (found.other.empty()) found.other = field.label;
  }
  void compareLeaf(const schema::Field& field, const void* from, const void* to,
                   const std::string& path) {
    const schema::Value value = field.read(to);
    if (value == field.read(from)) return;
    if (!field.live) return other(field);
    found.changes.push_back({0, path, schema::toText(field, value)});
  }
  void compareList(const schema::Field& field, const void* from, const void* to,
                   const std::string& path) {
    if (field.count(from) != field.count(to)) return other(field);
    for (std::size_t i = 0; i < field.count(from); ++i)
      compare(child(field, from, i), child(field, to, i), path + "[" + std::to_string(i) + "]");
  }
};

}  // namespace

void Describe<Change>::fields(schema::Builder<Change>& b) {
  b.title("change", "Change", "A parameter that takes another value during the flight.");
  b.number("time", &Change::time, "Time", "t", "s")
      .range(schema::atLeast(0), schema::upTo(1e6))
      .help("Acts from the first tick on that is not before it.");
  b.text("parameter", &Change::parameter, "Parameter")
      .help(
          "Its path from the flight on, such as control.controller.roll.kp or "
          "environment.wind.velocity.");
  b.text("value", &Change::value, "Value")
      .help("As after --set: 30, 12 deg, [5, 0, 0] m/s. Without a unit SI.");
}

std::optional<Problem> makeChange(Flight& flight, const Change& change) {
  const std::string path = flightPath(change.parameter);
  const schema::Ref root = schema::ref(flight);
  try {
    const schema::Location at = schema::locate(root, path);
    if (!at.field->live || !at.field->isLeaf())
      return Problem{path, "cannot change during a flight", kAllowed};
    const schema::Value before = at.field->read(at.owner);
    schema::setFromText(root, path, change.value);
    if (auto problem = brokenRule(flight, path)) {
      at.field->write(at.owner, before);
      return problem;
    }
  } catch (const InputError& error) {
    return error.problems().front();
  }
  return {};
}

std::string flightPath(const std::string& path) {
  constexpr std::string_view kSetup = "setup.";
  return path.starts_with(kSetup) ? path.substr(kSetup.size()) : path;
}

namespace {

const char* keyOf(HandAxis axis) {
  static constexpr const char* kKeys[] = {"height", "roll", "pitch", "yaw"};
  return kKeys[static_cast<int>(axis)];
}

std::string handPath(HandAxis axis) {
  return std::string("control.byHand.") + keyOf(axis);
}

}  // namespace

bool hasSetPoints(const Flight& flight) {
  return holdsAlternative<ControlledInputs>(flight.control);
}

std::vector<Change> takenByHand(HandAxis axis, double value) {
  const schema::Field& field = *schema::typeOf<HandSetPoints>().field(keyOf(axis));
  // Its value first: taken over with the one before, the vehicle would be shown a wrong one.
  return {{0, handPath(axis), schema::toText(field, value)}, {0, handPath(axis) + "ByHand", "on"}};
}

Change givenBack(HandAxis axis) {
  return {0, handPath(axis) + "ByHand", "off"};
}

void setChanges(Experiment& experiment, const std::vector<Change>& changes) {
  if (holdsAlternative<Flight>(experiment.setup))
    alternative<Flight>(experiment.setup).changes = changes;
}

std::int64_t tickOfChange(double time, double tick) {
  // What was meant for a tick and is late by rounding is not left to the next.
  constexpr double kRounding = 1e-6;
  return std::max<std::int64_t>(0, std::llround(std::ceil(time / tick - kRounding)));
}

LiveDifference liveDifference(const Flight& from, const Flight& to) {
  Differences differences;
  differences.compare(schema::ref(from), schema::ref(to), {});
  return std::move(differences.found);
}

}  // namespace rotorbench
