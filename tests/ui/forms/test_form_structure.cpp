// What stands where: alternatives, lists and tables with their undo, paste, search, jumps to
// problems, and the rule that every described field has an editor without a line of form code.
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QTableView>
#include <QTreeWidget>

#include "tests/ui/forms/form_fixture.h"
#include "ui/forms/help_table.h"
#include "ui/forms/problems_panel.h"

using namespace rotorbench;
using forms_test::FormFixture;
using forms_test::Gusty;
using Bench = forms_test::Document;

class TestFormStructure : public QObject {
  Q_OBJECT

 private slots:
  void cleanup();
  void everyFieldHasAnEditor();
  void alternativesSwitchAndComeBack();
  void advancedFieldsWaitBehindMore();
  void listEntriesAddRemoveMove();
  void tableCellsAreTyped();
  void tablePaste_data();
  void tablePaste();
  void brokenPasteChangesNothing_data();
  void brokenPasteChangesNothing();
  void searchFindsParameters_data();
  void searchFindsParameters();
  void problemClickJumpsToTheField();
  void rulesOverSeveralFieldsShowTheirSentence();
  void linksAndTreeAgree();
  void helpTableNamesEveryField();
  void loadingAnotherDocumentRebuilds();
};

void TestFormStructure::cleanup() {
  QTRY_VERIFY(QApplication::topLevelWidgets().isEmpty());
}

void TestFormStructure::everyFieldHasAnEditor() {
  Bench document;
  document.wind = Gusty();
  FormFixture f(document);
  int leaves = 0;
  schema::walk(f.model.root(),
               [&](const std::string& path, const schema::Field& field, const void*) {
                 const QString place = QString::fromStdString(path);
                 f.panel->jumpTo(place);
                 if (place.startsWith("timeline[")) return;  // cells, tested below
                 const QString name = field.kind == schema::Kind::Vector ? place + "[0]" : place;
                 if (field.kind == schema::Kind::Group) return;
                 QVERIFY2(f.find<QWidget>(name) != nullptr, qPrintable(name));
                 QVERIFY2(!f.find<QWidget>(name)->accessibleName().isEmpty(), qPrintable(name));
                 if (field.isLeaf()) QVERIFY2(f.find<QWidget>(name)->isVisible(), qPrintable(name));
                 ++leaves;
               });
  QVERIFY(leaves > 25);
}

void TestFormStructure::alternativesSwitchAndComeBack() {
  Bench document;
  document.wind = Gusty{7.5, 42};
  FormFixture f(document);
  QCOMPARE(f.find("wind.meanSpeed")->text(), QString("7.5"));
  auto* wind = f.find<QComboBox>("wind");
  wind->setFocus();
  QTest::keyClick(wind, Qt::Key_Up);
  QTRY_VERIFY(f.find("wind.density") != nullptr);
  QVERIFY(f.find("wind.meanSpeed") == nullptr);
  QTRY_VERIFY(f.find<QComboBox>("wind")->hasFocus());
  f.stack().undo();
  QTRY_VERIFY(f.find("wind.meanSpeed") != nullptr);
  QCOMPARE(f.find("wind.meanSpeed")->text(), QString("7.5"));
  QCOMPARE(f.find<QComboBox>("wind")->currentText(), QString("Gusty wind"));
}

void TestFormStructure::advancedFieldsWaitBehindMore() {
  FormFixture f;
  QVERIFY(!f.find("tolerance")->isVisible());
  QTest::mouseClick(f.find<QToolButton>("more.bench"), Qt::LeftButton);
  QVERIFY(f.find("tolerance")->isVisible());
  QTest::mouseClick(f.find<QToolButton>("more.bench"), Qt::LeftButton);
  QVERIFY(!f.find("tolerance")->isVisible());
  f.panel->jumpTo("tolerance");
  QVERIFY(f.find("tolerance")->isVisible());
  QTRY_VERIFY(f.find("tolerance")->hasFocus());
}

void TestFormStructure::listEntriesAddRemoveMove() {
  Bench document;
  document.motors[1].name = "M2";
  FormFixture f(document);
  f.panel->showSection("motors");
  auto* list = f.find<QListWidget>("motors");
  QCOMPARE(list->count(), 2);
  QTest::mouseClick(f.find<QToolButton>("duplicate"), Qt::LeftButton);
  QCOMPARE(list->count(), 3);
  QCOMPARE(list->item(1)->text(), QString("M1"));
  QTest::mouseClick(f.find<QToolButton>("down"), Qt::LeftButton);
  QCOMPARE(list->item(1)->text(), QString("M2"));
  QCOMPARE(list->currentRow(), 2);
  QTest::mouseClick(f.find<QToolButton>("add"), Qt::LeftButton);
  QVERIFY(!f.find<QToolButton>("add")->isEnabled());  // at most four
  for (int i = 0; i < 3; ++i) QTest::mouseClick(f.find<QToolButton>("remove"), Qt::LeftButton);
  QCOMPARE(list->count(), 1);
  QVERIFY(!f.find<QToolButton>("remove")->isEnabled());  // at least one
  while (f.stack().canUndo()) f.stack().undo();
  QVERIFY(f.document() == document);
  QCOMPARE(list->item(1)->text(), QString("M2"));
}

