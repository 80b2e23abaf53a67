// Makes the controller of a flight from its settings.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "sim/control/control_model.h"
#include "sim/control/controller.h"
#include "sim/core/place.h"
#include "sim/document/controlled_inputs.h"

namespace rotorbench {

/// What a controller is made for.
struct ControllerSite {
  const ControlModel& model;
  double tick = 0;   ///< s, of the flight
  Place controller;  ///< where its settings stand in the document
  Place vehicle;     ///< where the vehicle does
};

/// A controller, and how it takes other settings in the course of a flight.
struct MadeController {
  MadeController() = default;
  /// One that takes none.
  template <class C>
  MadeController(std::unique_ptr<C> made) : task(std::move(made)) {}  // NOLINT: it is one
  std::unique_ptr<Controller> task;
  std::function<void(const ControllerParameters&)> retune;  ///< of the same alternative
};

/// Throws InputError where the settings do not suit the site.
MadeController makeController(const ControllerParameters& parameters, const ControllerSite& site);

}  // namespace rotorbench
