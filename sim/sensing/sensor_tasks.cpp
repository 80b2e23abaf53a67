#include "sim/sensing/sensor_tasks.h"

namespace rotorbench {

namespace {

class IdealSensorTask final : public Task {
 public:
  IdealSensorTask() : Task("sensors", {}) {}
  [[nodiscard]] SignalUse uses() const override {
    return {.reads = Signal::Truth, .writes = Signal::Measurement, .readsEarlier = {}};
  }
  void act(const ClockTick& /*tick*/, Board& board, double* /*row*/) override {
    board.measurement.body = board.truth.body;
    board.measurement.specificForce = board.truth.specificForce;
    board.measurement.drives = board.truth.drives;
  }
};

struct MakeSensors {
  std::uint64_t seed;
  std::unique_ptr<Task> operator()(const IdealSensors& /*model*/) const {
    return std::make_unique<IdealSensorTask>();
  }
};

}  // namespace

std::unique_ptr<Task> makeSensors(const SensorModel& model, std::uint64_t seed) {
  return std::visit(MakeSensors{seed}, model);
}

void Describe<IdealSensors>::fields(schema::Builder<IdealSensors>& b) {
  b.title("ideal", "Ideal sensors", "The controllers see the true motion without noise or delay.",
          "Thesis 2014, section 3.1");
}

}  // namespace rotorbench
