// The whole 3D panel: tool bar, view and playback together, and a recording that grows while it is
// shown.
#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "tests/ui/scene/scene_fixture.h"
#include "ui/scene/playback_bar.h"
#include "ui/scene/scene_panel.h"
#include "ui/scene/scene_view.h"

using namespace rotorbench;
using Eigen::Vector3d;

class TestScenePanel : public QObject {
  Q_OBJECT

  std::unique_ptr<ScenePanel> panel_;

 private slots:
  void init() {
    qputenv("ROTORBENCH_SCENE", "drawn");
    panel_ = std::make_unique<ScenePanel>();
    panel_->resize(500, 450);
    panel_->setModel(quadrotorModel());
    panel_->show();
    QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
  }
  void cleanup() { panel_.reset(); }

  void tiesViewAndPlayback() {
    panel_->setRecording(flightAlong([](double t) { return Vector3d(0, 0, t); }, 4.0));
    QCOMPARE(panel_->playback().end(), 4.0);
    QSignalSpy times(panel_.get(), &ScenePanel::timeChanged);
    panel_->setTime(2.0);
    QCOMPARE(times.count(), 1);
    QCOMPARE(panel_->view().stage().pose().position.z(), 2.0);
    panel_->setTime(2.0);
    QCOMPARE(times.count(), 1);
    panel_->view().setFocus();
    QTest::keyClick(&panel_->view(), Qt::Key_Space);
    QVERIFY(panel_->playback().isPlaying());
    QTRY_VERIFY(panel_->view().stage().pose().position.z() > 2.1);
    QTest::keyClick(&panel_->view(), Qt::Key_Space);
    QVERIFY(!panel_->playback().isPlaying());
  }

  void followsARecordingWhileItGrows() {
    auto recording = std::make_shared<Recording>(flightChannels());
    panel_->setRecording(recording);
    QVERIFY(panel_->playback().isFollowing());
    for (int k = 0; k <= 30; ++k) recording->append(flightRow(0.1 * k, {0, 0, 0.1 * k}));
    recording->publish();
    QTRY_COMPARE(panel_->time(), 3.0);
    QCOMPARE(panel_->view().stage().pose().position.z(), 3.0);
    // Looking back stops following; the range grows all the same.
    panel_->setTime(1.0);
    QVERIFY(!panel_->playback().isFollowing());
    recording->append(flightRow(5, {0, 0, 5}));
    recording->publish();
    QTRY_COMPARE(panel_->playback().end(), 5.0);
    QCOMPARE(panel_->time(), 1.0);
    panel_->followLive(true);
    QCOMPARE(panel_->time(), 5.0);
    recording->append(flightRow(6, {0, 0, 6}));
    recording->publish();
    recording->finish();
    QTRY_VERIFY(!panel_->playback().isFollowing());
    QCOMPARE(panel_->time(), 6.0);
  }

  void camerasByButtonAndKey_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<int>("key");
    QTest::addColumn<int>("mode");
    QTest::addRow("chase") << "cameraChase" << int(Qt::Key_C) << int(CameraMode::Chase);
    QTest::addRow("top") << "cameraTop" << int(Qt::Key_T) << int(CameraMode::Top);
  }

  void camerasByButtonAndKey() {
    QFETCH(QString, action);
    QFETCH(int, key);
    QFETCH(int, mode);
    const QImage orbit = panel_->view().grab().toImage();
    panel_->view().setFocus();
    QTest::keyClick(&panel_->view(), static_cast<Qt::Key>(key));
    QCOMPARE(int(panel_->view().cameraMode()), mode);
    QVERIFY(panel_->findChild<QAction*>(action)->isChecked());
    QVERIFY(differingPixels(orbit, panel_->view().grab().toImage()) > 500);
    for (QToolButton* button : panel_->findChildren<QToolButton*>()) {
      if (button->text() == "Orbit") QTest::mouseClick(button, Qt::LeftButton);
    }
    QCOMPARE(panel_->view().cameraMode(), CameraMode::Orbit);
    QCOMPARE(panel_->view().grab().toImage(), orbit);
  }

  void switchesAreInTheMenu() {
    for (const char* name :
         {"showTrail", "showThrust", "showGrid", "showAxes", "showSetPoint", "showWind"}) {
      QAction* action = panel_->findChild<QAction*>(QLatin1String(name));
      QVERIFY2(action, name);
      QVERIFY(action->isChecked());
      const SceneOptions before = panel_->view().options();
      action->trigger();
      QVERIFY(!(panel_->view().options() == before));
      action->trigger();
      QVERIFY(panel_->view().options() == before);
    }
  }

  void anEditKeepsTheCamera() {
    panel_->view().setFocus();
    QTest::keyClick(&panel_->view(), Qt::Key_Left);
    const QImage turned = panel_->view().grab().toImage();
    SceneModel model = quadrotorModel();
    model.fullThrust = 9;
    panel_->setModel(model);
    QCOMPARE(panel_->view().grab().toImage(), turned);
  }

  void snapshotShowsTheInstant() {
    panel_->hide();
    panel_->setRecording(flightStep({0, 0, 0.15}));
    const QImage before = panel_->snapshot({640, 480});
    panel_->setTime(1.5);
    const QImage after = panel_->snapshot({640, 480});
    QCOMPARE(after.size(), QSize(640, 480));
    QVERIFY(centroid(after, isOrange)->y() < centroid(before, isOrange)->y() - 5);
  }

  void anotherRecordingOrNone() {
    panel_->setRecording(flightAlong([](double) { return Vector3d(0, 0, 1); }, 4.0));
    panel_->setTime(3);
    panel_->setRecording(flightAlong([](double) { return Vector3d(0, 0, 2); }, 2.0));
    QCOMPARE(panel_->time(), 2.0);
    QCOMPARE(panel_->view().stage().pose().position.z(), 2.0);
    panel_->setRecording(nullptr);
    QCOMPARE(panel_->time(), 0.0);
    QCOMPARE(panel_->view().stage().pose().position.z(), 0.0);
    panel_->setModel(std::nullopt);
    QTRY_VERIFY(panel_->view().accessibleDescription().contains("no vehicle"));
  }
};

QTEST_MAIN(TestScenePanel)
#include "test_scene_panel.moc"
