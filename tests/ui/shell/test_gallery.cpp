// The start page with a spoilt file among the experiments, and the component library from the menu.
#include <QDir>
#include <QFile>

#include "tests/ui/shell/shell_fixture.h"
#include "ui/library/library_dialog.h"
#include "ui/shell/help_viewer.h"

using namespace rotorbench;

class TestGallery : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    useSettingsIn(folder_->path());
  }
  void cleanup() { qunsetenv("ROTORBENCH_RESOURCES"); }
  void oneSpoiltFileHidesNoOther();
  void noSentenceWhereAllIsWell();
  void libraryFromTheMenu();

 private:
  std::unique_ptr<QTemporaryDir> folder_;
};

void TestGallery::oneSpoiltFileHidesNoOther() {
  const QDir shipped(EXPERIMENTS_DIR);
  const QString copy = folder_->filePath("resources/experiments");
  QVERIFY(QDir().mkpath(copy));
  const QStringList files = shipped.entryList(QDir::Files);
  for (const QString& file : files) {
    QVERIFY(QFile::copy(shipped.filePath(file), copy + '/' + file));
  }
  QFile spoilt(copy + "/spoilt.json");
  QVERIFY(spoilt.open(QIODevice::WriteOnly));
  spoilt.write("{\"rotorbench\": 1, \"titel\": \"x\"}");
  spoilt.close();
  qputenv("ROTORBENCH_RESOURCES", folder_->filePath("resources").toUtf8());
  MainWindow window;
  showWindow(window);
  const auto* label = window.findChild<QLabel*>("galleryError");
  QVERIFY(label != nullptr && label->isVisible());
  QVERIFY2(label->text().startsWith("spoilt.json cannot be read: titel"),
           qPrintable(label->text()));
  QVERIFY(label->text().contains("title"));
  QCOMPARE(window.findChildren<GalleryCard*>().size(), files.filter(".json").size());
  openCard(window, "f450-hover-and-steps");
}

void TestGallery::noSentenceWhereAllIsWell() {
  MainWindow window;
  showWindow(window);
  QVERIFY(window.findChild<QLabel*>("galleryError") == nullptr);
}

void TestGallery::libraryFromTheMenu() {
  MainWindow window;
  showWindow(window);
  auto* action = window.findChild<QAction*>("toolLibrary");
  QVERIFY(action != nullptr && action->isEnabled());
  action->trigger();
  LibraryDialog* dialog = nullptr;
  QTRY_VERIFY((dialog = window.findChild<LibraryDialog*>()) != nullptr && dialog->isVisible());
  dialog->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(dialog));
  auto* search = dialog->findChild<QLineEdit*>("librarySearch");
  QTest::mouseClick(search, Qt::LeftButton);
  QTRY_VERIFY(search->hasFocus());
  QTest::keyClick(search, Qt::Key_F1);
  HelpViewer* viewer = nullptr;
  QTRY_VERIFY((viewer = window.findChild<HelpViewer*>("helpViewer")) != nullptr &&
              viewer->isVisible());
  QCOMPARE(viewer->currentPage(), QString("library"));
  QTest::keyClick(dialog, Qt::Key_Escape);
  QTRY_VERIFY(window.findChild<LibraryDialog*>() == nullptr);
}

QTEST_MAIN(TestGallery)
#include "test_gallery.moc"
