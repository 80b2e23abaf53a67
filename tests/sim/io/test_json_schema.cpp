#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "sim/io/file.h"
#include "sim/io/json_document.h"
#include "sim/io/json_schema.h"
#include "tests/sim/core/sample_document.h"

using namespace rotorbench;
using sample::Document;

namespace {

// Checks the schema itself against its draft, then the file against the schema.
constexpr const char* kValidate = R"(
import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
jsonschema.Draft202012Validator.check_schema(schema)
errors = list(jsonschema.Draft202012Validator(schema).iter_errors(json.load(open(sys.argv[2]))))
print(len(errors))
)";

}  // namespace

/// The judge is Debian's python3-jsonschema, which knows nothing of this program.
class TestJsonSchema : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void validatorAgreesWithReader_data();
  void validatorAgreesWithReader();

 private:
  QTemporaryDir directory_;
  QString path(const char* name) const { return directory_.filePath(name); }
};

void TestJsonSchema::initTestCase() {
  QProcess python;
  python.start("/usr/bin/python3", {"-c", "import jsonschema"});
  QVERIFY2(python.waitForFinished() && python.exitCode() == 0, "install python3-jsonschema");
  writeFileAtomically(path("schema.json").toStdString(), jsonSchema(schema::typeOf<Document>()));
}

void TestJsonSchema::validatorAgreesWithReader_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<bool>("valid");
  const Document plain;
  QTest::addRow("written") << QString::fromStdString(writeDocument(schema::ref(plain))) << true;
  const auto row = [](const char* members, bool valid) {
    QTest::addRow("%s", members) << QString("{\"rotorbench\": 1%1}").arg(members) << valid;
  };
  row("", true);
  row(R"(, "vehicle": {"diameter": "9.45 in"})", true);
  row(R"(, "vehicle": {"diameter": "9,45 in"})", true);
  row(R"(, "vehicle": {"diameter": "9.45 kg"})", false);
  row(R"(, "vehicle": {"diameter": "9.45"})", false);
  row(R"(, "gain": "25 %")", true);
  row(R"(, "vehicle": {"mass": 0})", false);
  row(R"(, "vehicle": {"mass": 100})", true);
  row(R"(, "vehicle": {"mass": 100.5})", false);
  row(R"(, "vehicle": {"mas": 1})", false);
  row(R"(, "steps": 2.5)", false);
  row(R"(, "seed": -1)", false);
  row(R"(, "wind": 1)", false);
  row(R"(, "solver": "dopri5")", true);
  row(R"(, "solver": "RK4")", false);
  row(R"(, "controller": {"type": "lqr", "horizon": 5})", true);
  row(R"(, "controller": {"type": "lqr", "kp": 5})", false);
  row(R"(, "controller": {"kp": 5})", false);
  row(R"(, "controller": {"type": "pdi"})", false);
  row(R"(, "vehicle": {"rotors": []})", false);
  row(R"(, "vehicle": {"rotors": [{"position": [1, "2 cm", 3]}]})", true);
  row(R"(, "vehicle": {"rotors": [{"position": [1, 2]}]})", false);
  row(R"(, "vehicle": {"rotors": [{"position": [1, 2, 11]}]})", false);
  row(R"(, "vehicle": {"rotors": [{"blades": [{"radius": "10 cm"}]}]})", true);
  row(R"(, "title": null)", false);
  QTest::addRow("no version") << "{}" << false;
  QTest::addRow("version 2") << R"({"rotorbench": 2})" << false;
}

void TestJsonSchema::validatorAgreesWithReader() {
  QFETCH(QString, text);
  QFETCH(bool, valid);
  bool read = true;
  try {
    Document document;
    readDocument(schema::ref(document), text.toStdString(), "a.json");
  } catch (const InputError&) {
    read = false;
  }
  QCOMPARE(read, valid);
  writeFileAtomically(path("a.json").toStdString(), text.toStdString());
  QProcess python;
  python.start("/usr/bin/python3", {"-c", kValidate, path("schema.json"), path("a.json")});
  QVERIFY(python.waitForFinished());
  const QString output = python.readAllStandardOutput().trimmed();
  QVERIFY2(python.exitCode() == 0, python.readAllStandardError());
  QCOMPARE(output == "0", valid);
}

QTEST_GUILESS_MAIN(TestJsonSchema)
#include "test_json_schema.moc"
