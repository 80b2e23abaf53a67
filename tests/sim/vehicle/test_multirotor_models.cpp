// The multirotor with each rotor model, on a battery and behind speed controllers.
#include <Eigen/Core>
#include <QtTest>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "sim/run/plant_handle.h"
#include "sim/vehicle/multirotor.h"
#include "tests/sim/run/quick_map.h"

using namespace rotorbench;
using Eigen::Vector3d;
using Plant = Multirotor<4>;
using L = Plant::Layout;

namespace {

const std::vector<std::pair<const char*, RotorAerodynamics>>& models() {
  static const std::vector<std::pair<const char*, RotorAerodynamics>> all = {
      {"lumped", PropellerCoefficients{.inflow = {1e-4, 2e-4, 3e-3, 1e-5}}},
      {"measured", MeasuredPropeller{.inPlane = {1e-4, 3e-3, 1e-5}}},
      {"map", test::quickMap()},
      {"blade-element", BladeElementPropeller{}}};
  return all;
}

void addModels() {
  QTest::addColumn<int>("model");
  for (std::size_t i = 0; i < models().size(); ++i)
    QTest::addRow("%s", models()[i].first) << static_cast<int>(i);
}

/// An F450 on a soft battery with speed controllers of 8 mOhm.
VehicleParameters vehicle(const RotorAerodynamics& aerodynamics) {
  VehicleParameters v;
  auto& rotor = std::get<EqualRotors>(v.rotors).rotor;
  rotor.aerodynamics = aerodynamics;
  rotor.esc = {.resistance = 0.008, .responseTime = 0, .maxCurrent = 18};
  // Within a piece of the table of voltages: at its joints a difference is no derivative.
  v.supply = BatteryParameters{.charge = 0.803};
  return v;
}

VehicleParameters fetched() {
  QFETCH(int, model);
  return vehicle(models()[static_cast<std::size_t>(model)].second);
}

}  // namespace

class TestMultirotorModels : public QObject {
  Q_OBJECT
 private slots:
  /// At hover speeds and the steady duties nothing changes but what the battery loses.
  void hoverIsAnEquilibrium_data() { addModels(); }
  void hoverIsAnEquilibrium() {
    Plant plant(buildMultirotor<4>(fetched(), {}));
    const auto y = plant.initialState({});
    plant.setCommand(plant.steadyDuties(plant.hoverSpeeds()));
    Plant::State d;
    plant(0, y, d);
    QVERIFY2(d.head<L::kCharge>().cwiseAbs().maxCoeff() < 1e-8,
             qPrintable(QString::number(d.head<L::kCharge>().cwiseAbs().maxCoeff())));
    QVERIFY(d[L::kCharge] > 1 && d[L::kEnergy] > 10 && d[L::kPolarisation] > 0);
  }

