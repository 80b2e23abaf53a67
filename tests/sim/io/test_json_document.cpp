#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <limits>

#include "sim/core/schema_tree.h"
#include "sim/io/file.h"
#include "sim/io/json_document.h"
#include "tests/sim/core/sample_document.h"

using namespace rotorbench;
using sample::Document;

namespace {

std::string write(const Document& document) {
  return writeDocument(schema::ref(document));
}

Document titled(const char* title) {
  Document document;
  document.title = title;
  return document;
}

/// All messages, one per line; empty if the text is accepted.
QString faults(const std::string& text) {
  Document document = titled("before");
  try {
    readDocument(schema::ref(document), text, "a.json");
  } catch (const InputError& error) {
    if (document != titled("before")) return "the target was changed";
    return QString::fromUtf8(error.what());
  }
  return {};
}

std::string withHeader(const char* members) {
  return std::string("{\"rotorbench\": 1, ").append(members).append("}");
}

}  // namespace

class TestJsonDocument : public QObject {
  Q_OBJECT

 private slots:
  void writtenReadsBackEqual();
  void layout();
  void unitsAndDefaults();
  void faults_data();
  void faults();
  void everyProblemAtOnce();
  void limits_data();
  void limits();
  void notFiniteNumbersAreNotWritten();
  void files();
};

void TestJsonDocument::writtenReadsBackEqual() {
  Document document;
  document.title = "Quotes \" and \\ and \n and µ and \x01";
  document.controller = sample::Lqr{.weight = 0.1 + 0.2, .horizon = 3};
  document.vehicle.mass = 5e-324;
  document.gain = -0.0;
  document.low = -std::numeric_limits<double>::max();
  document.vehicle.rotors.resize(3);
  document.vehicle.rotors[2].blades.clear();
  document.seed = 9007199254740992;
  const std::string text = write(document);
  Document again;
  readDocument(schema::ref(again), text, "a.json");
  QVERIFY(again == document);
  QVERIFY(std::signbit(again.gain));
  QCOMPARE(write(again), text);
}

void TestJsonDocument::layout() {
  Document document;
  document.vehicle.rotors.resize(1);
  const char* expected = R"({
  "rotorbench": 1,
  "title": "Sample",
  "solver": "rk4",
  "wind": false,
  "steps": 1000,
  "seed": 1,
  "gain": 0.25,
  "low": 0,
  "high": 1,
  "vehicle": {
    "mass": 1.2,
    "diameter": 0.24003,
    "rotors": [
      {
        "name": "rotor",
        "speed": 100,
        "position": [0.1, 0, 0],
        "blades": [
          {"radius": 0.12, "twist": 0.1},
          {"radius": 0.05, "twist": 0.3}
        ]
      }
    ]
  },
  "controller": {
    "type": "pid",
    "kp": 1.5,
    "ki": 0
  }
}
)";
  QCOMPARE(QString::fromStdString(write(document)), QString(expected));
}

void TestJsonDocument::unitsAndDefaults() {
  Document document = titled("before");
  document.gain = 77;
  readDocument(schema::ref(document), R"({
    "rotorbench": 1,
    "vehicle": {"diameter": "9.45 in", "mass": "1/2 lb",
                "rotors": [{"position": ["10 cm", 0.2, "3 mm"]}]},
    "controller": {"weight": 4, "type": "lqr"}})",
               "a.json");
  QCOMPARE(document.title,
           std::string("Sample"));  // a missing key takes its default, not the old value
  QCOMPARE(document.gain, 0.25);
  QCOMPARE(document.vehicle.diameter, 9.45 * 0.0254);
  QCOMPARE(document.vehicle.mass, 0.45359237 / 2);
  QCOMPARE(document.vehicle.rotors.size(), std::size_t{1});
  QVERIFY(document.vehicle.rotors[0].position == Eigen::Vector3d(0.1, 0.2, 0.003));
  QCOMPARE(document.vehicle.rotors[0].name, std::string("rotor"));
  QVERIFY((document.controller == std::variant<sample::Pid, sample::Lqr>(sample::Lqr{4, 10})));
}

