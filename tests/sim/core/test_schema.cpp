#include <QTest>
#include <limits>

#include "sim/core/schema_tree.h"
#include "tests/sim/core/sample_document.h"

using namespace rotorbench;
using sample::Document;

namespace {

QString faultOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return QString::fromUtf8(error.what());
  }
  return "no error";
}

QString shown(const Document& document, const char* path) {
  Document copy = document;
  const auto location = schema::locate(schema::ref(copy), path);
  return QString::fromStdString(
      schema::toText(*location.field, location.field->read(location.owner)));
}

}  // namespace

class TestSchema : public QObject {
  Q_OBJECT

 private slots:
  void setFromText_data();
  void setFromText();
  void faults_data();
  void faults();
  void componentsOfVectors();
  void variants();
  void locations();
  void notFiniteNumbersAreRejected_data();
  void notFiniteNumbersAreRejected();
  void wrongKinds();
  void integersKeepToTheirMember();
  void validateReportsAll();
  void walkVisitsInOrder();
  void compareListsDifferences();
  void copyMakesEqual();
  void rangeSentences_data();
  void rangeSentences();
  void nearest_data();
  void nearest();
};

void TestSchema::setFromText_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("expected");
  QTest::addRow("number in SI") << "vehicle.mass"
                                << "0.25"
                                << "0.25 kg";
  QTest::addRow("number with unit") << "vehicle.mass"
                                    << "250 g"
                                    << "0.25 kg";
  QTest::addRow("shown in inches") << "vehicle.diameter"
                                   << "25.4 cm"
                                   << "10 in";
  QTest::addRow("speed") << "vehicle.rotors[1].speed"
                         << "3000 rpm"
                         << "3000 rpm";
  QTest::addRow("boolean") << "wind"
                           << "true"
                           << "on";
  QTest::addRow("boolean word") << "wind"
                                << "No"
                                << "off";
  QTest::addRow("choice key") << "solver"
                              << "dopri5"
                              << "RK5(4)7M";
  QTest::addRow("choice label") << "solver"
                                << "rk5(4)7m"
                                << "RK5(4)7M";
  QTest::addRow("integer") << "steps"
                           << "12"
                           << "12";
  QTest::addRow("integer with exponent") << "steps"
                                         << "1e3"
                                         << "1000";
  QTest::addRow("text") << "title"
                        << "Über 3 m"
                        << "Über 3 m";
  QTest::addRow("vector") << "vehicle.rotors[0].position"
                          << "[1, 2.5, -3]"
                          << "[1, 2.5, -3] m";
  QTest::addRow("vector with unit") << "vehicle.rotors[0].position"
                                    << "[10, 20, 30] cm"
                                    << "[0.1, 0.2, 0.3] m";
  QTest::addRow("vector with units") << "vehicle.rotors[0].position"
                                     << "1 cm; 2 mm; 3"
                                     << "[0.01, 0.002, 3] m";
  QTest::addRow("table row") << "vehicle.rotors[0].blades[1].twist"
                             << "15°"
                             << "15 deg";
  QTest::addRow("alternative member") << "controller.kp"
                                      << "3"
                                      << "3";
}

void TestSchema::setFromText() {
  QFETCH(QString, path);
  QFETCH(QString, text);
  QFETCH(QString, expected);
  Document document;
  const std::string where = path.toStdString();
  schema::setFromText(schema::ref(document), where, text.toStdString());
  QCOMPARE(shown(document, where.c_str()), expected);
  // What is shown, typed again, is the same document.
  Document again;
  if (path != "title") schema::setFromText(schema::ref(again), where, expected.toStdString());
  if (path != "title") QVERIFY(again == document);
}