void TestFormStructure::tableCellsAreTyped() {
  FormFixture f;
  f.panel->jumpTo("timeline[1].time");
  auto* table = f.find<QTableView>("timeline");
  QTRY_VERIFY(table->hasFocus());
  QCOMPARE(table->currentIndex(), table->model()->index(1, 0));
  const auto type = [&](const QString& text) {
    table->edit(table->currentIndex());
    auto* editor = table->findChild<QLineEdit*>("cellEditor");
    QVERIFY(editor != nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_VERIFY(table->findChild<QLineEdit*>("cellEditor") == nullptr);
  };
  type("250 ms");
  QCOMPARE(f.document().timeline[1].time, 0.25);
  type("-1");
  QVERIFY(f.model.hasErrors());
  QCOMPARE(f.document().timeline[1].time, 0.25);
  const QModelIndex cell = table->model()->index(1, 0);
  QCOMPARE(cell.data().toString(), QString("-1"));
  QCOMPARE(cell.data(Qt::ToolTipRole).toString(), QString("Must be at least 0 s."));
  type("2");
  QVERIFY(!f.model.hasErrors());
  table->setCurrentIndex(table->model()->index(0, 2));
  type("4");
  QCOMPARE(f.document().timeline[0].point, Eigen::Vector3d(0, 4, 1));
  QVERIFY(table->model()->setData(table->model()->index(0, 5), Qt::Checked, Qt::CheckStateRole));
  QVERIFY(f.document().timeline[0].relative);
  QCOMPARE(table->model()->headerData(1, Qt::Horizontal).toString(), QString("Point x [m]"));
}

void TestFormStructure::tablePaste_data() {
  QTest::addColumn<QString>("text");
  QTest::addRow("tabs")
      << "0.5\t1\t2\t3\tEuler\ton\n1\t0\t0\t1\trk4\toff\n2\t4\t5\t6\tEuler\tyes\n";
  QTest::addRow("commas") << "0.5,1,2,3,Euler,on\n1,0,0,1,rk4,off\n2,4,5,6,Euler,yes";
  QTest::addRow("header, units")
      << "Time [s]\tPoint x [m]\tPoint y [m]\tPoint z [m]\tMethod\tRelative\n"
         "500 ms\t100 cm\t2\t3\teuler\ttrue\n1\t0\t0\t1\tRunge-Kutta 4\t0\n2\t4\t5\t6\tEuler\t1\n";
}

void TestFormStructure::tablePaste() {
  QFETCH(QString, text);
  FormFixture f;
  f.panel->jumpTo("timeline[0].time");
  QApplication::clipboard()->setText(text);
  auto* table = f.find<QTableView>("timeline");
  QTest::keySequence(table, QKeySequence::Paste);
  const auto& rows = f.document().timeline;
  QCOMPARE(rows.size(), std::size_t{3});
  using forms_test::Event;
  using forms_test::Method;
  QVERIFY(rows[0] == (Event{0.5, {1, 2, 3}, Method::Euler, true}));
  QVERIFY(rows[1] == (Event{1, {0, 0, 1}, Method::RungeKutta4, false}));
  QVERIFY(rows[2] == (Event{2, {4, 5, 6}, Method::Euler, true}));
  QCOMPARE(f.stack().undoText(), QString("Paste 3 rows into Timeline"));
  QCOMPARE(table->model()->rowCount(), 3);
  f.stack().undo();
  QVERIFY(f.document() == Bench());
  QCOMPARE(table->model()->rowCount(), 2);
}

void TestFormStructure::brokenPasteChangesNothing_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("says");
  QTest::addRow("word") << "0.5\t1\nx\t1"
                        << "Row 2, Time [s], “x”";
  QTest::addRow("range") << "0.5\t1000"
                         << "at least -100 and at most 100 m";
  QTest::addRow("too wide") << "1\t2\t3\t4\tEuler\ton\t7"
                            << "there is room for 6";
  QTest::addRow("option") << "1\t2\t3\t4\tHeun\ton"
                          << "Euler, Runge-Kutta 4";
  QTest::addRow("too long") << QString("1\n").repeated(51) << "room for 50 rows";
  QTest::addRow("nothing") << "\n"
                           << "no table on the clipboard";
}

void TestFormStructure::brokenPasteChangesNothing() {
  QFETCH(QString, text);
  QFETCH(QString, says);
  FormFixture f;
  f.panel->jumpTo("timeline[0].time");
  QApplication::clipboard()->setText(text);
  QTest::keySequence(f.find<QTableView>("timeline"), QKeySequence::Paste);
  QVERIFY(f.document() == Bench());
  QCOMPARE(f.stack().count(), 0);
  const QString sentence = f.sentence("timeline");
  QVERIFY2(sentence.contains(says), qPrintable(sentence));
}

