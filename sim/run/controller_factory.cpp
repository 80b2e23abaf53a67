#include "sim/run/controller_factory.h"

#include "sim/control/pid_flight.h"

namespace rotorbench {

namespace {

template <class C, class P>
std::unique_ptr<Controller> make(const P& parameters, const ControllerSite& site) {
  const Timing timing{ticksBetween(parameters.rate, site.tick, site.controller / "rate")};
  return std::make_unique<C>(parameters, site.model, timing, site.vehicle);
}

/// One line for every alternative of ControllerParameters.
struct Maker {
  const ControllerSite& site;
  using Made = std::unique_ptr<Controller>;
  Made operator()(const PidFlightParameters& p) const { return make<PidFlight>(p, site); }
};

}  // namespace

std::unique_ptr<Controller> makeController(const ControllerParameters& parameters,
                                           const ControllerSite& site) {
  return std::visit(Maker{site}, parameters);
}

}  // namespace rotorbench
