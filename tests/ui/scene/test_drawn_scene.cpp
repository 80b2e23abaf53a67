// The view where no OpenGL context can be made: it shows the vehicle, says why it looks plainer,
// and answers mouse and keys. Runs offscreen with no display to fall back on.
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/ui/scene/scene_fixture.h"
#include "ui/scene/opengl_probe.h"
#include "ui/scene/scene_view.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

constexpr QSize kSize(480, 360);

std::unique_ptr<SceneView> shownView() {
  std::unique_ptr<SceneView> view(createSceneView(nullptr));
  view->resize(kSize);
  view->setModel(quadrotorModel());
  view->show();
  return view;
}

QImage grabbed(SceneView& view) {
  return view.grab().toImage();
}

/// Without the notice along the lower edge, which is orange as well.
QImage aboveTheNotice(SceneView& view) {
  return grabbed(view).copy(0, 0, kSize.width(), kSize.height() - 60);
}

void turnWheel(QWidget& widget, int delta) {
  const QPointF middle = QRectF(widget.rect()).center();
  QWheelEvent event(middle, widget.mapToGlobal(middle), {}, {0, delta}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace

class TestDrawnScene : public QObject {
  Q_OBJECT
 private slots:
  void cleanup() {
    qunsetenv("ROTORBENCH_SCENE");
    QVERIFY(QApplication::topLevelWidgets().isEmpty());
  }

  void isChosenWithoutOpenGl_data() {
    QTest::addColumn<QByteArray>("wish");
    QTest::addRow("no wish") << QByteArray();
    QTest::addRow("qt3d wished but impossible") << QByteArray("qt3d");
    QTest::addRow("drawn wished") << QByteArray("drawn");
  }

  void isChosenWithoutOpenGl() {
    QFETCH(QByteArray, wish);
    if (!wish.isEmpty()) qputenv("ROTORBENCH_SCENE", wish);
    QVERIFY(!openGlWorks());
    const auto view = shownView();
    QCOMPARE(view->rendererName(), QStringLiteral("drawn"));
    QVERIFY(countPixels(aboveTheNotice(*view), isOrange) > 50);
  }

  void saysWhyAndWhatToDo() {
    const auto view = shownView();
    QTRY_VERIFY(view->accessibleDescription().contains("OpenGL is not available"));
    QVERIFY(view->accessibleDescription().contains("libgl1-mesa-dri"));
    QTRY_VERIFY(view->accessibleDescription().contains("The vehicle at rest"));
    QVERIFY(!view->accessibleName().isEmpty());
    // The sentence is in the picture too, in its own colour.
    const QColor notice = view->stage().colors().notice;
    const QImage image = grabbed(*view).copy(0, kSize.height() - 50, kSize.width() - 90, 50);
    QVERIFY(countPixels(image, [&](QRgb p) {
              return std::abs(qRed(p) - notice.red()) < 40 &&
                     std::abs(qGreen(p) - notice.green()) < 40 && qBlue(p) < 100;
            }) > 50);
  }

  void vehicleMovesWithTime_data() {
    QTest::addColumn<Vector3d>("moved");
    QTest::addColumn<QPoint>("direction");  // signs in the picture, y downwards
    QTest::addRow("up") << Vector3d(0, 0, 0.12) << QPoint(0, -1);
    QTest::addRow("down") << Vector3d(0, 0, -0.12) << QPoint(0, 1);
    QTest::addRow("left") << Vector3d(0, 0.12, 0) << QPoint(-1, -1);
    QTest::addRow("forward") << Vector3d(0.12, 0, 0) << QPoint(1, -1);
  }

  void vehicleMovesWithTime() {
    QFETCH(Vector3d, moved);
    QFETCH(QPoint, direction);
    const auto view = shownView();
    // Nothing of the ground in front of a vehicle that goes below it.
    SceneOptions options;
    options.grid = options.axes = false;
    view->setOptions(options);
    view->setRecording(flightStep(moved));
    const auto before = centroid(aboveTheNotice(*view), isOrange);
    view->setTime(1.5);
    const auto after = centroid(aboveTheNotice(*view), isOrange);
    QVERIFY(before && after);
    const QPointF way = *after - *before;
    const auto sign = [](double v) { return v > 2 ? 1 : v < -2 ? -1 : 0; };
    QCOMPARE(sign(way.x()), direction.x());
    QCOMPARE(sign(way.y()), direction.y());
    QTRY_VERIFY(view->accessibleDescription().contains("Time 1.50 s"));
  }

  void answersMouseAndKeys_data() {
    QTest::addColumn<std::function<void(SceneView&)>>("act");
    using Act = std::function<void(SceneView&)>;
    QTest::addRow("drag") << Act([](SceneView& v) {
      QTest::mousePress(&v, Qt::LeftButton, {}, {200, 200});
      QTest::mouseMove(&v, {260, 220});
      QMouseEvent move(QEvent::MouseMove, QPointF(260, 220), v.mapToGlobal(QPointF(260, 220)),
                       Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&v, &move);
      QTest::mouseRelease(&v, Qt::LeftButton, {}, {260, 220});
    });
    QTest::addRow("wheel") << Act([](SceneView& v) { turnWheel(v, 240); });
    QTest::addRow("left") << Act([](SceneView& v) { QTest::keyClick(&v, Qt::Key_Left); });
    QTest::addRow("up") << Act([](SceneView& v) { QTest::keyClick(&v, Qt::Key_Up); });
    QTest::addRow("plus") << Act([](SceneView& v) { QTest::keyClick(&v, Qt::Key_Plus); });
    QTest::addRow("minus") << Act([](SceneView& v) { QTest::keyClick(&v, Qt::Key_Minus); });
  }

  void answersMouseAndKeys() {
    QFETCH(std::function<void(SceneView&)>, act);
    const auto view = shownView();
    const QImage before = grabbed(*view);
    act(*view);
    QVERIFY(differingPixels(before, grabbed(*view)) > 500);
    QTest::mouseDClick(view.get(), Qt::LeftButton, {}, {10, 200});
    QCOMPARE(grabbed(*view), before);
    act(*view);
    QTest::keyClick(view.get(), Qt::Key_Home);
    QCOMPARE(grabbed(*view), before);
  }

  void zoomingInMakesTheVehicleLarger() {
    const auto view = shownView();
    const int before = countPixels(aboveTheNotice(*view), isOrange);
    turnWheel(*view, 360);
    QVERIFY(countPixels(aboveTheNotice(*view), isOrange) > 1.5 * before);
  }

  void optionsHideTheirThings() {
    const auto view = shownView();
    view->setRecording(flightAlong([](double) { return Vector3d(0, 0, 0.5); }, 1.0));
    QVERIFY(countPixels(grabbed(*view), isGreen) > 100);
    SceneOptions options;
    options.thrust = false;
    options.axes = false;
    view->setOptions(options);
    QCOMPARE(countPixels(grabbed(*view), isGreen), 0);
  }

  void showsTheTrail() {
    const auto view = shownView();
    const auto isBlue = [](QRgb p) { return qBlue(p) > 140 && qRed(p) < 60; };
    SceneOptions options;
    options.axes = false;
    view->setOptions(options);
    view->setRecording(flightAlong([](double t) { return Vector3d(0, 0.4 * t, 0.5); }, 3.0));
    QCOMPARE(countPixels(grabbed(*view), isBlue), 0);
    view->setTime(3.0);
    QVERIFY(countPixels(grabbed(*view), isBlue) > 60);
  }

  void followsTheThemeOfTheWindow() {
    const auto view = shownView();
    QVERIFY(qGray(grabbed(*view).pixel(kSize.width() * 3 / 4, 3)) > 200);
    QPalette dark;
    dark.setColor(QPalette::Window, QColor(45, 48, 52));
    dark.setColor(QPalette::Base, QColor(30, 32, 35));
    dark.setColor(QPalette::Text, QColor(225, 228, 232));
    view->setPalette(dark);
    QVERIFY(qGray(grabbed(*view).pixel(kSize.width() * 3 / 4, 3)) < 60);
    QVERIFY(countPixels(aboveTheNotice(*view), isOrange) > 50);
  }

  void picturesHaveTheirSizeAndNeedNoWindow() {
    const std::unique_ptr<SceneView> view(createSceneView(nullptr));
    view->setModel(quadrotorModel());
    const QImage image = view->renderToImage({801, 403});
    QCOMPARE(image.size(), QSize(801, 403));
    QVERIFY(countPixels(image, isOrange) > 100);
    QVERIFY(view->renderToImage({0, 10}).isNull());
  }

  void saysThatThereIsNoVehicle() {
    const auto view = shownView();
    view->setModel(std::nullopt);
    QTRY_COMPARE(view->accessibleDescription().contains("This experiment has no vehicle to show."),
                 true);
    QCOMPARE(countPixels(aboveTheNotice(*view), isOrange), 0);
  }

  void drawsAtMostThirtyTimesASecondAndOnlyWhenVisible() {
    const auto view = shownView();
    QTRY_VERIFY(view->isVisible());
    QSignalSpy frames(view.get(), &SceneView::frameRendered);
    QElapsedTimer clock;
    clock.start();
    int calls = 0;
    while (clock.elapsed() < 500) {
      view->setTime(1e-3 * ++calls);
      QCoreApplication::processEvents();
    }
    QVERIFY(calls > 100);
    QVERIFY2(frames.count() <= 17 && frames.count() >= 2,
             qPrintable(QString::number(frames.count())));
    view->hide();
    QCoreApplication::processEvents();
    frames.clear();
    view->setTime(5);
    QVERIFY(!frames.wait(150));
    view->show();
    QTRY_VERIFY(!frames.isEmpty());
  }

  void numbersThatOverflowDoNotHurt() {
    const auto view = shownView();
    view->setRecording(flightStep({1e30, -1e30, 1e300}));
    view->setTime(1.5);
    QVERIFY(!grabbed(*view).isNull());
    view->setTime(std::nan(""));
    QCOMPARE(view->time(), 1.5);
  }
};

int main(int argc, char** argv) {
  // With a display the offscreen platform finds GLX; here there must be no OpenGL.
  qunsetenv("DISPLAY");
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication app(argc, argv);
  QApplication::setStyle(QStringLiteral("Fusion"));
  TestDrawnScene test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_drawn_scene.moc"