void TestFormStructure::searchFindsParameters_data() {
  QTest::addColumn<QString>("words");
  QTest::addColumn<QStringList>("found");
  QTest::addRow("label") << "phase res"
                         << QStringList{"winding.resistance", "motors[0].winding.resistance",
                                        "motors[1].winding.resistance"};
  QTest::addRow("key") << "speedLimit"
                       << QStringList{"motors[0].speedLimit", "motors[1].speedLimit"};
  QTest::addRow("symbol") << "ω_max" << QStringList{"motors[0].speedLimit", "motors[1].speedLimit"};
  QTest::addRow("table column") << "relative" << QStringList{"timeline"};
  QTest::addRow("advanced") << "tolerance" << QStringList{"tolerance"};
  QTest::addRow("nothing") << "xyzzy" << QStringList{};
}

void TestFormStructure::searchFindsParameters() {
  QFETCH(QString, words);
  QFETCH(QStringList, found);
  FormFixture f;
  f.find("parameterSearch")->setText(words);  // key events know no Greek
  auto* tree = f.find<QTreeWidget>("sections");
  QStringList shown;
  QTreeWidgetItem* first = nullptr;
  for (QTreeWidgetItemIterator it(tree); *it != nullptr; ++it) {
    if (!(*it)->data(0, Qt::UserRole + 1).toBool()) continue;
    shown += (*it)->data(0, Qt::UserRole).toString();
    if (first == nullptr) first = *it;
  }
  QCOMPARE(shown, found);
  if (first == nullptr) return;
  QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(first).center());
  auto* field = f.find<QWidget>(found.front());
  QVERIFY(field != nullptr);
  QTRY_VERIFY(field->hasFocus());
}

void TestFormStructure::problemClickJumpsToTheField() {
  Bench document;
  document.motors[1].winding.resistance = -1;
  FormFixture f(document);
  ProblemsPanel problems(&f.model);
  connect(&problems, &ProblemsPanel::jumpTo, f.panel.get(), &ExperimentPanel::jumpTo);
  problems.resize(600, 120);
  problems.show();
  auto* list = problems.findChild<QTreeWidget*>("problems");
  QCOMPARE(list->topLevelItemCount(), 1);
  auto* item = list->topLevelItem(0);
  QCOMPARE(item->text(0), QString("Motors › M1 › Winding › Phase resistance"));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(item).center());
  auto* edit = f.find("motors[1].winding.resistance");
  QVERIFY(edit != nullptr);
  f.panel->activateWindow();
  QTRY_VERIFY(edit->hasFocus());
  QTRY_VERIFY(!f.sentence("motors[1].winding.resistance").isEmpty());
  f.type("motors[1].winding.resistance", "0.2");
  QCOMPARE(list->topLevelItemCount(), 0);
  QVERIFY(problems.findChild<QLabel*>("noProblems")->isVisible());
}

void TestFormStructure::rulesOverSeveralFieldsShowTheirSentence() {
  FormFixture f;
  f.type("low", "3");
  QCOMPARE(f.document().low, 3.0);
  QTRY_COMPARE(f.sentence("low"), QString("The lower limit is above the upper."));
  f.type("high", "4");
  QTRY_COMPARE(f.sentence("low"), QString());
}

void TestFormStructure::linksAndTreeAgree() {
  FormFixture f;
  QTest::mouseClick(f.find<QPushButton>("motors"), Qt::LeftButton);
  QTRY_COMPARE(f.find<QLabel>("formTitle")->text(), QString("Motors"));
  auto* tree = f.find<QTreeWidget>("sections");
  QCOMPARE(tree->currentItem()->text(0), QString("Motors"));
  QTest::keyClick(f.find<QListWidget>("motors"), Qt::Key_Return);
  QTRY_COMPARE(f.find<QLabel>("formTitle")->text(), QString("M1"));
  f.type("motors[0].name", "Front");
  QTRY_COMPARE(tree->currentItem()->text(0), QString("Front"));
  f.model.removeElement("motors", 1);
  f.model.removeElement("motors", 0);
  QTRY_COMPARE(f.find<QLabel>("formTitle")->text(), QString("Motors"));
}

void TestFormStructure::helpTableNamesEveryField() {
  const QString html = parameterTableHtml(schema::typeOf<Bench>());
  for (const char* text :
       {"Phase resistance", "<i>R</i><sub>a</sub>", "Ω", "0.117 Ω", "25 cm",
        "above 0 and at most 200", "Thesis, table 3", "Gusty wind", "winding.poles",
        "Runge-Kutta 4: Fourth order.", "DJI E305 data sheet"}) {
    QVERIFY2(html.contains(QString::fromUtf8(text)), text);
  }
}

void TestFormStructure::loadingAnotherDocumentRebuilds() {
  FormFixture f;
  f.panel->jumpTo("motors[1].mass");
  Bench other;
  other.title = "Other";
  other.motors.resize(1);
  f.model.replaceDocument(makeDocument(other));
  QTRY_COMPARE(f.find("title")->text(), QString("Other"));
  QVERIFY(f.find("motors[1].mass") == nullptr);
}

QTEST_MAIN(TestFormStructure)
#include "test_form_structure.moc"
