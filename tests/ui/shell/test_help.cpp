// The help pages: every link leads to a page, every parameter table exists, every schema type has a
// page, and F1 opens the one that fits.
#include <QListWidget>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QtTest>
#include <functional>
#include <set>

#include "sim/document/resources.h"
#include "tests/ui/shell/shell_fixture.h"
#include "ui/forms/help_table.h"
#include "ui/forms/parameter_form.h"
#include "ui/shell/help_library.h"
#include "ui/shell/help_viewer.h"
#include "ui/shell/schema_types.h"

using namespace rotorbench;

namespace {

QString table(const QString& key) {
  const schema::Type* type = findType(schema::typeOf<Experiment>(), key.toStdString());
  return type == nullptr ? QString() : parameterTableHtml(*type);
}

HelpLibrary library() {
  return {QString::fromStdString((resourceDirectory() / "help").string()), table};
}

void forEachAlternative(const schema::Type& type, std::set<const schema::Type*>& seen,
                        const std::function<void(const schema::Type&)>& visit) {
  if (!seen.insert(&type).second) return;
  visit(type);
  for (const schema::Field& field : type.fields) {
    if (field.kind == schema::Kind::Variant) {
      for (std::size_t i = 0; i < field.options.size(); ++i) {
        forEachAlternative(field.alternativeType(i), seen, visit);
      }
    } else if (!field.isLeaf()) {
      forEachAlternative(field.childType(nullptr, 0), seen, visit);
    }
  }
}

}  // namespace

class TestHelp : public QObject {
  Q_OBJECT

 private slots:
  void linksLeadToPages();
  void parameterTablesExist();
  void everyTypeHasAPage();
  void f1OpensTheFittingPage_data();
  void f1OpensTheFittingPage();
};

void TestHelp::linksLeadToPages() {
  const HelpLibrary help = library();
  QVERIFY(help.pages().size() >= 9);
  QSet<QString> names;
  for (const HelpPage& page : help.pages()) names.insert(page.name);
  for (const HelpPage& page : help.pages()) {
    QVERIFY2(!page.title.isEmpty(), qPrintable(page.name));
    static const QRegularExpression link("href=\"([\\w-]+)\\.html\"");
    auto matches = link.globalMatch(help.html(page.name));
    while (matches.hasNext()) {
      const QString target = matches.next().captured(1);
      QVERIFY2(names.contains(target), qPrintable(page.name + " -> " + target));
    }
  }
}

void TestHelp::parameterTablesExist() {
  QStringList missing;
  const HelpLibrary help(QString::fromStdString((resourceDirectory() / "help").string()),
                         [&missing](const QString& key) {
                           const QString html = table(key);
                           if (html.isEmpty()) missing << key;
                           return html;
                         });
  for (const HelpPage& page : help.pages()) QVERIFY(!help.html(page.name).isEmpty());
  QVERIFY2(missing.isEmpty(), qPrintable(missing.join(' ')));
  QVERIFY(help.html("motor-and-rotor").contains("resistance", Qt::CaseInsensitive));
}

void TestHelp::everyTypeHasAPage() {
  const HelpLibrary help = library();
  QStringList missing;
  std::set<const schema::Type*> seen;
  forEachAlternative(schema::typeOf<Experiment>(), seen, [&](const schema::Type& type) {
    const QString key = QString::fromStdString(type.key);
    const bool found = std::ranges::any_of(help.pages(), [&key](const HelpPage& page) {
      return page.name == key || page.topics.contains(key);
    });
    if (!found) missing << key;
  });
  QVERIFY2(missing.isEmpty(), qPrintable(missing.join(' ')));
}

void TestHelp::f1OpensTheFittingPage_data() {
  QTest::addColumn<QString>("section");
  QTest::addColumn<QString>("page");
  QTest::addRow("solver") << "setup.solver"
                          << "solvers";
  QTest::addRow("controller") << "setup.control"
                              << "controller-1";
  QTest::addRow("vehicle") << "setup.vehicle"
                           << "multirotor";
  QTest::addRow("outputs") << "outputs"
                           << "experiments";
}

void TestHelp::f1OpensTheFittingPage() {
  QFETCH(QString, section);
  QFETCH(QString, page);
  QTemporaryDir folder;
  useSettingsIn(folder.path());
  MainWindow window;
  showWindow(window);
  openCard(window, "f450-hover-and-steps");
  window.workbench().experiment().showSection(section);
  window.workbench().experiment().form()->setFocus();
  QTest::keyClick(&window, Qt::Key_F1);
  HelpViewer* viewer = nullptr;
  QTRY_VERIFY((viewer = window.findChild<HelpViewer*>("helpViewer")) != nullptr &&
              viewer->isVisible());
  QCOMPARE(viewer->currentPage(), page);
  QVERIFY(viewer->findChild<QTextBrowser*>("helpBrowser")->toPlainText().size() > 500);
  QVERIFY(viewer->findChild<QListWidget*>("helpContents")->currentItem() != nullptr);
}

QTEST_MAIN(TestHelp)
#include "test_help.moc"