void TestSchema::faults_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("sentence");
  QTest::addRow("range")
      << "vehicle.mass"
      << "-1"
      << "vehicle.mass: -1 kg is not allowed; must be above 0 and at most 100 kg";
  QTest::addRow("range in the shown unit")
      << "vehicle.rotors[0].blades[0].radius"
      << "-1 mm"
      << "vehicle.rotors[0].blades[0].radius: -0.1 cm is not allowed; must be above 0 cm";
  QTest::addRow("unit") << "vehicle.mass"
                        << "1 m"
                        << "vehicle.mass: \"1 m\" is in m; must be a number in kg, g, lb, oz";
  QTest::addRow("key") << "vehicle.mas"
                       << "1"
                       << "vehicle.mas: there is no such parameter; the nearest is vehicle.mass";
  QTest::addRow("swapped letters") << "vehicel.mass"
                                   << "1"
                                   << "vehicel: there is no such parameter; the nearest is vehicle";
  QTest::addRow("other alternative")
      << "controller.weight"
      << "1"
      << "controller.weight: there is no such parameter; it belongs to "
         "controller.type = lqr";
  QTest::addRow("element") << "vehicle.rotors[2].speed"
                           << "1"
                           << "vehicle.rotors: there is no element 2; the elements are 0 to 1";
  QTest::addRow("shape")
      << "vehicle..mass"
      << "1"
      << "vehicle..mass: this is not a path to a parameter; paths look like vehicle.rotors[2].arm";
  QTest::addRow("index")
      << "vehicle.rotors[x].speed"
      << "1"
      << "vehicle.rotors[x].speed: this is not a path to a parameter; paths look like "
         "vehicle.rotors[2].arm";
  QTest::addRow("empty") << ""
                         << "1"
                         << "the path is empty; paths look like vehicle.rotors[2].arm";
  QTest::addRow("group") << "vehicle"
                         << "1"
                         << "vehicle: this is not a single value; name one of its members";
  QTest::addRow("member of a number")
      << "gain.x"
      << "1"
      << "gain.x: there is no such parameter; gain is a single value";
  QTest::addRow("choice")
      << "solver"
      << "rk5"
      << "solver: \"rk5\" is not allowed; must be one of euler, rk4, dopri5; nearest is rk4";
  QTest::addRow("alternative")
      << "controller.type"
      << "pidd"
      << "controller.type: \"pidd\" is not allowed; must be one of pid, lqr; nearest is pid";
  QTest::addRow("boolean") << "wind"
                           << "strong"
                           << "wind: \"strong\" is not allowed; must be true or false";
  QTest::addRow("fraction")
      << "steps"
      << "2.5"
      << "steps: \"2.5\" is not a whole number; must be at least 1 and at most 1e+06";
  QTest::addRow("vector length")
      << "vehicle.rotors[0].position"
      << "[1, 2]"
      << "vehicle.rotors[0].position: this has 2 numbers; must be 3 numbers";
  QTest::addRow("component")
      << "vehicle.rotors[0].position"
      << "[1, 2, 11]"
      << "vehicle.rotors[0].position.z: 11 m is not allowed; must be at least -10 and at "
         "most 10 m";
}

void TestSchema::faults() {
  QFETCH(QString, path);
  QFETCH(QString, text);
  QFETCH(QString, sentence);
  Document document;
  const auto act = [&] {
    schema::setFromText(schema::ref(document), path.toStdString(), text.toStdString());
  };
  QCOMPARE(faultOf(act), sentence);
  QVERIFY(document == Document());
}

void TestSchema::componentsOfVectors() {
  Document document;
  schema::setFromText(schema::ref(document), "vehicle.rotors[1].position.z", "9 in");
  QCOMPARE(document.vehicle.rotors[1].position.z(), 9 * 0.0254);
  schema::set(schema::ref(document), "vehicle.rotors[1].position[0]", 2.5);
  QCOMPARE(document.vehicle.rotors[1].position.x(), 2.5);
  QCOMPARE(std::get<double>(schema::get(schema::ref(document), "vehicle.rotors[1].position.x")),
           2.5);
  QCOMPARE(
      faultOf(
          [&] { schema::setFromText(schema::ref(document), "vehicle.rotors[1].position.w", "1"); }),
      QString(
          "vehicle.rotors[1].position.w: there is no such component; the components are x, y, z"));
}

void TestSchema::variants() {
  Document document;
  const auto root = schema::ref(document);
  QCOMPARE(std::get<std::string>(schema::get(root, "controller.type")), std::string("pid"));
  schema::setFromText(root, "controller.type", "lqr");
  QVERIFY(std::holds_alternative<sample::Lqr>(document.controller));
  schema::set(root, "controller.horizon", std::int64_t{5});
  QCOMPARE(std::get<sample::Lqr>(document.controller).horizon, 5);
  schema::set(root, "controller.type", std::string("lqr"));  // choosing it again changes nothing
  QCOMPARE(std::get<sample::Lqr>(document.controller).horizon, 5);
}

