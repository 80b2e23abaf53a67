#include "sim/propulsion/rotor/rotor_models.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <optional>

#include "sim/propulsion/rotor/map_store.h"

namespace rotorbench {

namespace {

/// Maps made or read in this process, the latest first.
class MapCache {
 public:
  std::shared_ptr<const PreparedRotor> find(const MapPropeller& p) {
    const std::shared_ptr<Entry> entry = entryOf(p);
    // Built outside the lock: others may build other propellers meanwhile, and who wants this one
    // waits for it.
    std::call_once(entry->once, [&] {
      const BladeElementRotor rotor(p.propeller, p.settings);
      const MapStore store(MapStore::userFolder());
      std::optional<PropellerMap> map = store.find(p, rotor);
      if (!map) {
        map.emplace(rotor, p.map);
        store.keep(p, rotor, *map);
      }
      entry->rotor = std::make_shared<const PreparedRotor>(std::move(*map));
    });
    return entry->rotor;
  }

 private:
  struct Entry {
    explicit Entry(MapPropeller p) : propeller(std::move(p)) {}
    MapPropeller propeller;
    std::once_flag once;
    std::shared_ptr<const PreparedRotor> rotor;
  };

  std::shared_ptr<Entry> entryOf(const MapPropeller& p) {
    constexpr std::size_t kKept = 16;
    const std::scoped_lock lock(mutex_);
    const auto found =
        std::ranges::find_if(entries_, [&](const auto& e) { return e->propeller == p; });
    if (found != entries_.end()) return *found;
    entries_.push_front(std::make_shared<Entry>(p));
    if (entries_.size() > kKept) entries_.pop_back();
    return entries_.front();
  }

  std::mutex mutex_;
  std::deque<std::shared_ptr<Entry>> entries_;
};

struct Prepare {
  using Result = std::shared_ptr<const PreparedRotor>;
  Result operator()(const PropellerCoefficients& /*p*/) const { return {}; }
  Result operator()(const RotorCoefficients& /*p*/) const { return {}; }
  Result operator()(const MeasuredPropeller& p) const {
    return std::make_shared<const PreparedRotor>(CoefficientTable(p));
  }
  Result operator()(const MapPropeller& p) const {
    static MapCache cache;
    return cache.find(p);
  }
  Result operator()(const BladeElementPropeller& p) const {
    return std::make_shared<const PreparedRotor>(BladeElementRotor(p.propeller, p.settings));
  }
};

}  // namespace

std::shared_ptr<const PreparedRotor> prepareRotor(const RotorAerodynamics& aerodynamics) {
  return std::visit(Prepare{}, aerodynamics);
}

double rotorRadius(const RotorAerodynamics& aerodynamics) {
  if (const PropellerGeometry* geometry = rotorGeometry(aerodynamics))
    return geometry->diameter / 2;
  return std::visit(
      [](const auto& a) {
        if constexpr (requires { diameterOf(a); })
          return diameterOf(a) / 2;
        else if constexpr (requires { a.diameter; })
          return a.diameter / 2;
        else
          return a.propeller.diameter / 2;
      },
      aerodynamics);
}

const PropellerGeometry* rotorGeometry(const RotorAerodynamics& aerodynamics) {
  if (const auto* map = std::get_if<MapPropeller>(&aerodynamics)) return &map->propeller;
  const auto* solved = std::get_if<BladeElementPropeller>(&aerodynamics);
  return solved != nullptr ? &solved->propeller : nullptr;
}

void Describe<MapPropeller>::fields(schema::Builder<MapPropeller>& b) {
  using P = MapPropeller;
  b.title("map", "Propeller map",
          "Blade elements, tabulated once over the direction of the air and the Reynolds number: "
          "as exact as blade elements and hundreds of times faster.",
          "Glauert; Prandtl; Drela, QPROP");
  b.group("propeller", &P::propeller, "Propeller");
  b.group("settings", &P::settings, "Blade elements").advanced();
  b.group("map", &P::map, "Map").advanced();
}

void Describe<BladeElementPropeller>::fields(schema::Builder<BladeElementPropeller>& b) {
  using P = BladeElementPropeller;
  b.title("blade-element", "Blade elements",
          "The propeller by its geometry and sections, solved at every evaluation: the reference, "
          "and slow. In flight the propeller map does the same.",
          "Glauert; Prandtl; Drela, QPROP");
  b.group("propeller", &P::propeller, "Propeller");
  b.group("settings", &P::settings, "Blade elements").advanced();
}

}  // namespace rotorbench
