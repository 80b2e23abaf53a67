// The document behind the forms: every edit can be undone and redone to the bit, repeated edits are
// one step, and an edit that comes back to where it began leaves nothing to undo and nothing to
// save.
#include <QSignalSpy>
#include <QtTest>

#include "tests/ui/forms/all_kinds.h"
#include "ui/forms/default_values.h"
#include "ui/forms/digit_step.h"
#include "ui/forms/document_model.h"
#include "ui/forms/sections.h"
#include "ui/forms/table_text.h"

using namespace rotorbench;
using forms_test::Gusty;
using Bench = forms_test::Document;

using Action = std::function<void(DocumentModel&)>;
Q_DECLARE_METATYPE(Action)

class TestDocumentModel : public QObject {
  Q_OBJECT

 private slots:
  void editsUndoAndRedo_data();
  void editsUndoAndRedo();
  void repeatedEditsAreOneStep();
  void comingBackLeavesNothingToUndo();
  void repeatedEditsDoNotMergeAcrossSaving();
  void valuesOutsideTheRangeAreRefused();
  void variantKeepsTheOldAlternative();
  void invalidTextBlocksUntilPutRight();
  void loadingStartsAnew();
  void defaultsFollowTheAlternative();
  void digitsStep_data();
  void digitsStep();
  void tablesSplit_data();
  void tablesSplit();
  void sectionsHoldWhatTheyShow_data();
  void sectionsHoldWhatTheyShow();
};

void TestDocumentModel::editsUndoAndRedo_data() {
  QTest::addColumn<Action>("edit");
  QTest::addColumn<QString>("text");
  const auto row = [](const char* name, Action edit, const char* text) {
    QTest::addRow("%s", name) << std::move(edit) << QString::fromUtf8(text);
  };
  row(
      "number", [](auto& m) { m.set("winding.resistance", 0.12); },
      "Change Phase resistance to 0.12 Ohm");
  row(
      "integer", [](auto& m) { m.set("steps", std::int64_t{12}); }, "Change Steps to 12");
  row(
      "boolean", [](auto& m) { m.set("record", false); }, "Change Record everything to off");
  row(
      "choice", [](auto& m) { m.set("method", std::string("euler")); }, "Change Method to Euler");
  row(
      "text", [](auto& m) { m.set("title", std::string("New")); }, "");
  row(
      "vector",
      [](auto& m) {
        m.set("start", std::vector<double>{1, 2, 3});
      },
      "");
  row(
      "alternative", [](auto& m) { m.choose("wind", 1); }, "Choose Gusty wind for Wind");
  row(
      "insert", [](auto& m) { m.insertElement("motors", 1); }, "Add to Motors");
  row(
      "duplicate", [](auto& m) { m.duplicateElement("motors", 1); }, "Duplicate Motors 2");
  row(
      "remove", [](auto& m) { m.removeElement("timeline", 0); }, "Remove Timeline 1");
  row(
      "move", [](auto& m) { m.moveElement("motors", 1, 0); }, "Move Motors 2");
  row(
      "object",
      [](auto& m) {
        forms_test::Motor other;
        other.name = "Big";
        other.mass = 0.2;
        m.replaceObject("motors[1]", capture(schema::ref(other)), "Take Big from the library");
      },
      "Take Big from the library");
}

void TestDocumentModel::editsUndoAndRedo() {
  QFETCH(Action, edit);
  QFETCH(QString, text);
  Bench start;
  start.motors[1].name = "Second";
  start.motors[1].winding.resistance = 0.2;
  start.timeline[0].point = {1, 2, 3};
  DocumentModel model(makeDocument(start));
  edit(model);
  const Bench edited = model.as<Bench>();
  QVERIFY(!(edited == start));
  QVERIFY(!model.isClean());
  QCOMPARE(model.undoStack()->count(), 1);
  if (!text.isEmpty()) QCOMPARE(model.undoStack()->undoText(), text);
  model.undoStack()->undo();
  QVERIFY(model.as<Bench>() == start);
  QVERIFY(model.isClean());
  model.undoStack()->redo();
  QVERIFY(model.as<Bench>() == edited);
}

void TestDocumentModel::repeatedEditsAreOneStep() {
  DocumentModel model(makeDocument(Bench()));
  for (const double span : {0.26, 0.27, 0.28}) {
    model.set("span", span, DocumentModel::Edit::Repeated);
  }
  QCOMPARE(model.undoStack()->count(), 1);
  model.set("low", 0.5, DocumentModel::Edit::Repeated);
  model.set("span", 0.29);
  QCOMPARE(model.undoStack()->count(), 3);
  model.undoStack()->undo();
  model.undoStack()->undo();
  QCOMPARE(model.as<Bench>().span, 0.28);
  model.undoStack()->undo();
  QCOMPARE(model.as<Bench>().span, 0.25);
}

