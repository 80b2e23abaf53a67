// The Qt 3D view on a real (software) OpenGL: what it renders is read back pixel by pixel. Needs an
// X server with GLX; run under xvfb-run.
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <atomic>

#include "tests/ui/scene/scene_fixture.h"
#include "ui/scene/opengl_probe.h"
#include "ui/scene/scene_view.h"

using namespace rotorbench;
using Eigen::Vector3d;

namespace {

constexpr QSize kSize(480, 360);
std::atomic<int> warnings{0};

void countWarnings(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtWarningMsg || type == QtCriticalMsg) ++warnings;
  std::fprintf(stderr, "%s\n", qPrintable(text));
}

/// Nothing but the vehicle.
SceneOptions vehicleOnly() {
  SceneOptions options;
  options.trail = options.thrust = options.grid = options.axes = options.setPoint = false;
  return options;
}

std::unique_ptr<SceneView> makeView() {
  std::unique_ptr<SceneView> view(createSceneView(nullptr));
  view->resize(kSize);
  view->setModel(quadrotorModel());
  return view;
}

/// Pixels that are not background, below the writing along the upper edge.
int vehiclePixels(const QImage& image, const QColor& background) {
  return countPixels(image.copy(0, 45, image.width(), image.height() - 90), [&](QRgb p) {
    return std::abs(qRed(p) - background.red()) + std::abs(qGreen(p) - background.green()) +
               std::abs(qBlue(p) - background.blue()) >
           30;
  });
}

}  // namespace

class TestScenePixels : public QObject {
  Q_OBJECT
 private slots:
  void init() { warnings = 0; }
  void cleanup() {
    QVERIFY(QApplication::topLevelWidgets().isEmpty());
    QVERIFY2(warnings < 5, qPrintable(QString::number(warnings)));
  }

  void rendersWithQt3d() {
    QVERIFY(openGlWorks());
    const auto view = makeView();
    QCOMPARE(view->rendererName(), QStringLiteral("Qt 3D"));
    view->setOptions(vehicleOnly());
    const QImage image = view->renderToImage(kSize);
    QCOMPARE(image.size(), kSize);
    const QColor background = view->stage().colors().background;
    QCOMPARE(QColor(image.pixel(5, kSize.height() / 2)), background);
    QCOMPARE(QColor(image.pixel(kSize.width() / 2, kSize.height() - 5)), background);
    const int vehicle = vehiclePixels(image, background);
    const int all = kSize.width() * kSize.height();
    QVERIFY2(vehicle > 0.02 * all && vehicle < 0.4 * all, qPrintable(QString::number(vehicle)));
    QVERIFY(countPixels(image, isOrange) > 100);
    QCOMPARE(countPixels(image, isGreen), 0);
  }

  void smoothsEdges() {
    // With four samples a pixel, an arm's edge has colours between arm and background.
    const auto view = makeView();
    view->setOptions(vehicleOnly());
    const QImage image = view->renderToImage(kSize);
    const int halfTones = countPixels(image, [](QRgb p) {
      return qRed(p) > 215 && qGreen(p) > 130 && qGreen(p) < 215 && qBlue(p) < qGreen(p) - 15;
    });
    QVERIFY2(halfTones > 30, qPrintable(QString::number(halfTones)));
  }

