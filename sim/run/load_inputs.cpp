#include "sim/run/load_inputs.h"

#include <algorithm>

#include "sim/io/csv.h"
#include "sim/signal/input_signal.h"

namespace rotorbench {

namespace {

PerRotor lanesOf(const std::vector<double>& values) {
  PerRotor lanes = PerRotor::Zero();
  for (std::size_t i = 0; i < values.size(); ++i) lanes[static_cast<int>(i)] = values[i];
  return lanes;
}

template <class Quantity>
RotorInputs fromCsv(const CsvInputs<Quantity>& csv, int rotors,
                    const std::filesystem::path& directory, const Place& place) {
  if (csv.file.empty()) throw place.error({{"source.file", "no file is named", "a CSV file"}});
  const CsvTable table = readCsvFile(directory / csv.file);
  if (table.columns.size() != static_cast<std::size_t>(rotors) + 1) {
    throw InputError(table.source,
                     {{"", "has " + std::to_string(table.columns.size()) + " columns",
                       std::to_string(rotors + 1) + ": time, then one for each rotor"}});
  }
  const auto time = table.values(table.columns.front().name, "s");
  std::vector<RotorInputs::Sample> samples(time.size(), {0, PerRotor::Zero()});
  for (std::size_t r = 0; r < time.size(); ++r) {
    samples[r].time = time[r];
  }
  using Sample = RotorInputs::Sample;
  if (const auto wrong = schema::rowsNotRising(samples, &Sample::time); !wrong.empty()) {
    throw InputError(table.source, {schema::notRising("row " + std::to_string(wrong.front() + 1),
                                                      schema::kRisingTimes)});
  }
  for (int i = 0; i < rotors; ++i) {
    const auto values =
        table.values(table.columns[static_cast<std::size_t>(i) + 1].name, Quantity::kUnit);
    for (std::size_t r = 0; r < values.size(); ++r) {
      if (values[r] < Quantity::kLow || values[r] > Quantity::kHigh) {
        throw InputError(
            table.source,
            {{"row " + std::to_string(r + 1), "rotor " + std::to_string(i + 1) + " is out of range",
              "at least " + std::to_string(Quantity::kLow) + " and at most " +
                  std::to_string(Quantity::kHigh) + " " + Quantity::kUnit}});
      }
      samples[r].values[i] = values[r];
    }
  }
  if (samples.empty()) throw InputError(table.source, {{"", "has no rows", "at least one"}});
  return {std::move(samples), csv.interpolation};
}

template <class Quantity>
RotorInputs load(const PrescribedInputs<Quantity>& inputs, int rotors,
                 const std::filesystem::path& directory, const Place& place) {
  if (const auto* constant = std::get_if<ConstantInputs<Quantity>>(&inputs.source))
    return {{{0, lanesOf(constant->values)}}, Interpolation::Hold};
  if (const auto* csv = std::get_if<CsvInputs<Quantity>>(&inputs.source))
    return fromCsv(*csv, rotors, directory, place);
  const auto& table = std::get<TableInputs<Quantity>>(inputs.source);
  std::vector<RotorInputs::Sample> samples;
  samples.reserve(table.rows.size());
  for (const auto& row : table.rows) samples.push_back({row.time, lanesOf(row.values)});
  return {std::move(samples), table.interpolation};
}

}  // namespace

RotorInputs loadInputs(const SpeedInputs& inputs, int rotors,
                       const std::filesystem::path& directory, const Place& place) {
  return load(inputs, rotors, directory, place);
}
RotorInputs loadInputs(const VoltageInputs& inputs, int rotors,
                       const std::filesystem::path& directory, const Place& place) {
  return load(inputs, rotors, directory, place);
}

}  // namespace rotorbench