void TestJsonDocument::faults_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("message");
  const auto row = [](const char* name, const char* members, const char* message) {
    QTest::addRow("%s", name) << QByteArray::fromStdString(withHeader(members))
                              << "a.json: " + QString(message);
  };
  const auto file = [](const char* name, const QByteArray& text, const char* message) {
    QTest::addRow("%s", name) << text << "a.json: " + QString(message);
  };
  row("range", R"("vehicle": {"mass": -1})",
      "vehicle.mass: -1 kg is not allowed; must be above 0 and at most 100 kg");
  row("unknown key", R"("vehicle": {"mas": 1})",
      "vehicle.mas: this key is unknown; the nearest known key is mass");
  row("far key", R"("controller": {"type": "pid", "banana": 1})",
      "controller.banana: this key is unknown; must be one of type, kp, ki");
  row("wrong unit", R"("vehicle": {"mass": "3 m"})",
      "vehicle.mass: \"3 m\" is in m; must be a number in kg, g, lb, oz");
  row("no unit", R"("vehicle": {"mass": "3"})",
      "vehicle.mass: \"3\" has no unit; must be a number in kg, g, lb, oz");
  row("null", R"("gain": null)", "gain: null is not allowed; must be a number, any finite number");
  row("boolean for number", R"("gain": true)",
      "gain: true is not allowed; must be a number, any finite number");
  row("number for text", R"("title": 3)", "title: 3 is not text; must be text");
  row("number for boolean", R"("wind": 1)", "wind: 1 is not allowed; must be true or false");
  row("fraction", R"("steps": 2.5)",
      "steps: 2.5 is not a whole number; must be a whole number, at least 1 and at most 1e+06");
  row("choice", R"("solver": "RK4")",
      "solver: \"RK4\" is not allowed; must be one of euler, rk4, dopri5; nearest is rk4");
  row("list for group", R"("vehicle": [])",
      "vehicle: a list is not allowed; must be an object { ... }");
  row("object for list", R"("vehicle": {"rotors": {}})",
      "vehicle.rotors: an object is not allowed; must be a list [ ... ]");
  row("number in list", R"("vehicle": {"rotors": [7]})",
      "vehicle.rotors[0]: 7 is not allowed; must be an object { ... }");
  row("too few", R"("vehicle": {"rotors": []})",
      "vehicle.rotors: this list has 0 elements; must be 1 to 8");
  row("vector length", R"("vehicle": {"rotors": [{"position": [1, 2]}]})",
      "vehicle.rotors[0].position: this list has 2 elements; must be a list of 3 numbers");
  row("no type", R"("controller": {"kp": 1})",
      "controller.type: this key is missing; must be one of pid, lqr");
  row("type", R"("controller": {"type": "pdi"})",
      "controller.type: \"pdi\" is not allowed; must be one of pid, lqr; nearest is pid");
  row("doubled key", R"("gain": 1, "gain": 1)",
      "gain: this key is given twice; must be given once");
  row("doubled in list",
      R"("vehicle": {"rotors": [{}, {"speed": 1, "speed": [{"x": 1, "x": 2}]}]})",
      "vehicle.rotors[1].speed: this key is given twice; must be given once\na.json: "
      "vehicle.rotors[1].speed[0].x: this key is given twice; must be given once");
  row("rule", R"("low": 3)", "low: low is not below high; must be below high");
  row("underflow", R"("gain": 1e-999)", "gain: 1e-999 is too small for a number");
  file("no version", "{}",
       "rotorbench: the format version is missing; this program reads version 1");
  file("unknown version", R"({"rotorbench": 2, "x": 1})",
       "rotorbench: the format version 2 is unknown; this program reads version 1");
  file("text version", R"({"rotorbench": "1"})",
       "rotorbench: \"1\" is not a format version; this program reads version 1");
  file("fractional version", R"({"rotorbench": 1.5})",
       "rotorbench: 1.5 is not a format version; this program reads version 1");
  file("list", "[]", "the file is a list, not an object { ... }; this program reads version 1");
  file("empty", " \n", "the file is empty");
  file("binary",
       QByteArray("\x7F"
                  "ELF\x02\x01\xFF\xFE",
                  8),
       "this is not text in UTF-8: see line 1, column 7");
  file("zero byte", QByteArray("{\"rotorbench\": 1}\0{", 19),
       "this is not text: there is a zero byte at line 1, column 18");
}

void TestJsonDocument::faults() {
  QFETCH(QByteArray, text);
  QFETCH(QString, message);
  QCOMPARE(::faults(text.toStdString()), message);
}

