// Random vehicles in random surroundings: whatever the schema allows flies by finite numbers, with
// its energy accounted for, or ends with a sentence that says why not.
#include <QTest>
#include <cmath>
#include <map>

#include "sim/document/experiment_file.h"
#include "sim/run/preflight.h"
#include "sim/run/simulation.h"
#include "tests/full_set.h"
#include "tests/sim/run/random_vehicle.h"

using namespace rotorbench;
using namespace rotorbench::test;

namespace {

constexpr std::uint64_t kSeed = 2014;

int vehicles() {
  return fullSet() ? 10'000 : 2'000;
}

/// Every way a flight may come out.
struct Count {
  int refused = 0, finished = 0, failed = 0;
  std::map<std::string, int> stoppedBy;  ///< of the failed: what the failure names
};

/// W that a speed controller may lose at most beside its switches' resistance, with room for a bus
/// that is found in two rounds.
double mostLoss(const RotorParameters& rotor, double bus, double current) {
  const EscParameters& esc = rotor.esc;
  double loss =
      esc.switchingLoss * bus * std::abs(current) + esc.leadResistance * current * current;
  if (esc.pwmFrequency > 0) loss += 0.25 * bus * bus / (esc.resistance + rotor.motor.resistance);
  constexpr double kRoom = 2;
  return kRoom * loss;
}

/// What the supply gives is what converters, motors and avionics take, and its voltage is what its
/// resistance leaves: relative to the larger of what is compared. Returns what is wrong.
QString ledgerFault(const Flight& flight, const Recording& r, std::size_t row) {
  const auto value = [&](const std::string& name) { return r.value(*r.find(name), row); };
  const std::vector<RotorAtHub> rotors = rotorsOf(flight.vehicle);
  const double bus = value("supply.voltage");
  double taken = 0, size = 0, most = flight.vehicle.avionicsPower;
  for (std::size_t i = 0; i < rotors.size(); ++i) {
    const std::string rotor = "rotor" + std::to_string(i + 1);
    const double current = value(rotor + ".current");
    const double power =
        value(rotor + ".power") + rotors[i].rotor.esc.resistance * current * current;
    taken += power;
    size += std::abs(value(rotor + ".power")) + rotors[i].rotor.esc.resistance * current * current;
    most += mostLoss(rotors[i].rotor, bus, current);
  }
  const double given = value("supply.power"), rest = given - taken;
  const double rounding = 1e-9 * (size + most) + 1e-12;
  if (!(rest >= -rounding && rest <= most + rounding))
    return QString("gives %1 W, motors take %2 W, at most %3 W are lost or the avionics'")
        .arg(given)
        .arg(taken)
        .arg(most);
  const double current = value("supply.current");
  if (!(bus >= 0)) return QString("bus of %1 V").arg(bus);
  if (const auto* fixed = std::get_if<SupplyParameters>(&flight.vehicle.supply)) {
    const double open = bus + fixed->internalResistance * current;
    if (!(std::abs(open - fixed->voltage) <= 1e-9 * (fixed->voltage + bus)))
      return QString("%1 V behind the resistance, not %2 V").arg(open).arg(fixed->voltage);
  }
  return {};
}

/// The first fault of a run's recording, or nothing.
QString recordingFault(const Flight& flight, const Recording& r) {
  for (std::size_t row = 0; row < r.rows(); ++row) {
    for (std::size_t c = 0; c < r.channels().size(); ++c)
      if (!std::isfinite(r.value(c, row)))
        return QString("%1 is not finite").arg(r.channels()[c].name.c_str());
    if (const QString fault = ledgerFault(flight, r, row); !fault.isEmpty())
      return QString("at %1 s: %2").arg(r.value(0, row)).arg(fault);
  }
  return {};
}

/// Flies one; returns what is wrong with how it came out.
QString fly(const Experiment& e, Count& count) {
  for (const Problem& problem : runWarnings(e))
    if (problem.what.empty()) return "a warning without words";
  std::unique_ptr<Simulation> simulation;
  try {
    simulation = buildSimulation(e);
  } catch (const InputError& error) {
    ++count.refused;
    for (const Problem& p : error.problems())
      if (p.what.empty()) return "refused without words";
    return error.problems().empty() ? "refused without a problem" : QString();
  }
  while (simulation->advance(1000) == SimulationState::Running) {
  }
  static_cast<void>(simulation->metrics());
  if (simulation->state() == SimulationState::Failed) {
    ++count.failed;
    ++count.stoppedBy[simulation->failure()->component];
    if (simulation->failure()->message.size() < 20) return "failed without a sentence";
    return {};
  }
  ++count.finished;
  return recordingFault(alternative<Flight>(e.setup), *simulation->runs().front().recording);
}

}  // namespace

class TestRandomVehicles : public QObject {
  Q_OBJECT
 private slots:
  void flyOrSayWhyNot() {
    RandomVehicles random(kSeed);
    Count count;
    int faults = 0;
    for (int i = 0; i < vehicles(); ++i) {
      const Experiment e = random.next();
      const QString fault = fly(e, count);
      if (fault.isEmpty()) continue;
      if (++faults <= 5) qWarning("%d: %s\n%s", i, qPrintable(fault), writeExperiment(e).c_str());
    }
    qInfo("%d flew to their end, %d stopped, %d were refused; %d drawn ones were not valid",
          count.finished, count.failed, count.refused, random.refused());
    for (const auto& [what, times] : count.stoppedBy) qInfo("  by %s: %d", what.c_str(), times);
    QCOMPARE(faults, 0);
    // Else nothing was tried.
    QVERIFY(count.finished > vehicles() / 3);
    QVERIFY(count.failed > 0 && count.refused > 0);
  }

  /// The check is one: a ledger that does not close and a voltage below 0 are found.
  void faultsAreFound() {
    Flight flight;
    Recording r({{"time", "s", ""},
                 {"supply.voltage", "V", ""},
                 {"supply.current", "A", ""},
                 {"supply.power", "W", ""},
                 {"rotor1.current", "A", ""},
                 {"rotor1.power", "W", ""},
                 {"rotor2.current", "A", ""},
                 {"rotor2.power", "W", ""},
                 {"rotor3.current", "A", ""},
                 {"rotor3.power", "W", ""},
                 {"rotor4.current", "A", ""},
                 {"rotor4.power", "W", ""}},
                {});
    r.append(std::vector<double>{0, 11.1, 4, 44.4, 1, 11.1, 1, 11.1, 1, 11.1, 1, 11.1});
    r.append(std::vector<double>{1, 11.1, 4, 44.5, 1, 11.1, 1, 11.1, 1, 11.1, 1, 11.1});
    r.append(std::vector<double>{2, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    r.publish();
    QVERIFY(ledgerFault(flight, r, 0).isEmpty());
    QVERIFY(ledgerFault(flight, r, 1).contains("44.5 W"));
    QVERIFY(ledgerFault(flight, r, 2).contains("-1 V"));
  }
};

QTEST_GUILESS_MAIN(TestRandomVehicles)
#include "test_random_vehicles.moc"
