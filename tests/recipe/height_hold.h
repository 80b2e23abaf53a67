// The controller of README's recipe: holds the height by a proportional and a derivative gain and
// the vehicle level. What a new controller in sim/control looks like.
#pragma once

#include "sim/control/allocation.h"
#include "sim/control/control_model.h"
#include "sim/control/controller.h"
#include "sim/core/place.h"
#include "sim/core/schema.h"

namespace rotorbench {

struct HeightHoldParameters {
  double rate = 500;     ///< Hz
  double stiffness = 4;  ///< 1/s^2, acceleration per missing height
  double damping = 4;    ///< 1/s
  bool operator==(const HeightHoldParameters&) const = default;
};

class HeightHold final : public Controller {
 public:
  /// `timing` is that of parameters.rate. `vehicle` is where the layout is described.
  HeightHold(const HeightHoldParameters& parameters, const ControlModel& model, Timing timing,
             const Place& vehicle);
  [[nodiscard]] std::vector<HeldQuantity> held() const override;
  [[nodiscard]] std::vector<Channel> channels() const override;
  void act(const ClockTick& tick, Board& board, double* row) override;

 private:
  HeightHoldParameters parameters_;
  ControlModel model_;
  Allocation allocation_;
};

template <>
struct Describe<HeightHoldParameters> {
  static void fields(schema::Builder<HeightHoldParameters>& b);
};

}  // namespace rotorbench
