// The solver's parameters as files and forms see them.
#include <QtTest>
#include <set>
#include <string>

#include "sim/ode/solver_settings.h"

using namespace rotorbench;
using namespace rotorbench::ode;

class TestOdeSettings : public QObject {
  Q_OBJECT
 private slots:
  void namesAndKeys() {
    // The names of the published tables and the keys of experiment files.
    const char* names[] = {"Euler",    "RK4",      "ABM4",           "RK5(4)7M",
                           "RK5(4)6M", "RK5(4)7S", "Exponential RK4"};
    const char* keys[] = {"euler", "rk4", "abm4", "rk547m", "rk546m", "rk547s", "exponential-rk4"};
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
      QCOMPARE(static_cast<std::size_t>(kMethods[i].method), i);
      QCOMPARE(name(kMethods[i].method), std::string_view(names[i]));
      QCOMPARE(key(kMethods[i].method), std::string_view(keys[i]));
    }
  }
  void describedOnce() {
    const schema::Type& type = schema::typeOf<SolverSettings>();
    std::set<std::string> seen;
    for (const schema::Field& f : type.fields) {
      QVERIFY2(seen.insert(f.key).second, f.key.c_str());
      QVERIFY2(!f.label.empty(), f.key.c_str());
    }
    for (const char* k : {"method", "step", "errorControl", "initialStep", "minimumStep",
                          "maximumStep", "maximumSteps"}) {
      QVERIFY2(seen.contains(k), k);
    }
  }
  void defaultsAreInRange() {
    const SolverSettings settings;
    for (const schema::Field& f : schema::typeOf<SolverSettings>().fields) {
      if (f.kind != schema::Kind::Number) continue;
      QVERIFY2(f.range.contains(std::get<double>(f.read(&settings))), f.key.c_str());
    }
  }
  void writtenAndRead() {
    SolverSettings settings;
    const schema::Type& type = schema::typeOf<SolverSettings>();
    const schema::Field& method = *type.field("method");
    for (const MethodInfo& m : kMethods) {
      method.write(&settings, std::string(m.key));
      QCOMPARE(settings.method, m.method);
      QCOMPARE(std::get<std::string>(method.read(&settings)), std::string(m.key));
    }
    const schema::Field& control = *type.field("errorControl");
    QCOMPARE(control.options.size(), std::size_t{2});
    control.choose(&settings, 1);
    const schema::Type& thesis = control.childType(&settings, 0);
    QCOMPARE(thesis.key, std::string("thesis-2014"));
    thesis.field("tolerance")->write(control.child(&settings, 0), 0.25);
    QCOMPARE(std::get<ThesisErrorControl>(settings.errorControl).tolerance, 0.25);
    QVERIFY(!(settings == SolverSettings{}));
  }
  void contradictoryStepsAreReported() {
    SolverSettings settings;
    settings.maximumStep = 0.01;
    settings.minimumStep = 0.1;
    settings.initialStep = 0.1;
    std::vector<Problem> problems;
    for (const auto& check : schema::typeOf<SolverSettings>().checks) check(&settings, problems);
    QCOMPARE(problems.size(), std::size_t{2});
    QCOMPARE(problems[0].path, std::string("minimumStep"));
    QCOMPARE(problems[1].path, std::string("initialStep"));
  }
};

QTEST_APPLESS_MAIN(TestOdeSettings)
#include "test_ode_settings.moc"
