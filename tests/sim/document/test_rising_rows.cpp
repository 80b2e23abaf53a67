// Lists whose rows must come in order: each that there is names the row in the wrong place, and its
// help says the rule.
#include <QtTest>

#include "sim/core/rising.h"
#include "sim/core/schema_tree.h"
#include "sim/document/controlled_inputs.h"
#include "sim/document/motor_bench.h"
#include "sim/document/motor_speed_run.h"
#include "sim/document/propeller_bench.h"
#include "sim/document/thrust_stand.h"
#include "sim/propulsion/drive/battery.h"
#include "sim/propulsion/rotor/blade.h"
#include "sim/propulsion/rotor/polar_section.h"

using namespace rotorbench;

namespace {

struct Row {
  double place = 0;
};

struct Sample {
  std::vector<Row> rows;
};

/// The messages about an object one of whose lists has its rows in the wrong order.
struct Judged {
  QStringList messages;
  QString help;
};

template <class T>
Judged judged(const T& object, const char* list) {
  Judged found;
  for (const Problem& problem : schema::validate(schema::ref(object)))
    found.messages += QString::fromStdString(problem.message());
  for (const schema::Field& field : schema::typeOf<T>().fields)
    if (field.key == list) found.help = QString::fromStdString(field.help);
  return found;
}

/// With the first two rows of a list in each other's place.
template <class T, class Element>
Judged swapped(std::vector<Element> T::*rows, const char* list, std::vector<Element> content) {
  T object;
  std::swap(content.at(0), content.at(1));
  object.*rows = std::move(content);
  return judged(object, list);
}

}  // namespace

template <>
struct rotorbench::Describe<Row> {
  static void fields(schema::Builder<Row>& b) {
    b.title("row", "Row", "");
    b.number("place", &Row::place, "Place", "", "1");
  }
};
template <>
struct rotorbench::Describe<Sample> {
  static void fields(schema::Builder<Sample>& b) {
    b.title("sample", "Sample", "");
    schema::risingList(b, "rows", &Sample::rows, "Rows", &Row::place, {"place", "places"}, "Any.");
  }
};

Q_DECLARE_METATYPE(Judged)

class TestRisingRows : public QObject {
  Q_OBJECT
 private slots:
  /// Rows that fall or stay where they are, wherever they stand; one row and none are in order.
  void everyRowInTheWrongPlaceIsNamed() {
    const QString rule = ": is not above the row before; places must rise from row to row";
    const QStringList expected{"rows[2].place" + rule, "rows[4].place" + rule};
    QCOMPARE(judged(Sample{{{0}, {2}, {1}, {3}, {3}, {4}}}, "rows").messages, expected);
    QCOMPARE(judged(Sample{{{-1}, {0}, {1e-300}}}, "rows").messages, QStringList());
    QCOMPARE(judged(Sample{{{5}}}, "rows").messages, QStringList());
    QCOMPARE(judged(Sample{}, "rows").messages, QStringList());
    QCOMPARE(judged(Sample{}, "rows").help, "Any. Places must rise from row to row.");
  }

  /// The sentences as a person reads them. Of each list the two rows are in order but for the swap.
  void listsSayWhatMustRise_data() {
    QTest::addColumn<Judged>("found");
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("column");
    QTest::addColumn<QString>("beyond");
    const auto row = [](const char* name, const Judged& found, const char* path, const char* column,
                        const char* beyond = "above") {
      QTest::addRow("%s", name) << found << path << column << beyond;
    };
    row("motor bench", swapped(&MotorBench::throttle, "throttle", {{0, 0}, {1, 0.5}}),
        "throttle[1].time", "times", "later than");
    row("thrust stand", swapped(&ThrottleRows::rows, "rows", {{0, 0}, {1, 0.5}}), "rows[1].time",
        "times", "later than");
    row("motor speeds", swapped(&MotorSpeedRun::setPoints, "setPoints", {{0, 0}, {1, 100}}),
        "setPoints[1].time", "times", "later than");
    row("set-points", swapped(&ControlledInputs::setPoints, "setPoints", {{0}, {1}}),
        "setPoints[1].time", "times", "later than");
    row("propeller speeds", swapped(&PropellerBench::speeds, "speeds", {{0, 0}, {1, 100}}),
        "speeds[1].time", "times", "later than");
    row("air speeds", swapped(&StreamProfile::rows, "rows", {{0, 0}, {1, 10}}), "rows[1].time",
        "times", "later than");
    row("cells", swapped(&BatteryParameters::openCircuit, "openCircuit", {{0, 3.7}, {1, 3.7}}),
        "openCircuit[1].charge", "charges");
    row("stations",
        swapped(&PropellerGeometry::stations, "stations", {{0.2, 0.1, 0.3}, {1, 0.1, 0.2}}),
        "stations[1].radius", "radii");
    row("sections", swapped(&PropellerGeometry::sections, "sections", {{0.2, {}}, {1, {}}}),
        "sections[1].radius", "radii");
    row("polar", swapped(&Polar::points, "points", {{-0.1, 0, 0.01}, {0.1, 1, 0.02}}),
        "points[1].alpha", "angles of attack");
  }
  void listsSayWhatMustRise() {
    QFETCH(Judged, found);
    QFETCH(QString, path);
    QFETCH(QString, column);
    QFETCH(QString, beyond);
    const QString rule = column + " must rise from row to row";
    QCOMPARE(found.messages, QStringList(path + ": is not " + beyond + " the row before; " + rule));
    QVERIFY2(found.help.endsWith(rule.mid(1) + "."), qPrintable(found.help));
  }
};

QTEST_GUILESS_MAIN(TestRisingRows)
#include "test_rising_rows.moc"
