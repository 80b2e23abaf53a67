// How long a supply carries a constant power: the discharge is integrated with open-circuit
// voltage, sag and polarisation (battery.h) until something ends it. SI units.
//   i = P/V, V the bus of bus.h
#pragma once

#include "sim/core/sentence.h"
#include "sim/propulsion/drive/battery.h"

namespace rotorbench {

struct ConstantLoad {
  double power = 0;         ///< W drawn at the terminals
  double leastVoltage = 0;  ///< V at the terminals that full throttle needs to hold the load
  double reserve = 0;       ///< state of charge at which it is to end
};

enum class DischargeEnd { Reserve, CutOff, Throttle, Collapse, Never };

struct Discharge {
  double time = 0;    ///< s; infinite where nothing ends it
  double charge = 1;  ///< state of charge at the end
  DischargeEnd end = DischargeEnd::Never;
};

/// From the supply's charge at the start on, without polarisation.
Discharge discharge(const Supply& supply, const ConstantLoad& load);

/// Voltage in V at the terminals under a power in W with `inner` = OCV - v_rc behind R_0; NaN where
/// the supply cannot give it.
double voltageUnder(double power, double inner, double resistance);

/// Why it ends, as the end of a sentence: "the reserve of 20 % charge is reached".
Sentence reasonOf(DischargeEnd end, const Supply& supply, const ConstantLoad& load);

}  // namespace rotorbench