void TestDocumentModel::comingBackLeavesNothingToUndo() {
  DocumentModel model(makeDocument(Bench()));
  QSignalSpy clean(&model, &DocumentModel::cleanChanged);
  model.set("span", 0.26, DocumentModel::Edit::Repeated);
  QVERIFY(!model.isClean());
  model.set("span", 0.25, DocumentModel::Edit::Repeated);
  QCOMPARE(model.undoStack()->count(), 0);
  QVERIFY(model.isClean());
  QCOMPARE(clean.last().at(0).toBool(), true);
  model.set("span", 0.25);
  QCOMPARE(model.undoStack()->count(), 0);
}

void TestDocumentModel::repeatedEditsDoNotMergeAcrossSaving() {
  DocumentModel model(makeDocument(Bench()));
  model.set("span", 0.26, DocumentModel::Edit::Repeated);
  model.setClean();
  model.set("span", 0.27, DocumentModel::Edit::Repeated);
  QCOMPARE(model.undoStack()->count(), 2);
  model.undoStack()->undo();
  QVERIFY(model.isClean());
}

void TestDocumentModel::valuesOutsideTheRangeAreRefused() {
  DocumentModel model(makeDocument(Bench()));
  for (const double wrong : {0.0, -1.0, 2.5, std::nan(""), HUGE_VAL}) {
    QVERIFY(model.set("span", wrong).has_value());
  }
  QVERIFY(model.set("method", std::string("rk5")).has_value());
  QVERIFY(model.set("nowhere", 1.0).has_value());
  QVERIFY(model.as<Bench>() == Bench());
  QCOMPARE(model.undoStack()->count(), 0);
}

void TestDocumentModel::variantKeepsTheOldAlternative() {
  Bench start;
  start.wind = Gusty{7.5, 42};
  DocumentModel model(makeDocument(start));
  QSignalSpy structure(&model, &DocumentModel::structureChanged);
  model.choose("wind", 0);
  QVERIFY(!model.find("wind.meanSpeed"));
  model.set("wind.density", 1.1);
  model.undoStack()->undo();
  model.undoStack()->undo();
  QVERIFY(std::get<Gusty>(model.as<Bench>().wind) == (Gusty{7.5, 42}));
  QCOMPARE(structure.count(), 2);
  model.undoStack()->redo();
  model.undoStack()->redo();
  QCOMPARE(std::get<forms_test::Still>(model.as<Bench>().wind).density, 1.1);
}

void TestDocumentModel::invalidTextBlocksUntilPutRight() {
  DocumentModel model(makeDocument(Bench()));
  QVERIFY(!model.hasErrors());
  model.setInvalidText("span", "ten", "\"ten\" is not a number.");
  QVERIFY(model.hasErrors());
  QCOMPARE(model.problems().front().path, std::string("span"));
  QCOMPARE(model.as<Bench>().span, 0.25);
  model.set("span", 0.25);
  QVERIFY(!model.hasErrors());
  model.setExtraValidator([](schema::ConstRef) {
    return std::vector<Problem>{{"motors", "the battery is small", {}, true}};
  });
  QCOMPARE(model.problems().size(), std::size_t{1});
  QVERIFY(!model.hasErrors());
  model.set("low", 5.0);
  QVERIFY(model.hasErrors());
}

void TestDocumentModel::loadingStartsAnew() {
  DocumentModel model(makeDocument(Bench()));
  model.set("span", 0.5);
  model.setInvalidText("steps", "x", "No.");
  QSignalSpy replaced(&model, &DocumentModel::documentReplaced);
  Bench other;
  other.title = "Other";
  model.replaceDocument(makeDocument(other));
  QCOMPARE(replaced.count(), 1);
  QVERIFY(model.as<Bench>() == other);
  QVERIFY(model.isClean() && !model.undoStack()->canUndo() && !model.hasErrors());
  const Document copy = model.copy();
  model.set("span", 0.5);
  QVERIFY(*static_cast<const Bench*>(copy.object.get()) == other);
}