void TestSchema::locations() {
  Document document;
  const auto element = schema::locate(schema::ref(document), "vehicle.rotors[1]");
  QCOMPARE(element.path, std::string("vehicle.rotors[1]"));
  QCOMPARE(element.element.value_or(99), std::size_t{1});
  QVERIFY(element.field->kind == schema::Kind::List);
  QCOMPARE(element.owner, static_cast<void*>(&document.vehicle));
  const auto leaf = schema::locate(schema::ref(document), "vehicle.rotors[1].speed");
  QCOMPARE(leaf.owner, static_cast<void*>(&document.vehicle.rotors[1]));
  QVERIFY(!leaf.element);
}

void TestSchema::notFiniteNumbersAreRejected_data() {
  QTest::addColumn<double>("value");
  QTest::addRow("NaN") << std::numeric_limits<double>::quiet_NaN();
  QTest::addRow("infinity") << std::numeric_limits<double>::infinity();
  QTest::addRow("minus infinity") << -std::numeric_limits<double>::infinity();
}

void TestSchema::notFiniteNumbersAreRejected() {
  QFETCH(double, value);
  Document document;
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(schema::ref(document), "gain", value));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(schema::ref(document), "steps", value));
  QVERIFY_THROWS_EXCEPTION(
      InputError, schema::set(schema::ref(document), "vehicle.rotors[0].position.x", value));
  QVERIFY(document == Document());
  document.gain = value;
  QCOMPARE(schema::validate(schema::ref(std::as_const(document))).size(), std::size_t{1});
}

void TestSchema::wrongKinds() {
  Document document;
  const auto root = schema::ref(document);
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "gain", true));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "gain", std::string("1")));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "wind", 1.0));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "title", 1.0));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "solver", std::int64_t{1}));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "controller.type", 1.0));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "vehicle.rotors", 1.0));
  QVERIFY_THROWS_EXCEPTION(InputError, schema::set(root, "title", std::string("\xFF")));
  QVERIFY(document == Document());
  schema::set(root, "gain", std::int64_t{3});
  QCOMPARE(document.gain, 3.0);
  schema::set(root, "steps", 3.0);
  QCOMPARE(document.steps, 3);
}

void TestSchema::integersKeepToTheirMember() {
  const auto* field = schema::typeOf<sample::Document>().field("seed");
  QVERIFY(field->range.contains(0) && field->range.contains(9007199254740992.0) &&
          !field->range.contains(-1));
  Document document;
  schema::set(schema::ref(document), "seed", std::int64_t{9007199254740992});
  QCOMPARE(document.seed, std::uint64_t{9007199254740992});
  QVERIFY_THROWS_EXCEPTION(InputError,
                           schema::set(schema::ref(document), "steps", std::int64_t{1} << 32));
}

void TestSchema::validateReportsAll() {
  Document document;
  QVERIFY(schema::validate(schema::ref(std::as_const(document))).empty());
  document.vehicle.mass = 0;
  document.vehicle.rotors[1].blades[0].radius = -1;
  document.vehicle.rotors.resize(9);
  document.low = 2;
  document.title = std::string(1, static_cast<char>(0xC3));
  QStringList paths;
  for (const Problem& problem : schema::validate(schema::ref(std::as_const(document)))) {
    paths += QString::fromStdString(problem.path);
  }
  QCOMPARE(paths, QStringList({"title", "vehicle.mass", "vehicle.rotors",
                               "vehicle.rotors[1].blades[0].radius", "low"}));
}

void TestSchema::walkVisitsInOrder() {
  Document document;
  document.vehicle.rotors.resize(1);
  document.vehicle.rotors[0].blades.resize(1);
  QStringList paths;
  schema::walk(schema::ref(std::as_const(document)),
               [&](const std::string& path, const schema::Field&, const void*) {
                 paths += QString::fromStdString(path);
               });
  QCOMPARE(paths.join(' '),
           QString("title solver wind steps seed gain low high vehicle vehicle.mass "
                   "vehicle.diameter vehicle.rotors "
                   "vehicle.rotors[0].name vehicle.rotors[0].speed vehicle.rotors[0].position "
                   "vehicle.rotors[0].blades vehicle.rotors[0].blades[0].radius "
                   "vehicle.rotors[0].blades[0].twist controller controller.kp controller.ki"));
}