  void vehicleMovesTheRightWay_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<Vector3d>("moved");
    QTest::addColumn<QPoint>("direction");  // signs in the picture, y downwards
    const int orbit = static_cast<int>(CameraMode::Orbit);
    const int top = static_cast<int>(CameraMode::Top);
    QTest::addRow("up") << orbit << Vector3d(0, 0, 0.12) << QPoint(0, -1);
    QTest::addRow("down") << orbit << Vector3d(0, 0, -0.12) << QPoint(0, 1);
    QTest::addRow("left") << orbit << Vector3d(0, 0.12, 0) << QPoint(-1, -1);
    QTest::addRow("forward") << orbit << Vector3d(0.12, 0, 0) << QPoint(1, -1);
    QTest::addRow("from above, forward is up") << top << Vector3d(0.12, 0, 0) << QPoint(0, -1);
    QTest::addRow("from above, left is left") << top << Vector3d(0, 0.12, 0) << QPoint(-1, 0);
  }

  void vehicleMovesTheRightWay() {
    QFETCH(int, mode);
    QFETCH(Vector3d, moved);
    QFETCH(QPoint, direction);
    const auto view = makeView();
    view->setCameraMode(static_cast<CameraMode>(mode));
    view->setOptions(vehicleOnly());
    view->setRecording(flightStep(moved));
    const auto before = centroid(view->renderToImage(kSize), isOrange);
    view->setTime(1.5);
    const auto after = centroid(view->renderToImage(kSize), isOrange);
    QVERIFY(before && after);
    const auto sign = [](double v) { return v > 2 ? 1 : v < -2 ? -1 : 0; };
    QCOMPARE(sign(after->x() - before->x()), direction.x());
    QCOMPARE(sign(after->y() - before->y()), direction.y());
  }

  void rotorsTurnOnlyIfTheySpin_data() {
    QTest::addColumn<double>("speed");
    QTest::addRow("spinning") << 600.0;
    QTest::addRow("standing") << 0.0;
  }

  void rotorsTurnOnlyIfTheySpin() {
    QFETCH(double, speed);
    const auto view = makeView();
    view->setOptions(vehicleOnly());
    view->setRecording(flightAlong([](double) { return Vector3d(0, 0, 0.5); }, 2.0, speed));
    // Below the clock in the corner, which changes too.
    const QRect below(0, 45, kSize.width(), kSize.height() - 45);
    const QImage before = view->renderToImage(kSize).copy(below);
    view->setTime(0.03);
    const int changed = differingPixels(before, view->renderToImage(kSize).copy(below));
    if (speed > 0) {
      QVERIFY2(changed > 200, qPrintable(QString::number(changed)));
    } else {
      QCOMPARE(changed, 0);
    }
  }

  void camerasDiffer() {
    const auto view = makeView();
    view->setOptions(vehicleOnly());
    QList<QImage> images;
    for (const auto mode : {CameraMode::Orbit, CameraMode::Chase, CameraMode::Top}) {
      view->setCameraMode(mode);
      images.append(view->renderToImage(kSize));
      QVERIFY(countPixels(images.last(), isOrange) > 50);
    }
    QVERIFY(differingPixels(images[0], images[1]) > 1000);
    QVERIFY(differingPixels(images[1], images[2]) > 1000);
    view->setCameraMode(CameraMode::Orbit);
    QTest::keyClick(view.get(), Qt::Key_Left);
    QVERIFY(differingPixels(images[0], view->renderToImage(kSize)) > 1000);
    view->resetCamera();
    QCOMPARE(differingPixels(images[0], view->renderToImage(kSize)), 0);
  }

  void agreesWithTheDrawnView() {
    const auto view = makeView();
    view->setOptions(vehicleOnly());
    qputenv("ROTORBENCH_SCENE", "drawn");
    const auto drawn = makeView();
    qunsetenv("ROTORBENCH_SCENE");
    QCOMPARE(drawn->rendererName(), QStringLiteral("drawn"));
    drawn->setOptions(vehicleOnly());
    const auto a = centroid(view->renderToImage(kSize), isOrange);
    const auto b = centroid(drawn->renderToImage(kSize), isOrange);
    QVERIFY(a && b);
    QVERIFY2(QLineF(*a, *b).length() < 6, qPrintable(QString::number(QLineF(*a, *b).length())));
  }

  void thrustTrailAndSetPointAppear() {
    const auto view = makeView();
    view->setRecording(flightAlong([](double t) { return Vector3d(0, 0.3 * t, 0.6); }, 3.0));
    view->setTime(3.0);
    SceneOptions options = vehicleOnly();
    options.thrust = true;
    view->setOptions(options);
    QVERIFY(countPixels(view->renderToImage(kSize), isGreen) > 100);
    options = vehicleOnly();
    options.trail = true;
    view->setOptions(options);
    const auto isBlue = [](QRgb p) { return qBlue(p) > 110 && qRed(p) < 60; };
    QVERIFY(countPixels(view->renderToImage(kSize), isBlue) > 60);
    options = vehicleOnly();
    view->setOptions(options);
    QVERIFY(countPixels(view->renderToImage(kSize), isBlue) < 10);
  }

  void survivesHidingDockingAndFloating() {
    QMainWindow window;
    window.resize(800, 600);
    auto* dock = new QDockWidget("3D", &window);
    auto* view = makeView().release();
    dock->setWidget(view);
    window.addDockWidget(Qt::RightDockWidgetArea, dock);
    QSignalSpy frames(view, &SceneView::frameRendered);
    window.show();
    const auto shows = [&] {
      frames.clear();
      view->setTime(view->time() + 0.01);
      return frames.wait(5000) && countPixels(view->grab().toImage(), isOrange) > 50;
    };
    QVERIFY(shows());
    dock->setFloating(true);
    QTRY_VERIFY(dock->isFloating());
    QVERIFY(shows());
    dock->hide();
    QTRY_VERIFY(!view->isVisible());
    frames.clear();
    view->setTime(1);
    QVERIFY(!frames.wait(200));
    dock->show();
    QTRY_VERIFY(view->isVisible());
    QVERIFY(shows());
    dock->setFloating(false);
    QVERIFY(shows());
    window.resize(1000, 700);
    QVERIFY(shows());
  }

  void comesAndGoes() {
    for (int round = 0; round < 5; ++round) {
      const auto view = makeView();
      view->setRecording(flightAlong([](double t) { return Vector3d(0, 0, t); }, 1.0));
      QSignalSpy frames(view.get(), &SceneView::frameRendered);
      view->show();
      QVERIFY(frames.wait(5000));
      // Gone with a picture under way on every other round.
      if (round % 2 == 0) {
        view->setTime(0.5);
        QTest::qWait(5);
      }
    }
  }

  void modelsAndThemesChangeInPlace() {
    const auto view = makeView();
    view->setOptions(vehicleOnly());
    const QImage quad = view->renderToImage(kSize);
    view->setModel(birotorModel(true));
    const QImage bar = view->renderToImage(kSize);
    QVERIFY(differingPixels(quad, bar) > 1000);
    QVERIFY(vehiclePixels(bar, view->stage().colors().background) > 500);
    QPalette dark;
    dark.setColor(QPalette::Window, QColor(45, 48, 52));
    dark.setColor(QPalette::Base, QColor(30, 32, 35));
    dark.setColor(QPalette::Text, QColor(225, 228, 232));
    view->setPalette(dark);
    view->setModel(quadrotorModel());
    const QImage night = view->renderToImage(kSize);
    QVERIFY(qGray(night.pixel(5, 200)) < 60);
    QVERIFY(vehiclePixels(night, view->stage().colors().background) > 2000);
  }
};

int main(int argc, char** argv) {
  setSceneSurfaceFormat();
  QApplication app(argc, argv);
  QApplication::setStyle(QStringLiteral("Fusion"));
  qInstallMessageHandler(countWarnings);
  TestScenePixels test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_scene_pixels.moc"