void TestDocumentModel::defaultsFollowTheAlternative() {
  Bench start;
  start.wind = Gusty{7.5, 42};
  start.motors.resize(3);
  start.motors[2].mass = 0.5;
  DocumentModel model(makeDocument(start));
  const auto of = [&](const char* path) {
    return defaultValue(model.root(), model.defaults(), path);
  };
  QCOMPARE(std::get<double>(*of("wind.meanSpeed")), 5.0);
  QCOMPARE(std::get<double>(*of("motors[2].mass")), 0.05);
  QCOMPARE(std::get<double>(*of("span")), 0.25);
  QVERIFY(!of("wind.density"));
}

void TestDocumentModel::digitsStep_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("cursor");
  QTest::addColumn<int>("steps");
  QTest::addColumn<int>("up");
  QTest::addColumn<QString>("result");
  QTest::addColumn<int>("resultCursor");
  QTest::addRow("last digit") << "1.25" << 4 << 1 << 0 << "1.26" << 4;
  QTest::addRow("tenths") << "1.25" << 3 << 1 << 0 << "1.35" << 3;
  QTest::addRow("ones") << "1.25" << 1 << -1 << 0 << "0.25" << 1;
  QTest::addRow("at the start") << "31" << 0 << 1 << 0 << "41" << 1;
  QTest::addRow("carry keeps the digit") << "9.9" << 3 << 1 << 0 << "10.0" << 4;
  QTest::addRow("through zero") << "0.1" << 3 << -2 << 0 << "-0.1" << 4;
  QTest::addRow("page") << "0.25" << 4 << 1 << 1 << "0.35" << 4;
  QTest::addRow("exponent stays") << "2e-5" << 4 << 1 << 0 << "3e-5" << 1;
  QTest::addRow("exact decimals") << "0.7" << 3 << 1 << 0 << "0.8" << 3;
  QTest::addRow("not a number") << "3*2" << 1 << 1 << 0 << "" << 0;
}

void TestDocumentModel::digitsStep() {
  QFETCH(QString, text);
  QFETCH(int, cursor);
  QFETCH(int, steps);
  QFETCH(int, up);
  QFETCH(QString, result);
  QFETCH(int, resultCursor);
  const auto stepped = stepDigit(text, cursor, steps, up, '.');
  QCOMPARE(stepped.has_value(), !result.isEmpty());
  if (!stepped) return;
  QCOMPARE(stepped->text, result);
  if (up == 0) QCOMPARE(stepped->cursor, resultCursor);
}

void TestDocumentModel::tablesSplit_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<bool>("commaIsDecimal");
  QTest::addColumn<QList<QStringList>>("rows");
  using Rows = QList<QStringList>;
  QTest::addRow("tabs") << "1\t2\r\n3\t4\n" << false << Rows{{"1", "2"}, {"3", "4"}};
  QTest::addRow("commas") << "1, 2\n3, 4" << false << Rows{{"1", "2"}, {"3", "4"}};
  QTest::addRow("semicolons") << "1,5;2\n3;4" << true << Rows{{"1,5", "2"}, {"3", "4"}};
  QTest::addRow("decimal comma alone") << "1,5\n2,5" << true << Rows{{"1,5"}, {"2,5"}};
  QTest::addRow("quotes") << "\"a\tb\"\t\"say \"\"x\"\"\"" << false << Rows{{"a\tb", "say \"x\""}};
  QTest::addRow("nothing") << "\n \n" << false << Rows{};
}

void TestDocumentModel::tablesSplit() {
  QFETCH(QString, text);
  QFETCH(bool, commaIsDecimal);
  QFETCH(QList<QStringList>, rows);
  QCOMPARE(splitTable(text, commaIsDecimal), rows);
  const bool severalCells = !rows.isEmpty() && rows.front().size() > 1;
  if (severalCells) QCOMPARE(splitTable(joinTable(rows), false), rows);
}

void TestDocumentModel::sectionsHoldWhatTheyShow_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("section");
  QTest::addRow("leaf") << "span"
                        << "";
  QTest::addRow("small group") << "winding.resistance"
                               << "";
  QTest::addRow("small variant") << "wind.density"
                                 << "";
  QTest::addRow("table cell") << "timeline[1].time"
                              << "";
  QTest::addRow("list") << "motors"
                        << "motors";
  QTest::addRow("in an element") << "motors[1].winding.poles"
                                 << "motors[1]";
  QTest::addRow("element gone") << "motors[7].mass"
                                << "motors";
}

void TestDocumentModel::sectionsHoldWhatTheyShow() {
  QFETCH(QString, path);
  QFETCH(QString, section);
  DocumentModel model(makeDocument(Bench()));
  QCOMPARE(sectionOf(model.root(), path), section);
}

QTEST_MAIN(TestDocumentModel)
#include "test_document_model.moc"
