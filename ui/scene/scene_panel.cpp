#include "ui/scene/scene_panel.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/scene/hand_bar.h"
#include "ui/scene/playback_bar.h"
#include "ui/scene/scene_hud.h"
#include "ui/scene/scene_view.h"

namespace rotorbench {
namespace {

constexpr int kGrowthMs = 33;

}  // namespace

ScenePanel::ScenePanel(QWidget* parent)
    : QWidget(parent),
      view_(createSceneView(this)),
      playback_(new PlaybackBar(this)),
      hand_(new HandBar(view_, this)),
      tools_(new QToolBar(this)) {
  setObjectName(QStringLiteral("scenePanel"));
  setAccessibleName(tr("3D scene"));
  buildToolBar();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(tools_);
  column->addWidget(view_, 1);
  column->addWidget(playback_);
  column->addWidget(hand_);
  connect(playback_, &PlaybackBar::timeChanged, this, [this](double time) {
    view_->setTime(time);
    emit timeChanged(time);
  });
  connect(view_, &SceneView::playPauseRequested, playback_,
          [this] { playback_->setPlaying(!playback_->isPlaying()); });
  growth_.setInterval(kGrowthMs);
  connect(&growth_, &QTimer::timeout, this, &ScenePanel::updateRange);
}

QAction* ScenePanel::addCamera(const char* name, const QString& text, const QString& key,
                               CameraMode mode) {
  QAction* action = tools_->addAction(cameraName(mode));
  action->setObjectName(QLatin1String(name));
  action->setCheckable(true);
  action->setChecked(mode == view_->cameraMode());
  action->setShortcut(QKeySequence(key));
  action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  action->setToolTip(tr("%1 (%2)").arg(text, key));
  addAction(action);
  connect(action, &QAction::triggered, view_, [this, mode] { view_->setCameraMode(mode); });
  connect(view_, &SceneView::cameraModeChanged, action,
          [action, mode](CameraMode now) { action->setChecked(now == mode); });
  return action;
}

void ScenePanel::addSwitch(const char* name, const QString& text, bool SceneOptions::*option) {
  auto* menu = tools_->findChild<QMenu*>(QStringLiteral("showMenu"));
  QAction* action = menu->addAction(text);
  action->setObjectName(QLatin1String(name));
  action->setCheckable(true);
  action->setChecked(view_->options().*option);
  connect(action, &QAction::toggled, view_, [this, option](bool on) {
    SceneOptions options = view_->options();
    options.*option = on;
    view_->setOptions(options);
  });
}

void ScenePanel::buildToolBar() {
  tools_->setObjectName(QStringLiteral("sceneTools"));
  tools_->setAccessibleName(tr("3D scene tools"));
  tools_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  auto* cameras = new QActionGroup(this);
  cameras->addAction(addCamera("cameraOrbit", tr("Stand in the room and look at the vehicle"),
                               QStringLiteral("O"), CameraMode::Orbit));
  cameras->addAction(addCamera("cameraChase", tr("Fly behind the vehicle"), QStringLiteral("C"),
                               CameraMode::Chase));
  cameras->addAction(addCamera("cameraTop", tr("Look down from above, forward is up"),
                               QStringLiteral("T"), CameraMode::Top));
  QAction* reset = tools_->addAction(tr("Reset"));
  reset->setObjectName(QStringLiteral("cameraReset"));
  reset->setToolTip(tr("Put the camera back where it was (Home)"));
  connect(reset, &QAction::triggered, view_, &SceneView::resetCamera);
  tools_->addSeparator();

  auto* show = new QToolButton(tools_);
  show->setObjectName(QStringLiteral("showButton"));
  show->setText(tr("Show"));
  show->setAccessibleName(tr("What the 3D scene shows"));
  show->setToolTip(tr("Choose what is drawn."));
  show->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(show);
  menu->setObjectName(QStringLiteral("showMenu"));
  show->setMenu(menu);
  tools_->addWidget(show);
  addSwitch("showTrail", tr("Trail"), &SceneOptions::trail);
  addSwitch("showThrust", tr("Thrust arrows"), &SceneOptions::thrust);
  addSwitch("showGrid", tr("Ground grid"), &SceneOptions::grid);
  addSwitch("showAxes", tr("Axes"), &SceneOptions::axes);
  addSwitch("showSetPoint", tr("Set-point"), &SceneOptions::setPoint);
  addSwitch("showWind", tr("Wind"), &SceneOptions::wind);
  for (QToolButton* button : tools_->findChildren<QToolButton*>()) {
    button->setFocusPolicy(Qt::StrongFocus);
    if (button->accessibleName().isEmpty()) button->setAccessibleName(button->text());
  }
}

void ScenePanel::setModel(std::optional<SceneModel> model) {
  view_->setModel(std::move(model));
}

void ScenePanel::setRecording(std::shared_ptr<const Recording> recording) {
  recording_ = std::move(recording);
  playback_->setPlaying(false);
  view_->setRecording(recording_);
  const bool live = recording_ && !recording_->finished();
  playback_->setFollowing(live);
  updateRange();
  view_->setTime(playback_->time());
  if (live) growth_.start();
}

void ScenePanel::updateRange() {
  // Asked before the rows are read: whatever was published before the end is then seen below.
  const bool live = recording_ && !recording_->finished();
  const std::size_t rows = recording_ ? recording_->rows() : 0;
  if (rows == 0) {
    playback_->setRange(0, 0, live);
  } else {
    const double before = playback_->end();
    playback_->setRange(recording_->value(0, 0), recording_->value(0, rows - 1), live);
    if (before != playback_->end() && !playback_->isFollowing()) view_->setTime(playback_->time());
  }
  tellHand();
  if (live) return;
  growth_.stop();
  playback_->setFollowing(false);
}

/// Hands take a set-point from where it is.
void ScenePanel::tellHand() {
  static constexpr const char* kNames[] = {"setpoint.z", "setpoint.roll", "setpoint.pitch",
                                           "setpoint.yaw"};
  const std::size_t rows = recording_ ? recording_->rows() : 0;
  if (rows == 0) return;
  std::array<double, 4> asked{};
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (const auto column = recording_->find(kNames[i]))
      asked[i] = recording_->value(*column, rows - 1);
  hand_->setAsked(asked);
}

void ScenePanel::setTime(double time) {
  playback_->setTime(time);
}

void ScenePanel::followLive(bool follow) {
  playback_->setFollowing(follow);
}

void ScenePanel::resetView() {
  view_->setCameraMode(CameraMode::Orbit);
  view_->resetCamera();
  playback_->setPlaying(false);
  playback_->setLooping(false);
  playback_->setSpeed(1);
}

QImage ScenePanel::snapshot(const QSize& size) {
  updateRange();
  return view_->renderToImage(size);
}

double ScenePanel::time() const {
  return playback_->time();
}

void ScenePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  updateRange();
}

}  // namespace rotorbench
