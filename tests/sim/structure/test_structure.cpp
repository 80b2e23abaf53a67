// The house keeps its walls: which room may include which. Data flows experiment -> simulation ->
// recording -> window and never back; nothing in sim/ knows Qt, nothing in ui/ reaches into the
// physics.
#include <QDirIterator>
#include <QRegularExpression>
#include <QtTest>

namespace {

struct Include {
  QString file;    ///< relative to the top folder
  QString target;  ///< as written between the quotes or brackets
};

/// A room is the folder an allowance is given for: "sim/ode", "sim/propulsion/drive", "ui/charts",
/// "app".
QString roomOf(const QString& path) {
  const QStringList parts = path.split('/');
  if (parts.first() == "app") return "app";
  return parts.mid(0, path.startsWith("sim/propulsion/") ? 3 : 2).join('/');
}

/// "sim" for every room of sim, "sim/propulsion" for both of it, else the room itself.
bool allowed(const QString& room, const QStringList& allowance) {
  for (QString at = room; !at.isEmpty(); at = at.section('/', 0, -2))
    if (allowance.contains(at)) return true;
  return false;
}

QList<Include> includesBelow(const QString& folder) {
  static const QRegularExpression line("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]",
                                       QRegularExpression::MultilineOption);
  QList<Include> found;
  const QDir top(SOURCE_DIR);
  QDirIterator files(top.filePath(folder), {"*.h", "*.cpp"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    if (!file.open(QIODevice::ReadOnly)) continue;
    auto matches = line.globalMatch(QString::fromUtf8(file.readAll()));
    while (matches.hasNext()) {
      found.append({top.relativeFilePath(file.fileName()), matches.next().captured(1)});
    }
  }
  return found;
}

bool isOurs(const QString& target) {
  return target.startsWith("sim/") || target.startsWith("ui/") || target.startsWith("app/") ||
         target.startsWith("tests/");
}

bool isQt(const QString& target) {
  static const QRegularExpression qt("^(Q[A-Z]|Qt[A-Z0-9]|Qt3D|qt|q[a-z]+\\.h$)");
  return qt.match(target).hasMatch();
}

/// What each room may include besides itself: a floor knows only floors below it.
const QMap<QString, QStringList>& rules() {
  static const QStringList seenByUi{"sim/core", "sim/document", "sim/run", "sim/io"};
  static const QMap<QString, QStringList> map{
      {"sim/core", {}},
      {"sim/numerics", {"sim/core"}},
      {"sim/io", {"sim/core"}},
      {"sim/logs", {"sim/core", "sim/io"}},
      {"sim/ode", {"sim/core", "sim/numerics"}},
      {"sim/environment", {"sim/core"}},
      {"sim/propulsion/drive", {"sim/core", "sim/environment", "sim/numerics"}},
      {"sim/propulsion/rotor",
       {"sim/core", "sim/environment", "sim/numerics", "sim/propulsion/drive"}},
      {"sim/vehicle", {"sim/core", "sim/environment", "sim/ode", "sim/propulsion"}},
      {"sim/signal", {"sim/core"}},
      {"sim/sensing", {"sim/core", "sim/environment", "sim/signal"}},
      // A speed controller steers a motor through an ESC: it knows their constants, and no rotor. A
      // state feedback designs its gains.
      {"sim/control", {"sim/core", "sim/design", "sim/propulsion/drive", "sim/signal"}},
      {"sim/analysis",
       {"sim/core", "sim/numerics", "sim/signal", "sim/control", "sim/ode", "sim/vehicle"}},
      // Numbers of linear models: no vehicle, no controller.
      {"sim/design", {"sim/core"}},
      {"sim/document",
       {"sim/core", "sim/io", "sim/ode", "sim/environment", "sim/propulsion", "sim/vehicle",
        "sim/signal", "sim/sensing", "sim/control"}},
      {"sim/library", {"sim/core", "sim/io", "sim/propulsion", "sim/vehicle", "sim/document"}},
      {"sim/run",
       {"sim/core", "sim/numerics", "sim/io", "sim/ode", "sim/environment", "sim/propulsion",
        "sim/vehicle", "sim/signal", "sim/sensing", "sim/control", "sim/analysis", "sim/document"}},
      {"sim/fitting", {"sim/core", "sim/numerics", "sim/logs", "sim/propulsion"}},
      {"sim/sizing",
       {"sim/core", "sim/numerics", "sim/environment", "sim/propulsion", "sim/vehicle",
        "sim/analysis", "sim/document", "sim/run"}},
      {"sim/scene",
       {"sim/core", "sim/environment", "sim/propulsion/rotor", "sim/vehicle", "sim/document"}},
      {"sim/validation", {"sim"}},
      {"ui/forms", seenByUi},
      {"ui/runs", seenByUi},
      {"ui/charts", seenByUi + QStringList{"ui/runs"}},
      {"ui/scene", seenByUi + QStringList{"sim/scene", "ui/runs"}},
      {"ui/measurement",
       seenByUi + QStringList{"sim/logs", "sim/fitting", "sim/propulsion", "sim/library",
                              "ui/charts", "ui/forms", "ui/library", "ui/runs"}},
      {"ui/propeller",
       seenByUi + QStringList{"sim/propulsion/rotor", "sim/sizing", "sim/library", "sim/scene",
                              "ui/charts", "ui/forms", "ui/library", "ui/scene", "ui/sizing"}},
      {"ui/library", seenByUi + QStringList{"sim/library", "ui/forms"}},
      {"ui/sizing", seenByUi + QStringList{"sim/sizing", "sim/library", "ui/charts", "ui/forms",
                                           "ui/library", "ui/runs"}},
      {"ui/shell", seenByUi + QStringList{"sim/library", "sim/scene", "ui"}},
      {"app", {"sim", "ui"}},
  };
  return map;
}

/// Why this include may not be; empty if it may.
QString objection(const Include& include) {
  if (include.file.startsWith("sim/") && isQt(include.target))
    return QString("%1 includes %2, but sim/ knows no Qt").arg(include.file, include.target);
  if (!isOurs(include.target)) return {};
  const QString room = roomOf(include.file), target = roomOf(include.target);
  if (!rules().contains(room)) return QString("%1 needs a line in rules()").arg(room);
  if (target == room || allowed(target, rules()[room])) return {};
  return QString("%1 includes %2, but %3 may not know %4")
      .arg(include.file, include.target, room, target);
}

}  // namespace

class TestStructure : public QObject {
  Q_OBJECT
 private slots:
  void roomsIncludeOnlyWhatTheyMay_data();
  void roomsIncludeOnlyWhatTheyMay();
  void roomsAreTheFoldersThereAre();
  void simKnowsNoQt();
  void ourIncludesNameTheirRoom();
  void linesKeepToTheColumnLimit();
  void testsAreNamedAlike();
  void plantedIncludesAreSeen_data();
  void plantedIncludesAreSeen();
  void theCheckSeesWhatIsForbidden_data();
  void theCheckSeesWhatIsForbidden();
};

void TestStructure::roomsIncludeOnlyWhatTheyMay_data() {
  QTest::addColumn<QString>("room");
  for (const QString& room : rules().keys()) QTest::addRow("%s", qPrintable(room)) << room;
}

void TestStructure::roomsIncludeOnlyWhatTheyMay() {
  QFETCH(QString, room);
  const auto includes = includesBelow(room);
  QVERIFY2(!includes.empty(), qPrintable(room + " has a rule and no files"));
  for (const Include& include : includes) {
    const QString why = objection(include);
    QVERIFY2(why.isEmpty(), qPrintable(why));
  }
}

/// Every folder with files has a rule, and every rule a folder.
void TestStructure::roomsAreTheFoldersThereAre() {
  const QDir top(SOURCE_DIR);
  for (const QString part : {"sim", "ui"}) {
    QDirIterator files(top.filePath(part), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      const QString room = roomOf(top.relativeFilePath(files.next()));
      QVERIFY2(rules().contains(room), qPrintable(room + " needs a line in rules()"));
    }
  }
  for (const QString& room : rules().keys())
    QVERIFY2(QFileInfo(top.filePath(room)).isDir(), qPrintable(room + " is not there"));
  QVERIFY2(!top.exists("cmake"), "the top level is the user's: cmake/ does not belong there");
}

/// Text of documents inside raw strings apart.
void TestStructure::linesKeepToTheColumnLimit() {
  constexpr qsizetype kColumns = 100;
  const QDir top(SOURCE_DIR);
  for (const QString part : {"sim", "ui", "app", "tests"}) {
    QDirIterator files(top.filePath(part), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
      for (qsizetype i = 0; i < lines.size(); ++i) {
        QVERIFY2(lines[i].size() <= kColumns || lines[i].contains("R\"("),
                 qPrintable(QString("%1:%2 is %3 columns long")
                                .arg(top.relativeFilePath(file.fileName()))
                                .arg(i + 1)
                                .arg(lines[i].size())));
      }
    }
  }
}

/// test_pid_flight.cpp holds the class TestPidFlight, and the room builds test_pid_flight of it.
void TestStructure::testsAreNamedAlike() {
  static const QRegularExpression runs("\\bQTEST_\\w*MAIN\\(|\\bQTest::qExec\\(");
  const auto textOf = [](const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  };
  int count = 0;
  QDirIterator files(QDir(SOURCE_DIR).filePath("tests"), {"*.cpp"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QFileInfo file(files.next());
    const QString text = textOf(file.filePath()), stem = file.completeBaseName();
    if (!runs.match(text).hasMatch()) continue;
    ++count;
    QString name;
    for (const QString& word : stem.split('_')) name += word.left(1).toUpper() + word.mid(1);
    QVERIFY2(stem.startsWith("test_"), qPrintable(stem + " does not begin with test_"));
    QVERIFY2(text.contains("class " + name + " : "), qPrintable(stem + " has no class " + name));
    QVERIFY2(textOf(file.dir().filePath("CMakeLists.txt")).contains("(" + stem + " "),
             qPrintable("no program is called " + stem));
  }
  QVERIFY(count > 100);
}

void TestStructure::plantedIncludesAreSeen_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("target");
  QTest::addColumn<bool>("forbidden");
  const auto row = [](const char* what, const char* file, const char* target, bool forbidden) {
    QTest::addRow("%s", what) << file << target << forbidden;
  };
  row("a floor above", "sim/core/schema.h", "sim/document/experiment.h", true);
  row("a neighbour", "sim/sensing/ideal_sensors.h", "sim/control/pid.h", true);
  row("the engine from the document", "sim/document/flight.h", "sim/run/simulation.h", true);
  row("a rotor from a controller", "sim/control/pid.h", "sim/propulsion/rotor/rotor.h", true);
  row("the plant from a controller", "sim/control/pid.h", "sim/vehicle/multirotor.h", true);
  row("the drive from a controller", "sim/control/pid.h", "sim/propulsion/drive/esc.h", false);
  row("physics from a general room", "ui/charts/curves.h", "sim/vehicle/multirotor.h", true);
  row("the window from the simulation", "sim/run/preflight.h", "ui/runs/run_list.h", true);
  row("a test from the program", "ui/runs/run_list.h", "tests/headers.h", true);
  row("Qt", "sim/core/error.h", "QString", true);
  row("a folder without a rule", "sim/magic/wand.h", "sim/core/error.h", true);
  row("its own room", "sim/ode/solver.h", "sim/ode/status.h", false);
  row("a floor below", "sim/run/scheduler.h", "sim/signal/task.h", false);
  row("the standard library", "sim/core/error.h", "string", false);
}

void TestStructure::plantedIncludesAreSeen() {
  QFETCH(QString, file);
  QFETCH(QString, target);
  QTEST(!objection({file, target}).isEmpty(), "forbidden");
}

void TestStructure::simKnowsNoQt() {
  const auto includes = includesBelow("sim");
  QVERIFY(includes.size() > 50);
  for (const Include& include : includes) {
    QVERIFY2(!isQt(include.target), qPrintable(include.file + " includes " + include.target));
  }
}

/// Quoted includes start at the top folder, so that the rules above see all of them.
void TestStructure::ourIncludesNameTheirRoom() {
  static const QRegularExpression generated("(^|/)(moc_|ui_)|\\.moc$");
  for (const QString part : {"sim", "ui", "app"}) {
    for (const Include& include : includesBelow(part)) {
      const bool local = QFileInfo::exists(
          QFileInfo(QDir(SOURCE_DIR).filePath(include.file)).dir().filePath(include.target));
      QVERIFY2(
          !local || isOurs(include.target) || generated.match(include.target).hasMatch(),
          qPrintable(include.file + " includes \"" + include.target + "\" without its folder"));
    }
  }
}

void TestStructure::theCheckSeesWhatIsForbidden_data() {
  QTest::addColumn<QString>("target");
  QTest::addColumn<bool>("qt");
  QTest::addRow("class header") << "QString" << true;
  QTest::addRow("module") << "QtCore/qglobal.h" << true;
  QTest::addRow("module folder") << "Qt3DCore/QEntity" << true;
  QTest::addRow("lower case") << "qglobal.h" << true;
  QTest::addRow("standard library") << "queue" << false;
  QTest::addRow("our quantity") << "sim/core/quantity.h" << false;
  QTest::addRow("Eigen") << "Eigen/Dense" << false;
}

void TestStructure::theCheckSeesWhatIsForbidden() {
  QFETCH(QString, target);
  QTEST(isQt(target), "qt");
}

QTEST_GUILESS_MAIN(TestStructure)
#include "test_structure.moc"
