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

/// A room is the folder an allowance is given for: "sim/ode", "ui/charts", "app".
QString roomOf(const QString& path) {
  const QStringList parts = path.split('/');
  return parts.first() == "app" ? QString("app") : parts.mid(0, 2).join('/');
}

/// "sim" for every room of sim, else the room itself.
bool allowed(const QString& room, const QStringList& allowance) {
  return allowance.contains(room) || allowance.contains(room.section('/', 0, 0));
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

}  // namespace

class StructureTest : public QObject {
  Q_OBJECT
 private slots:
  void roomsIncludeOnlyWhatTheyMay_data();
  void roomsIncludeOnlyWhatTheyMay();
  void everyRoomHasARule();
  void simKnowsNoQt();
  void ourIncludesNameTheirRoom();
  void theCheckSeesWhatIsForbidden_data();
  void theCheckSeesWhatIsForbidden();

 private:
  /// What each room may include besides itself. The order is that of the data's way.
  static const QMap<QString, QStringList>& rules();
};

const QMap<QString, QStringList>& StructureTest::rules() {
  static const QStringList seenByUi{"sim/core", "sim/experiment", "sim/io"};
  static const QMap<QString, QStringList> map{
      {"sim/core", {}},
      {"sim/ode", {"sim/core"}},
      {"sim/environment", {"sim/core"}},
      {"sim/propulsion", {"sim/core", "sim/environment"}},
      {"sim/vehicle", {"sim/core", "sim/ode", "sim/environment", "sim/propulsion"}},
      {"sim/sensing", {"sim/core", "sim/vehicle"}},
      {"sim/control", {"sim/core", "sim/propulsion", "sim/vehicle", "sim/sensing"}},
      {"sim/analysis",
       {"sim/core", "sim/ode", "sim/environment", "sim/propulsion", "sim/vehicle", "sim/control"}},
      {"sim/experiment",
       {"sim/core", "sim/ode", "sim/environment", "sim/propulsion", "sim/vehicle", "sim/sensing",
        "sim/control", "sim/analysis", "sim/io"}},
      {"sim/sizing",
       {"sim/core", "sim/ode", "sim/environment", "sim/propulsion", "sim/vehicle", "sim/analysis",
        "sim/experiment"}},
      {"sim/validation", {"sim/core", "sim/io", "sim/propulsion", "sim/experiment"}},
      {"sim/io", {"sim/core"}},
      {"sim/library", {"sim/core", "sim/propulsion", "sim/vehicle", "sim/experiment", "sim/io"}},
      {"sim/measurement", {"sim/core", "sim/io"}},
      {"sim/fitting", {"sim/core", "sim/propulsion", "sim/measurement"}},
      {"ui/forms", seenByUi},
      {"ui/charts", seenByUi + QStringList{"ui/runs"}},
      {"ui/scene", seenByUi + QStringList{"ui/runs"}},
      {"ui/runs", seenByUi},
      {"ui/measurement",
       seenByUi + QStringList{"sim/measurement", "sim/fitting", "sim/propulsion", "sim/library",
                              "ui/charts", "ui/forms", "ui/library", "ui/runs"}},
      {"ui/propeller",
       seenByUi + QStringList{"sim/propulsion", "ui/charts", "ui/forms", "ui/library", "ui/scene"}},
      {"ui/library", seenByUi + QStringList{"sim/library", "ui/forms"}},
      {"ui/sizing", seenByUi + QStringList{"sim/sizing", "sim/library", "ui/charts", "ui/forms",
                                           "ui/library", "ui/runs"}},
      {"ui/shell", seenByUi + QStringList{"sim/library", "ui"}},
      {"app", {"sim", "ui"}},
  };
  return map;
}

void StructureTest::roomsIncludeOnlyWhatTheyMay_data() {
  QTest::addColumn<QString>("room");
  for (const QString& room : rules().keys()) QTest::addRow("%s", qPrintable(room)) << room;
}

void StructureTest::roomsIncludeOnlyWhatTheyMay() {
  QFETCH(QString, room);
  for (const Include& include : includesBelow(room)) {
    if (!isOurs(include.target)) continue;
    const QString target = roomOf(include.target);
    QVERIFY2(target == room || allowed(target, rules()[room]),
             qPrintable(QString("%1 includes %2, but %3 may not know %4")
                            .arg(include.file, include.target, room, target)));
  }
}

void StructureTest::everyRoomHasARule() {
  for (const QString part : {"sim", "ui"}) {
    const QDir folder(QDir(SOURCE_DIR).filePath(part));
    for (const QString& room : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
      const QString name = part + "/" + room;
      QVERIFY2(rules().contains(name), qPrintable(name + " needs a line in rules()"));
    }
  }
}

void StructureTest::simKnowsNoQt() {
  const auto includes = includesBelow("sim");
  QVERIFY(includes.size() > 50);
  for (const Include& include : includes) {
    QVERIFY2(!isQt(include.target), qPrintable(include.file + " includes " + include.target));
  }
}

/// Quoted includes start at the top folder, so that the rules above see all of them.
void StructureTest::ourIncludesNameTheirRoom() {
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

void StructureTest::theCheckSeesWhatIsForbidden_data() {
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

void StructureTest::theCheckSeesWhatIsForbidden() {
  QFETCH(QString, target);
  QTEST(isQt(target), "qt");
}

QTEST_GUILESS_MAIN(StructureTest)
#include "structure_test.moc"
