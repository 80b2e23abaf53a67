// Random experiments that their schema allows: a vehicle, its surroundings, a start and who flies
// it, from one seed. Everyday figures mostly, the ends of ranges now and then; maps and blade
// elements are left out, for they take long and have tests of their own.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/core/random.h"
#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/experiment.h"
#include "sim/document/flight.h"

namespace rotorbench::test {

class RandomVehicles {
 public:
  explicit RandomVehicles(std::uint64_t seed) : random_(seed, "vehicles") {}

  /// One that schema::validate() has nothing against.
  Experiment next() {
    for (;;) {
      Experiment e = draw();
      const auto problems = schema::validate(schema::ref(e));
      if (std::ranges::all_of(problems, &Problem::warning)) return e;
      ++refused_;
    }
  }
  /// How many the schema refused so far.
  [[nodiscard]] int refused() const { return refused_; }

 private:
  Experiment draw() {
    Experiment e;
    Flight& flight = alternative<Flight>(e.setup);
    vary(schema::ref(flight.vehicle));
    if (auto* own = std::get_if<IndividualRotors>(&flight.vehicle.rotors))
      own->rotors.resize(static_cast<std::size_t>(rotorCount(flight.vehicle.layout)),
                         own->rotors.front());
    vary(schema::ref(flight.environment));
    vary(schema::ref(flight.start));
    if (chance(0.3)) {
      flight.control = VoltageInputs{};
      if (chance(0.5)) flight.start.rotors = RotorStart::Stopped;
    } else {
      auto& inputs = *std::get<Box<ControlledInputs>>(flight.control);
      inputs.setPoints = {{0, 0, 0, 0, 0}, {0.01, 3 * uniform(), uniform(), 0, uniform()}};
    }
    using ode::Method;
    constexpr Method kMethods[] = {Method::ExponentialRk4, Method::ExponentialRk4, Method::Rk4,
                                   Method::Euler,          Method::Abm4,           Method::Rk547M};
    flight.solver.method = kMethods[below(std::size(kMethods))];
    flight.solver.maximumSteps = 2000;
    flight.tick = flight.solver.step = 1e-3;
    flight.duration = chance(0.1) ? 0.5 : 0.05;
    for (const auto& loose : schema::looseFollowers(schema::ref(e)))
      loose.follower->follow(loose.owner.object);
    return e;
  }

  double uniform() { return random_.uniform(); }
  bool chance(double share) { return uniform() < share; }
  std::size_t below(std::size_t n) { return random_.bits() % n; }

  void vary(schema::Ref ref) {
    for (const schema::Field& field : ref.type->fields) varyField(field, ref.object);
  }

  void varyField(const schema::Field& field, void* owner) {
    using schema::Kind;
    switch (field.kind) {
      case Kind::Number:
        return field.write(owner, number(field, std::get<double>(field.read(owner))));
      case Kind::Vector: {
        auto values = std::get<std::vector<double>>(field.read(owner));
        for (double& v : values) v = number(field, v);
        return field.write(owner, values);
      }
      case Kind::Boolean:
        if (chance(0.2)) field.write(owner, chance(0.5));
        return;
      case Kind::Choice:
        if (chance(0.3)) field.write(owner, field.options[below(field.options.size())].key);
        return;
      case Kind::Group:
        return vary({&field.childType(owner, 0), field.child(owner, 0)});
      case Kind::Variant:
        choose(field, owner);
        return vary({&field.childType(owner, 0), field.child(owner, 0)});
      case Kind::List:
        // Rows of a table belong together.
        for (std::size_t i = 0; !field.asTable && i < field.count(owner); ++i)
          vary({&field.childType(owner, i), field.child(owner, i)});
        return;
      default:
        return;
    }
  }

  void choose(const schema::Field& field, void* owner) {
    if (!chance(0.4)) return;
    const std::size_t option = below(field.options.size());
    const std::string& key = field.options[option].key;
    if (key == "map" || key == "blade-element") return;
    field.choose(owner, option);
  }

  /// Near what it was, somewhere in its decades, or at an end of its range.
  double number(const schema::Field& field, double v) {
    const auto& [low, high] = field.range;
    const double way = uniform();
    if (way < 0.55) return v;
    double next = v;
    if (way < 0.9) {
      next = v != 0 ? v * std::exp(0.5 * random_.normal())
                    : small(high.value) * (chance(0.5) ? 1 : -1);
    } else if (way < 0.97) {
      next = v != 0 ? v * std::pow(10.0, 6 * uniform() - 3) : small(high.value);
    } else if (const schema::Bound& end = chance(0.7) ? low : high; !end.open) {
      next = end.value;
    }
    return field.range.contains(next) ? next : v;
  }
  double small(double high) { return std::min(high, 1.0) * std::pow(10.0, -6 * uniform()); }

  RandomStream random_;
  int refused_ = 0;
};

}  // namespace rotorbench::test
