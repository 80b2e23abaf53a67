// Rotor inputs laid down in advance instead of coming from a controller: constant, from a table
// over time in the experiment, or from a CSV file. The same three sources serve every quantity
// (rotor speed, motor voltage).
#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "sim/core/rising.h"
#include "sim/core/schema.h"
#include "sim/signal/input_signal.h"
#include "sim/signal/signals.h"

namespace rotorbench {

/// Quantities that can be laid down, one value per rotor.
struct RotorSpeedQuantity {
  static constexpr const char *kKey = "rotor-speeds", *kLabel = "Prescribed rotor speeds",
                              *kValues = "speeds", *kValuesLabel = "Rotor speeds", *kSymbol = "Ω",
                              *kUnit = "rad/s", *kShownIn = "rpm",
                              *kHelp = "No controller: the values are laid down in advance.";
  static constexpr double kDefault = 500, kLow = -10000, kHigh = 10000;
};
struct MotorVoltageQuantity {
  static constexpr const char *kKey = "motor-voltages", *kLabel = "Prescribed motor voltages",
                              *kValues = "voltages", *kValuesLabel = "Motor voltages",
                              *kSymbol = "v", *kUnit = "V", *kShownIn = "V",
                              *kHelp =
                                  "No controller: the values are laid down in advance. A negative "
                                  "voltage drives a motor backwards where its speed controller is "
                                  "reversible and counts as 0 elsewhere.";
  static constexpr double kDefault = 5, kLow = -1000, kHigh = 1000;
};

/// One value per rotor, in the order of their numbers.
template <class Quantity>
std::vector<double> defaultInputs() {
  return std::vector<double>(4, Quantity::kDefault);
}

template <class Quantity>
struct ConstantInputs {
  std::vector<double> values = defaultInputs<Quantity>();
  bool operator==(const ConstantInputs&) const = default;
};

template <class Quantity>
struct InputRow {
  double time = 0;  ///< s
  std::vector<double> values = defaultInputs<Quantity>();
  bool operator==(const InputRow&) const = default;
};

template <class Quantity>
struct TableInputs {
  std::vector<InputRow<Quantity>> rows{1};
  Interpolation interpolation = Interpolation::Hold;
  bool operator==(const TableInputs&) const = default;
};

/// Columns: time in s, then one per rotor. Units may stand in the header: "rotor1 [rpm]".
template <class Quantity>
struct CsvInputs {
  std::string file;
  Interpolation interpolation = Interpolation::Linear;
  bool operator==(const CsvInputs&) const = default;
};

template <class Q>
struct PrescribedInputs {
  using Quantity = Q;
  std::variant<ConstantInputs<Quantity>, TableInputs<Quantity>, CsvInputs<Quantity>> source;
  bool operator==(const PrescribedInputs&) const = default;
};

using SpeedInputs = PrescribedInputs<RotorSpeedQuantity>;
using VoltageInputs = PrescribedInputs<MotorVoltageQuantity>;

template <class Q>
struct Describe<ConstantInputs<Q>> {
  static void fields(schema::Builder<ConstantInputs<Q>>& b) {
    b.title("constant", "Constant", "The same values from start to end.");
    b.vector(Q::kValues, &ConstantInputs<Q>::values, 4, kMostRotors, Q::kValuesLabel, Q::kSymbol,
             Q::kUnit)
        .range(schema::atLeast(Q::kLow), schema::upTo(Q::kHigh))
        .shownIn(Q::kShownIn)
        .help("One value per rotor, in the order of their numbers.");
  }
};

template <class Q>
struct Describe<InputRow<Q>> {
  static void fields(schema::Builder<InputRow<Q>>& b) {
    b.title("row", "Row", "Values from one instant on.");
    b.number("time", &InputRow<Q>::time, "Time", "t", "s")
        .range(schema::atLeast(0), schema::upTo(1e6));
    b.vector(Q::kValues, &InputRow<Q>::values, 4, kMostRotors, Q::kValuesLabel, Q::kSymbol,
             Q::kUnit)
        .range(schema::atLeast(Q::kLow), schema::upTo(Q::kHigh))
        .shownIn(Q::kShownIn);
  }
};

template <class Q>
struct Describe<TableInputs<Q>> {
  static void fields(schema::Builder<TableInputs<Q>>& b) {
    b.title("table", "Table", "Values over time, kept in the experiment.");
    schema::risingList(b, "rows", &TableInputs<Q>::rows, "Table", &InputRow<Q>::time,
                       schema::kRisingTimes)
        .items(1, 100000)
        .table();
    b.choice("interpolation", &TableInputs<Q>::interpolation, "Between the rows", interpolations());
  }
};

template <class Q>
struct Describe<CsvInputs<Q>> {
  static void fields(schema::Builder<CsvInputs<Q>>& b) {
    b.title("csv", "CSV file", "Values over time, read from a file when the run is built.");
    b.text("file", &CsvInputs<Q>::file, "File")
        .role(schema::TextRole::FilePath)
        .help(
            "Time in s in the first column, then one column per rotor. A unit may stand in the "
            "header in brackets. A relative path starts at the folder of the experiment file.");
    b.choice("interpolation", &CsvInputs<Q>::interpolation, "Between the rows", interpolations());
  }
};

template <class Q>
struct Describe<PrescribedInputs<Q>> {
  static void fields(schema::Builder<PrescribedInputs<Q>>& b) {
    b.title(Q::kKey, Q::kLabel, Q::kHelp);
    b.variant("source", &PrescribedInputs<Q>::source, "Source");
  }
};

/// Calls f(values, path) for the values of every instant that the experiment holds; the path is
/// below the inputs.
template <class Inputs, class F>
void forEachInstant(Inputs& inputs, F&& f) {
  using Source = std::remove_const_t<Inputs>;
  std::visit(
      [&]<class S>(S& source) {
        if constexpr (requires { source.values; }) {
          f(source.values, std::string("source.") + Source::Quantity::kValues);
        } else if constexpr (requires { source.rows; }) {
          for (std::size_t i = 0; i < source.rows.size(); ++i) {
            f(source.rows[i].values,
              "source.rows[" + std::to_string(i) + "]." + Source::Quantity::kValues);
          }
        }
      },
      inputs.source);
}

}  // namespace rotorbench
