// Typing into the fields of a form: units, expressions, both decimal separators, wrong values with
// their sentence, stepping by keys and wheel, undo. Expected values are exact by the units'
// definitions.
#include <QCheckBox>
#include <QComboBox>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QWheelEvent>

#include "tests/ui/forms/form_fixture.h"
#include "ui/forms/quantity_edit.h"

using namespace rotorbench;
using forms_test::FormFixture;
using Bench = forms_test::Document;

class TestFormTyping : public QObject {
  Q_OBJECT

 private slots:
  void cleanup();
  void typedQuantities_data();
  void typedQuantities();
  void wrongTextKeepsTheDocument_data();
  void wrongTextKeepsTheDocument();
  void escapeAndUndoTakeBackTyping();
  void wrongComponentStaysWhileOthersChange();
  void everyEditorUndoes();
  void arrowKeysAreOneStep();
  void arrowKeysStopAtTheRange();
  void resetButtonGoesBack();
  void unitsSwitchTogether();
  void unitsAreRemembered();
  void wheelOverUnfocusedFieldsDoesNothing();
  void numbersAreShownShort_data();
  void numbersAreShownShort();
  void pendingTextIsCommittedOnRequest();
  void readersGetNames();
};

void TestFormTyping::cleanup() {
  QLocale::setDefault(QLocale::c());
  QTRY_VERIFY(QApplication::topLevelWidgets().isEmpty());
}

void TestFormTyping::typedQuantities_data() {
  QTest::addColumn<QLocale>("locale");
  QTest::addColumn<QString>("text");
  QTest::addColumn<double>("metres");
  QTest::addColumn<QString>("shown");
  const QLocale c = QLocale::c();
  const QLocale de(QLocale::German, QLocale::Germany);
  QTest::addRow("shown unit") << c << "30" << 0.3 << "30";
  QTest::addRow("cm") << c << "10 cm" << 0.1 << "10";
  QTest::addRow("without space") << c << "120mm" << 0.12 << "12";
  QTest::addRow("inches") << c << "10 in" << 0.254 << "25.4";
  QTest::addRow("expression") << c << "3*2" << 0.06 << "6";
  QTest::addRow("expression with unit") << c << "(1+0.5)/2 m" << 0.75 << "75";
  QTest::addRow("point, C") << c << "1.5" << 0.015 << "1.5";
  QTest::addRow("comma, C") << c << "1,5" << 0.015 << "1.5";
  QTest::addRow("point, German") << de << "1.5" << 0.015 << "1,5";
  QTest::addRow("comma, German") << de << "1,5" << 0.015 << "1,5";
  QTest::addRow("1.25 in German is not 12") << de << "1.25" << 0.0125 << "1,25";
  QTest::addRow("at the bound") << c << "200" << 2.0 << "200";
}

void TestFormTyping::typedQuantities() {
  QFETCH(QLocale, locale);
  QFETCH(QString, text);
  QFETCH(double, metres);
  QFETCH(QString, shown);
  QLocale::setDefault(locale);
  FormFixture f;
  f.type("span", text);
  QCOMPARE(f.document().span, metres);
  QCOMPARE(f.find("span")->text(), shown);
  QVERIFY(!f.model.hasErrors());
  QCOMPARE(f.stack().undoText(), QStringLiteral("Change Span to %1 cm").arg(shown));
}

void TestFormTyping::wrongTextKeepsTheDocument_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("says");
  QTest::addRow("garbage") << "span"
                           << "ten"
                           << "ten";
  QTest::addRow("empty") << "span"
                         << " "
                         << "no number";
  QTest::addRow("too large") << "span"
                             << "201"
                             << "above 0 and at most 200 cm";
  QTest::addRow("open bound") << "span"
                              << "0"
                              << "above 0 and at most 200 cm";
  QTest::addRow("negative") << "span"
                            << "-5"
                            << "above 0";
  QTest::addRow("wrong unit") << "span"
                              << "5 kg"
                              << "kg";
  QTest::addRow("NaN") << "span"
                       << "nan"
                       << "nan";
  QTest::addRow("infinite") << "span"
                            << "1e999"
                            << "finite";
  QTest::addRow("division by zero") << "span"
                                    << "1/0"
                                    << "zero";
  QTest::addRow("fraction") << "steps"
                            << "2.5"
                            << "whole number";
  QTest::addRow("integer range") << "steps"
                                 << "1001"
                                 << "at least 1 and at most 1000";
  QTest::addRow("huge integer") << "steps"
                                << "1e300"
                                << "at most 1000";
  QTest::addRow("component") << "start[1]"
                             << "101"
                             << "at least -100 and at most 100 m";
  QTest::addRow("two separators") << "span"
                                  << "1.000,5"
                                  << "not a number";
}

