#include "sim/run/controller_factory.h"

#include "sim/control/pid_flight.h"
#include "sim/control/state_feedback.h"

namespace rotorbench {

namespace {

template <class C, class P>
MadeController make(const P& parameters, const ControllerSite& site) {
  const Timing timing{ticksBetween(parameters.rate, site.tick, site.controller / "rate")};
  auto controller = std::make_unique<C>(parameters, site.model, timing, site.vehicle);
  C* const flying = controller.get();
  MadeController made(std::move(controller));
  if constexpr (requires { flying->retune(parameters); })
    made.retune = [flying](const ControllerParameters& p) { flying->retune(std::get<P>(p)); };
  return made;
}

/// One line for every alternative of ControllerParameters. A controller with live parameters has
/// retune(P), which takes them in the course of a flight.
struct Maker {
  const ControllerSite& site;
  using Made = MadeController;
  Made operator()(const PidFlightParameters& p) const { return make<PidFlight>(p, site); }
  Made operator()(const StateFeedbackParameters& p) const { return make<StateFeedback>(p, site); }
  Made operator()(const LqrParameters& p) const { return make<StateFeedback>(p, site); }
};

}  // namespace

MadeController makeController(const ControllerParameters& parameters, const ControllerSite& site) {
  return std::visit(Maker{site}, parameters);
}

}  // namespace rotorbench
