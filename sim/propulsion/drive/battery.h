// A battery pack of N_s cells in series and N_p in parallel, as an equivalent circuit: open-circuit
// voltage over the state of charge, a series resistance and one RC pair. SI units; charge in
// coulomb.
//   v = N_s OCV(z) - v_rc - R_0 i,   dz/dt = -i/(N_p Q),   dv_rc/dt = (R_1 i - v_rc)/tau_1
//   M. Chen, G. A. Rincon-Mora, "Accurate electrical battery model capable of predicting runtime
//     and I-V
//   performance", IEEE Trans. Energy Conversion 21 (2006) 504-511, with the shorter of its two RC
//     pairs.
#pragma once

#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "sim/core/scalar.h"
#include "sim/core/schema.h"
#include "sim/propulsion/drive/motor.h"

namespace rotorbench {

/// One point of the open-circuit voltage of a cell.
struct CellVoltage {
  double charge = 0;     ///< state of charge, 0..1
  double voltage = 3.7;  ///< V
  bool operator==(const CellVoltage&) const = default;
};

/// The curve of Chen and Rincon-Mora, eq. (2), at 21 points, continued to the 4.20 V of a full
/// cell.
std::vector<CellVoltage> lithiumPolymerVoltages();

struct BatteryParameters {
  int series = 3;
  int parallel = 1;
  double capacity = 2200 * 3.6;  ///< C, of one cell
  std::vector<CellVoltage> openCircuit = lithiumPolymerVoltages();
  double resistance = 0.006;        ///< R_0, Ohm, of one cell
  double polarisation = 0.003;      ///< R_1, Ohm, of one cell
  double polarisationTime = 32.85;  ///< tau_1, s
  double cutOff = 3.0;              ///< V, of one cell: the run ends below it
  double charge = 1;                ///< state of charge at the start, 0..1
  bool operator==(const BatteryParameters&) const = default;
};

using SupplyModel = std::variant<SupplyParameters, BatteryParameters>;

/// A supply ready to be computed with: a battery, or a fixed voltage as a battery that never
/// empties.
class Supply {
 public:
  explicit Supply(const SupplyModel& model);

  /// Open-circuit voltage of the pack in V at state of charge z; held constant beyond 0 and 1. Any
  /// scalar.
  template <class S>
  [[nodiscard]] S openCircuit(const S& z) const {
    using std::max;
    using std::min;
    const S place = min(max(z, S(0)), S(1)) * S(kCells);
    // NaN is no index; it goes on in the value, and the solver names it.
    const int cell = valueOf(place) < kCells ? static_cast<int>(valueOf(place)) : kCells - 1;
    const auto i = static_cast<std::size_t>(cell);
    return S(voltages_[i] + (place - S(cell)) * (voltages_[i + 1] - voltages_[i]));
  }

  /// Seconds for which the pack gives a constant power in W from a state of charge on, polarised as
  /// after a long time, until it is empty or below its cut-off; infinite for a supply that never
  /// empties and for no power.
  [[nodiscard]] double secondsAt(double power, double stateOfCharge) const;

  double resistance = 0;               ///< R_0 of the pack, Ohm
  double polarisation = 0;             ///< R_1 of the pack, Ohm
  double inversePolarisationTime = 0;  ///< 1/tau_1, 1/s
  double inverseCapacity = 0;          ///< 1/C; 0 for a supply that never empties
  double cutOff = 0;                   ///< V of the pack; 0: none
  double charge = 1;                   ///< at the start

 private:
  static constexpr int kCells = 200;
  std::array<double, kCells + 1> voltages_{};
};

template <>
struct Describe<CellVoltage> {
  static void fields(schema::Builder<CellVoltage>& b);
};
template <>
struct Describe<BatteryParameters> {
  static void fields(schema::Builder<BatteryParameters>& b);
};

}  // namespace rotorbench