void TestFormTyping::wrongTextKeepsTheDocument() {
  QFETCH(QString, path);
  QFETCH(QString, text);
  QFETCH(QString, says);
  FormFixture f;
  f.type(path, text);
  const QString row = path.section('[', 0, 0);
  QTRY_VERIFY2(f.sentence(row).contains(says), qPrintable(f.sentence(row)));
  QVERIFY(f.sentence(row).endsWith('.'));
  QCOMPARE(f.find(path)->text(), text);
  QVERIFY(f.document() == Bench());
  QVERIFY(f.model.hasErrors());
  QCOMPARE(f.stack().count(), 0);
  QTRY_VERIFY(f.find(path)->findChild<QWidget*>("frame") != nullptr);
  QVERIFY(f.find(path)->findChild<QWidget*>("frame")->isVisible());
  f.type(path, "5");
  QVERIFY(!f.model.hasErrors());
  QTRY_VERIFY(f.sentence(row).isEmpty());
}

void TestFormTyping::escapeAndUndoTakeBackTyping() {
  FormFixture f;
  f.type("span", "30");
  auto* span = f.find("span");
  span->selectAll();
  QTest::keyClicks(span, "99");
  QTest::keyClick(span, Qt::Key_Z, Qt::ControlModifier);  // takes back the typing only
  QCOMPARE(span->text(), QString("30"));
  QCOMPARE(f.document().span, 0.3);
  QTest::keyClick(span, Qt::Key_Z, Qt::ControlModifier);  // nothing typed: the document's undo
  QCOMPARE(f.document().span, 0.25);
  QCOMPARE(span->text(), QString("25"));
  QTest::keySequence(span, QKeySequence::Redo);
  QCOMPARE(span->text(), QString("30"));
  f.type("span", "junk");
  QVERIFY(f.model.hasErrors());
  QTest::keyClick(span, Qt::Key_Escape);
  QCOMPARE(span->text(), QString("30"));
  QVERIFY(!f.model.hasErrors());
}

void TestFormTyping::wrongComponentStaysWhileOthersChange() {
  FormFixture f;
  f.type("start[0]", "oops");
  f.type("start[2]", "7");
  QCOMPARE(f.document().start, Eigen::Vector3d(0, 0, 7));
  QCOMPARE(f.find("start[0]")->text(), QString("oops"));
  QVERIFY(f.model.hasErrors());
  f.type("start[0]", "3");
  QCOMPARE(f.document().start, Eigen::Vector3d(3, 0, 7));
  QVERIFY(!f.model.hasErrors());
}

void TestFormTyping::everyEditorUndoes() {
  FormFixture f;
  f.type("title", "Stand");
  f.type("span", "40");
  f.type("steps", "20");
  f.type("start[1]", "-2");
  QTest::mouseClick(f.find<QLabel>("record.label"), Qt::LeftButton);
  auto* method = f.find<QComboBox>("method");
  method->setFocus();
  QTest::keyClick(method, Qt::Key_Up);
  auto* notes = f.find<QPlainTextEdit>("notes");
  notes->setFocus();
  QTest::keyClicks(notes, "hello");
  f.find("title")->setFocus();
  const Bench edited = f.document();
  QCOMPARE(edited.title, std::string("Stand"));
  QCOMPARE(edited.steps, 20);
  QCOMPARE(edited.record, false);
  QCOMPARE(edited.method, forms_test::Method::Euler);
  QCOMPARE(edited.notes, std::string("hello"));
  QCOMPARE(f.stack().count(), 7);
  while (f.stack().canUndo()) f.stack().undo();
  QVERIFY(f.document() == Bench());
  QCOMPARE(f.find("title")->text(), QString("Bench"));
  QCOMPARE(f.find("steps")->text(), QString("10"));
  QCOMPARE(f.find("start[1]")->text(), QString("0"));
  QVERIFY(f.find<QCheckBox>("record")->isChecked());
  QCOMPARE(method->currentText(), QString("Runge-Kutta 4"));
  QCOMPARE(notes->toPlainText(), QString());
  while (f.stack().canRedo()) f.stack().redo();
  QVERIFY(f.document() == edited);
}

void TestFormTyping::arrowKeysAreOneStep() {
  FormFixture f;
  auto* span = f.find("span");
  span->setFocus();
  span->setCursorPosition(2);
  for (int i = 0; i < 5; ++i) QTest::keyClick(span, Qt::Key_Up);
  QCOMPARE(span->text(), QString("30"));
  QCOMPARE(f.document().span, 0.3);
  QCOMPARE(f.stack().count(), 1);
  QTest::keyClick(span, Qt::Key_PageUp);
  QCOMPARE(f.document().span, 0.4);
  for (int i = 0; i < 15; ++i) QTest::keyClick(span, Qt::Key_Down);
  QCOMPARE(span->text(), QString("25"));
  QCOMPARE(f.stack().count(), 0);
  QVERIFY(f.model.isClean());
}

void TestFormTyping::arrowKeysStopAtTheRange() {
  FormFixture f;
  f.type("span", "199");
  auto* span = f.find("span");
  span->setCursorPosition(3);
  QTest::keyClick(span, Qt::Key_Up);
  QTest::keyClick(span, Qt::Key_Up);
  QCOMPARE(f.document().span, 2.0);
  QVERIFY(!f.model.hasErrors());
}