void TestSchema::compareListsDifferences() {
  const Document left;
  Document right;
  QVERIFY(schema::compare(schema::ref(left), schema::ref(std::as_const(right))).empty());
  right.wind = true;
  right.high = 0.5;
  right.controller = sample::Lqr{};
  right.vehicle.rotors.resize(1);
  right.vehicle.rotors[0].blades.clear();
  QStringList lines;
  for (const auto& d : schema::compare(schema::ref(left), schema::ref(std::as_const(right)))) {
    lines += QString::fromStdString(d.path + ": " + d.left + " | " + d.right);
  }
  QVERIFY(lines.contains("wind: off | on"));
  QVERIFY(lines.contains("high: 1000 ms | 500 ms"));
  QVERIFY(lines.contains("controller.type: PID | LQR"));
  QVERIFY(lines.contains("controller.kp: 1.5 | —"));
  QVERIFY(lines.contains("controller.horizon: — | 10"));
  QVERIFY(lines.contains("vehicle.rotors[0].blades[0].radius: 12 cm | —"));
  QVERIFY(lines.contains("vehicle.rotors[1].name: second | —"));
  // 2 leaves, type, 2 + 2 of the controllers, 2 rows of 2, the second rotor with 3 leaves and 2
  // rows of 2.
  QCOMPARE(lines.size(), 2 + 1 + 4 + 4 + 7);
}

void TestSchema::copyMakesEqual() {
  Document from;
  from.controller = sample::Lqr{3, 7};
  from.vehicle.rotors.resize(5);
  from.vehicle.rotors[4].blades = {{0.1, 0.2}};
  from.title = "copied";
  Document to;
  schema::copy(schema::ref(std::as_const(from)), schema::ref(to));
  QVERIFY(to == from);
}

void TestSchema::rangeSentences_data() {
  using namespace schema;
  QTest::addColumn<double>("low");
  QTest::addColumn<bool>("lowOpen");
  QTest::addColumn<double>("high");
  QTest::addColumn<bool>("highOpen");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<QString>("sentence");
  const double inf = std::numeric_limits<double>::infinity();
  QTest::addRow("both") << 0.0 << true << 10.0 << false << "m"
                        << "above 0 and at most 10 m";
  QTest::addRow("converted") << 0.0 << false << 0.254 << true << "in"
                             << "at least 0 and below 10 in";
  QTest::addRow("low") << 0.5 << false << inf << true << "cm"
                       << "at least 50 cm";
  QTest::addRow("high") << -inf << true << 1.0 << true << "m"
                        << "below 1 m";
  QTest::addRow("none") << -inf << true << inf << true << "m"
                        << "any finite number";
}

void TestSchema::rangeSentences() {
  QFETCH(double, low);
  QFETCH(bool, lowOpen);
  QFETCH(double, high);
  QFETCH(bool, highOpen);
  QFETCH(QString, unit);
  QFETCH(QString, sentence);
  const schema::Range range{{low, lowOpen}, {high, highOpen}};
  QCOMPARE(QString::fromStdString(range.sentence("m", unit.toStdString())), sentence);
  QCOMPARE(range.contains(low), !lowOpen);
  QCOMPARE(range.contains(high), !highOpen);
}

void TestSchema::nearest_data() {
  QTest::addColumn<QString>("word");
  QTest::addColumn<QString>("found");
  QTest::addRow("letter left out") << "resistnce"
                                   << "resistance";
  QTest::addRow("swap of neighbours") << "msas"
                                      << "mass";
  QTest::addRow("case") << "Mass"
                        << "mass";
  QTest::addRow("letter too many") << "masss"
                                   << "mass";
  QTest::addRow("nothing near") << "banana"
                                << "";
  QTest::addRow("empty") << ""
                         << "";
  QTest::addRow("no letter alike") << "kq"
                                   << "";
}

void TestSchema::nearest() {
  QFETCH(QString, word);
  QFETCH(QString, found);
  const auto near = schema::nearest(word.toStdString(), {"resistance", "mass", "inductance"});
  QCOMPARE(QString::fromStdString(near.value_or("")), found);
}

QTEST_GUILESS_MAIN(TestSchema)
#include "test_schema.moc"