void TestJsonDocument::everyProblemAtOnce() {
  const QString all =
      ::faults(withHeader(R"("gian": 1, "vehicle": {"mass": 0, "rotors": [{"spede": 1}, {}, 3]},
      "solver": "x", "low": 5, "controller": {"type": "lqr", "horizon": 100})"));
  QStringList paths;
  for (const QString& line : all.split('\n')) paths += line.section(": ", 1, 1);
  paths.sort();
  QCOMPARE(paths, QStringList({"controller.horizon", "gian", "low", "solver", "vehicle.mass",
                               "vehicle.rotors[0].spede", "vehicle.rotors[2]"}));
}

void TestJsonDocument::limits_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("part");
  QTest::addRow("truncated") << QByteArray("{\"rotorbench\": 1,\n \"gain\": ")
                             << "not valid JSON at line 2, column 10: ";
  QTest::addRow("NaN") << QByteArray::fromStdString(withHeader("\"gain\": NaN"))
                       << "NaN and Infinity are not numbers in JSON";
  QTest::addRow("Infinity") << QByteArray::fromStdString(withHeader("\"gain\": -Infinity"))
                            << "NaN and Infinity are not numbers in JSON";
  QTest::addRow("huge number") << QByteArray::fromStdString(withHeader("\"gain\": 1e999"))
                               << "the number is too large";
  QTest::addRow("comment") << QByteArray("{\"rotorbench\": 1} // x")
                           << "not valid JSON at line 1, column 19";
  QTest::addRow("deep") << QByteArray(100000, '[') << "nested more than 64 levels deep";
  QTest::addRow("deep inside") << QByteArray::fromStdString(withHeader("\"gain\": ")).chopped(1) +
                                      QByteArray(64, '[')
                               << "nested more than 64 levels deep";
  QTest::addRow("50 MB") << QByteArray(50'000'000, ' ')
                         << "the file is too large; must be at most 16 MiB";
  QTest::addRow("many values") << "[0" + QByteArray(",0").repeated(3'000'000) + "]"
                               << "more than 2000000 values";
  QByteArray keys = "{\"rotorbench\": 1";
  for (int i = 0; i < 200000; ++i) keys += ",\"key" + QByteArray::number(i) + "\":1";
  QTest::addRow("many unknown keys") << keys + "}"
                                     << "there are more problems than are listed here";
  QTest::addRow("many rotors") << "{\"rotorbench\": 1, \"vehicle\": {\"rotors\": [{}" +
                                      QByteArray(",{}").repeated(900'000) + "]}}"
                               << "this list has 900001 elements; must be 1 to 8";
}

void TestJsonDocument::limits() {
  QFETCH(QByteArray, text);
  QFETCH(QString, part);
  QElapsedTimer timer;
  timer.start();
  const QString message = ::faults(text.toStdString());
  QVERIFY2(message.contains(part), qPrintable(message.left(500)));
  QVERIFY(timer.elapsed() < 20000);  // no hang, also with sanitizers
}

void TestJsonDocument::notFiniteNumbersAreNotWritten() {
  Document document;
  document.vehicle.rotors[1].position.y() = std::numeric_limits<double>::quiet_NaN();
  try {
    write(document);
    QFAIL("NaN was written");
  } catch (const InputError& error) {
    QCOMPARE(error.problems().front().path, std::string("vehicle.rotors[1].position"));
  }
}

void TestJsonDocument::files() {
  const QTemporaryDir directory;
  const std::filesystem::path folder = directory.path().toStdString();
  const auto file = folder / "a.json";
  const auto messageOf = [](const auto& act) {
    try {
      act();
    } catch (const InputError& error) {
      return error.problems().front().message();
    }
    return std::string();
  };
  writeFileAtomically(file, "first");
  writeFileAtomically(file, "second");
  QCOMPARE(readTextFile(file, 100), std::string("second"));
  QCOMPARE(messageOf([&] { (void)readTextFile(folder / "b", 100); }),
           std::string("there is no such file"));
  QCOMPARE(messageOf([&] { (void)readTextFile(folder, 100); }),
           std::string("this is a folder; must be a file"));
  QCOMPARE(messageOf([&] { (void)readTextFile(file, 5); }),
           std::string("the file is too large; must be at most 0 MiB"));
  QCOMPARE(messageOf([&] { writeFileAtomically(folder, "x"); }),
           std::string("this is a folder; must be a file"));
  QVERIFY(messageOf([&] {
            writeFileAtomically(folder / "no" / "a", "x");
          }).starts_with("the file cannot be written"));
  // A writer that fails leaves the old content and no litter.
  QVERIFY_THROWS_EXCEPTION(std::runtime_error, writeFileAtomically(file, [](std::ostream& out) {
                             out << "half";
                             throw std::runtime_error("stop");
                           }));
  QCOMPARE(readTextFile(file, 100), std::string("second"));
  std::filesystem::create_symlink(file, folder / "link");
  writeFileAtomically(folder / "link", "third");
  QVERIFY(std::filesystem::is_symlink(folder / "link"));
  QCOMPARE(readTextFile(file, 100), std::string("third"));
  QCOMPARE(std::distance(std::filesystem::directory_iterator(folder), {}), std::ptrdiff_t{2});
}

QTEST_GUILESS_MAIN(TestJsonDocument)
#include "test_json_document.moc"
