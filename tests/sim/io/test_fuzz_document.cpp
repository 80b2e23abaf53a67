#include <QElapsedTimer>
#include <QTest>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/io/csv.h"
#include "sim/io/json_document.h"
#include "sim/io/json_value.h"
#include "tests/sim/core/sample_document.h"
#include "tests/sim/io/mutator.h"

using namespace rotorbench;
using sample::Document;

namespace {

constexpr int kMutations = 30'000;

/// Numbers the JSON tree holds, however they are nested.
std::size_t countLeaves(const JsonValue& json) {
  std::size_t count = 0;
  if (const auto* array = json.array()) {
    for (const auto& item : *array) count += countLeaves(item);
  } else if (const auto* object = json.object()) {
    for (const auto& entry : *object) count += countLeaves(entry.value);
  } else {
    count = 1;
  }
  return count;
}

std::vector<std::string> seedTexts() {
  Document plain;
  Document rich;
  rich.controller = sample::Lqr{};
  rich.vehicle.rotors.resize(4);
  rich.wind = true;
  return {
      writeDocument(schema::ref(std::as_const(plain))),
      writeDocument(schema::ref(std::as_const(rich))),
      R"({"rotorbench": 1, "vehicle": {"diameter": "9.45 in", "rotors": [{"speed": "3000 rpm"}]}})",
      R"({"rotorbench": 1, "controller": {"kp": 2, "type": "pid"}, "steps": 7})"};
}

}  // namespace

class TestFuzzDocument : public QObject {
  Q_OBJECT

 private slots:
  void mutatedDocuments();
  void mutatedTables();
};

/// Every damaged file is either refused with sentences, leaving the target alone, or says what the
/// document then holds: valid, written and read back the same, and no value of the file left out.
void TestFuzzDocument::mutatedDocuments() {
  Mutator mutator(2014);
  const auto seeds = seedTexts();
  Document untouched;
  untouched.title = "untouched";
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string text = mutator.mutate(seeds[mutator.below(seeds.size())]);
    Document document = untouched;
    try {
      readDocument(schema::ref(document), text, "fuzz.json");
    } catch (const InputError& error) {
      QVERIFY(!error.problems().empty());
      QVERIFY(document == untouched);
      QVERIFY(!findInvalidUtf8(error.what()));
      continue;
    }
    ++accepted;
    QVERIFY(schema::validate(schema::ref(std::as_const(document))).empty());
    const std::string written = writeDocument(schema::ref(std::as_const(document)));
    Document again;
    readDocument(schema::ref(again), written, "again.json");
    QVERIFY2(again == document, text.c_str());
    QCOMPARE(writeDocument(schema::ref(std::as_const(again))), written);
    std::vector<Problem> problems;
    const JsonValue given = parseJson(text, "given", problems);
    QVERIFY2(countLeaves(given) <= countLeaves(parseJson(written, "written", problems)),
             text.c_str());
    QVERIFY(problems.empty());
  }
  qInfo("%d of %d damaged documents were still valid", accepted, kMutations);
  QVERIFY(accepted > kMutations / 100);  // else the mutations are too coarse to test anything
  QVERIFY(accepted < kMutations * 3 / 4);
}

void TestFuzzDocument::mutatedTables() {
  Mutator mutator(1901);
  const std::vector<std::string> seeds{
      "time [s],rotor1 [rpm],rotor2 [rpm]\n0,3000,3000\n0.5,3100,2900.5\n1,3200,2800\n",
      "\"time [s]\";\"a;b [rpm]\"\n0,5;1e3\n1;-2,5e-1\n", "# note\nt\tx\n1\t2\n3\t4\n"};
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string text = mutator.mutate(seeds[mutator.below(seeds.size())]);
    try {
      const CsvTable table = readCsvTable(text, "fuzz.csv");
      ++accepted;
      for (const CsvColumn& column : table.columns) {
        QCOMPARE(column.values.size(), table.rows());
        for (const double v : column.values) QVERIFY(std::isfinite(v));
      }
    } catch (const InputError& error) {
      QVERIFY(!error.problems().empty());
    }
  }
  QVERIFY(accepted > kMutations / 100);
  QVERIFY(accepted < kMutations * 3 / 4);
}

QTEST_GUILESS_MAIN(TestFuzzDocument)
#include "test_fuzz_document.moc"