void TestFormTyping::resetButtonGoesBack() {
  FormFixture f;
  auto* reset = f.find<QToolButton>("span.reset");
  QVERIFY(!reset->isVisible());
  f.type("span", "40");
  QTRY_VERIFY(reset->isVisible());
  QVERIFY(reset->toolTip().contains("25 cm"));
  QTest::mouseClick(reset, Qt::LeftButton);
  QCOMPARE(f.document().span, 0.25);
  QVERIFY(!reset->isVisible());
  f.stack().undo();
  QCOMPARE(f.document().span, 0.4);
}

void TestFormTyping::unitsSwitchTogether() {
  FormFixture f;
  f.panel->jumpTo("motors[0].arm");
  QCOMPARE(f.find("motors[0].arm")->text(), QString("22.5"));
  auto* row = f.find("motors[0].arm")->parentWidget();
  QToolButton* unit = nullptr;
  for (auto* button : row->parentWidget()->findChildren<QToolButton*>("unit")) {
    if (button->text() == "cm") unit = button;
  }
  QVERIFY(unit != nullptr);
  QTest::mouseClick(unit, Qt::LeftButton);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  QVERIFY(menu != nullptr);
  for (QAction* action : menu->actions()) {
    if (action->data().toString() == "in") action->trigger();
  }
  menu->close();
  QCOMPARE(unit->text(), QString("in"));
  QCOMPARE(f.find("motors[0].arm")->text().left(5), QString("8.858"));
  f.panel->showSection("");
  QCOMPARE(f.find("span")->text().left(5), QString("9.842"));  // declared in cm as well
  f.type("span", "10");
  QCOMPARE(f.document().span, 0.254);
  QCOMPARE(f.document().motors[0].arm, 0.225);
  QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
}

void TestFormTyping::unitsAreRemembered() {
  QTemporaryDir folder;
  QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
  const auto& field = *schema::typeOf<forms_test::Winding>().field("inductance");
  UnitPreferences(&settings).setShownUnit(field, "mH");
  settings.sync();
  QSettings again(folder.filePath("s.ini"), QSettings::IniFormat);
  QCOMPARE(UnitPreferences(&again).shownUnit(field), QString("mH"));
  const auto& other = *schema::typeOf<forms_test::Winding>().field("resistance");
  QCOMPARE(UnitPreferences(&again).shownUnit(other), QString("Ohm"));
}

void TestFormTyping::wheelOverUnfocusedFieldsDoesNothing() {
  FormFixture f;
  f.find("title")->setFocus();
  const auto roll = [](QWidget* widget) {
    const QPointF at = widget->rect().center();
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
  };
  for (const char* path : {"span", "steps", "start[0]"}) roll(f.find(path));
  roll(f.find<QComboBox>("method"));
  roll(f.find<QComboBox>("wind"));
  QVERIFY(f.document() == Bench());
  auto* span = f.find("span");
  span->setFocus();
  span->setCursorPosition(2);
  roll(span);
  QCOMPARE(f.document().span, 0.26);
}

void TestFormTyping::numbersAreShownShort_data() {
  QTest::addColumn<double>("metres");
  QTest::addColumn<QString>("shown");
  QTest::addRow("0.1 m") << 0.1 << "10";
  QTest::addRow("0.07 m") << 0.07 << "7";
  QTest::addRow("0.29 m") << 0.29 << "29";
  QTest::addRow("1.005 m") << 1.005 << "100.5";
  QTest::addRow("2/3 m") << 2.0 / 3 << "66.66666666666666";
}

void TestFormTyping::numbersAreShownShort() {
  QFETCH(double, metres);
  QFETCH(QString, shown);
  Bench document;
  document.span = metres;
  FormFixture f(document);
  QCOMPARE(f.find("span")->text(), shown);
  f.find("span")->setFocus();
  QTest::keyClick(f.find("span"), Qt::Key_Return);
  QCOMPARE(f.stack().count(), 0);  // looking is not editing
  f.type("span", shown + " ");
  QVERIFY(std::abs(f.document().span - metres) <= 3e-16);
}

void TestFormTyping::pendingTextIsCommittedOnRequest() {
  FormFixture f;
  auto* span = f.find("span");
  span->setFocus();
  span->selectAll();
  QTest::keyClicks(span, "44");
  QCOMPARE(f.document().span, 0.25);
  f.model.commitPendingEdits();
  QCOMPARE(f.document().span, 0.44);
}

void TestFormTyping::readersGetNames() {
  FormFixture f;
  QCOMPARE(f.find("span")->accessibleName(), QString("Span, in cm"));
  QCOMPARE(f.find("span")->accessibleDescription(), QString("Distance between opposite motors."));
  QCOMPARE(f.find("start[1]")->accessibleName(), QString("Start position, y"));
  f.type("span", "0");
  QTRY_VERIFY(f.find("span")->accessibleDescription().contains("above 0"));
  const QString tip = f.find<QLabel>("span.label")->toolTip();
  QVERIFY(tip.contains("above 0 and at most 200 cm") && tip.contains("Thesis, table 3"));
  QCOMPARE(f.find<QLabel>("span.label")->text(), QString("Span&nbsp; <i>b</i>"));
}

QTEST_MAIN(TestFormTyping)
#include "test_form_typing.moc"