  /// What the controller knows of the rotors carries the vehicle at hover.
  void controllerKnowsHover_data() { addModels(); }
  void controllerKnowsHover() {
    const auto constants = buildMultirotor<4>(fetched(), {});
    const auto known = controlModel(fetched(), {}, {});
    const auto speeds = Plant(constants).hoverSpeeds();
    double thrust = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double w = speeds[static_cast<int>(i)];
      thrust += known.thrustFactor[i] * w * w;
      QVERIFY(known.maxThrust[i] > known.thrustFactor[i] * w * w);
      QVERIFY(known.motors[i].resistance > constants.hubs[i].motor.resistance);
    }
    QVERIFY(std::abs(thrust - constants.mass * constants.gravity) < 1e-9);
  }

  /// Thrust and torque of a flying rotor are those of the same propeller on the bench.
  void plantEqualsBench() {
    const BladeElementRotor bench{PropellerGeometry{}};
    const Plant solved(buildMultirotor<4>(vehicle(BladeElementPropeller{}), {}));
    const Plant mapped(buildMultirotor<4>(vehicle(test::quickMap()), {}));
    auto y = solved.initialState({});
    y.segment<3>(L::kVelocity) = Vector3d(0, 0, 2.5);
    y.head<4>() << 400, 480, 560, 640;
    solved.setBodyRates(y, Vector3d::Zero());
    Plant::State d;
    MultirotorForces<4> a, b;
    solved.derivativeAndForces(0, y, d, a);
    mapped.derivativeAndForces(0, y, d, b);
    for (std::size_t i = 0; i < 4; ++i) {
      const AxialLoad load = bench.axial(y[static_cast<int>(i)], 2.5, {});
      QVERIFY(std::abs(a.thrust[i] / load.thrust - 1) < 1e-9);
      QVERIFY(std::abs(a.torque[i] / load.torque - 1) < 1e-9);
      QVERIFY(std::abs(b.thrust[i] / load.thrust - 1) < 2e-3);
      QVERIFY(std::abs(b.torque[i] / load.torque - 1) < 1e-2);
    }
  }

  /// Source = supply + speed controllers + copper + friction + shaft + stored, at any state, within
  /// and at the limit of the current.
  void energyLedger_data() { addModels(); }
  void energyLedger() {
    Plant plant(buildMultirotor<4>(fetched(), {}));
    auto y = plant.initialState({});
    y.segment<3>(L::kVelocity) = Vector3d(4, -3, -2);
    y[L::kPolarisation] = 0.1;
    for (const double high : {12.0, 17.5, 30.0}) {
      y.head<8>() << 300, 420, 510, 600, high, -3, 7, 16;
      for (const double duty : {0.1, 0.6, 1.0}) {
        plant.setCommand({duty, 0.3, 0.5, 0.7});
        const FlightPowers p = plant.powers(0, y);
        QVERIFY2(std::abs(p.residual()) < 1e-9 * std::abs(p.source),
                 qPrintable(QString("%1 of %2 W").arg(p.residual()).arg(p.source)));
        Plant::State d;
        plant(0, y, d);
        QVERIFY(std::abs(d[L::kEnergy] - (p.source - p.supplyLoss)) < 1e-9 * std::abs(p.source));
      }
    }
  }

  /// However high the duty, the current tends to the limit and no further, in both directions.
  void currentLimit() {
    Plant plant(buildMultirotor<4>(vehicle(PropellerCoefficients{}), {}));
    auto y = plant.initialState({});
    Plant::State d;
    y.head<4>().setConstant(50);
    plant.setCommand({1, 1, 1, 1});
    for (const double current : {17.9, 18.0, 18.1}) {
      y.segment<4>(L::kCurrent).setConstant(current);
      plant(0, y, d);
      const double expected = plant.constants().hubs[0].motor.resistance * (18 - current) / 50e-6;
      QVERIFY(std::abs(d[L::kCurrent] - expected) < 1e-6 * (1 + std::abs(expected)));
    }
    y.head<4>().setConstant(900);
    plant.setCommand({0, 0, 0, 0});
    y.segment<4>(L::kCurrent).setConstant(-18);
    plant(0, y, d);
    QVERIFY(std::abs(d[L::kCurrent]) < 1e-6);
  }

  /// Sag couples the motors: one that draws more leaves the others less; charge and polarisation
  /// follow.
  void batterySags() {
    const BatteryParameters b{.charge = 0.5};
    VehicleParameters v = vehicle(PropellerCoefficients{});
    v.supply = b;
    Plant plant(buildMultirotor<4>(v, {}));
    auto y = plant.initialState({});
    Plant::State d;
    MultirotorForces<4> f;
    plant.setCommand({0.6, 0.6, 0.6, 0.6});
    y.segment<4>(L::kCurrent).setConstant(5);
    plant.derivativeAndForces(0, y, d, f);
    const double open = Supply(SupplyModel(b)).openCircuit(0.5), pack = 3 * b.resistance;
    QVERIFY(std::abs(f.supplyCurrent - 12) < 1e-12);
    QVERIFY(std::abs(f.busVoltage - (open - pack * 12)) < 1e-9);
    QVERIFY(std::abs(d[L::kPolarisation] - 3 * b.polarisation * 12 / b.polarisationTime) < 1e-12);
    const double before = f.voltage[0];
    y[L::kCurrent + 3] = 15;
    plant.derivativeAndForces(0, y, d, f);
    QVERIFY(std::abs(f.voltage[0] - (before - 0.6 * pack * 6)) < 1e-9);
    y[L::kCharge] = 0.25 * b.capacity;
    plant.derivativeAndForces(0, y, d, f);
    QVERIFY(std::abs(f.stateOfCharge - 0.25) < 1e-12);
    QVERIFY(f.busVoltage < Supply(SupplyModel(b)).openCircuit(0.25));
  }

  /// The exact Jacobian of the whole plant with each model against central differences.
  void jacobian_data() { addModels(); }
  void jacobian() {
    constexpr int kInputs = Plant::kStates + 4;
    using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, kInputs, 1>>;
    const Plant plant(buildMultirotor<4>(fetched(), {}));
    FlightStart start;
    start.velocity = {5, -3, 2};
    start.rates = {1, -2, 3};
    Eigen::Matrix<double, kInputs, 1> x;
    x << plant.initialState(start), 0.5, 0.6, 0.4, 0.7;
    const auto evaluate = [&](const auto& in) {
      using S = typename std::decay_t<decltype(in)>::Scalar;
      Plant::StateOf<S> y = in.template head<Plant::kStates>(), d;
      Plant::CommandOf<S> u = in.template tail<4>();
      plant.derivative<typename std::decay_t<decltype(u)>::Scalar>(0, u, y, d);
      return d;
    };
    Eigen::Matrix<Dual, kInputs, 1> dual;
    for (int k = 0; k < kInputs; ++k) dual[k] = Dual(x[k], kInputs, k);
    const Plant::StateOf<Dual> exact = evaluate(dual);
    for (int k = 0; k < kInputs; ++k) {
      const double step = 1e-5 * std::max(1.0, std::abs(x[k]));
      auto up = x, down = x;
      up[k] += step, down[k] -= step;
      const Plant::State difference = (evaluate(up) - evaluate(down)) / (2 * step);
      for (int i = 0; i < Plant::kStates; ++i) {
        const double error = std::abs(exact[i].derivatives()[k] - difference[i]);
        const double allowed = 1e-3 * std::abs(difference[i]) + 1e-4;
        QVERIFY2(error < allowed, qPrintable(QString("d(%1)/d(%2): %3 against %4")
                                                 .arg(i)
                                                 .arg(k)
                                                 .arg(exact[i].derivatives()[k])
                                                 .arg(difference[i])));
      }
    }
  }

  /// Rotors of different models fly together.
  void mixedRotors() {
    VehicleParameters v = vehicle(PropellerCoefficients{});
    const RotorParameters base = std::get<EqualRotors>(v.rotors).rotor;
    IndividualRotors rotors{std::vector<RotorParameters>(4, base)};
    rotors.rotors[1].aerodynamics = MeasuredPropeller{};
    rotors.rotors[2].aerodynamics = test::quickMap();
    v.rotors = rotors;
    const Plant plant(buildMultirotor<4>(v, {}));
    Plant::State d;
    plant(0, plant.initialState({}), d);
    QVERIFY(d.segment<3>(L::kVelocity).norm() < 1e-8);
    QVERIFY(d.segment<3>(L::kMomentum).head<2>().norm() < 1e-8);
  }
};

QTEST_APPLESS_MAIN(TestMultirotorModels)
#include "test_multirotor_models.moc"
