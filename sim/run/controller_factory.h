// Makes the controller of a flight from its settings.
#pragma once

#include <memory>

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

/// Throws InputError where the settings do not suit the site.
std::unique_ptr<Controller> makeController(const ControllerParameters& parameters,
                                           const ControllerSite& site);

}  // namespace rotorbench
