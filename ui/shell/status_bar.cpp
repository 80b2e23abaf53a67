#include "ui/shell/status_bar.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>

namespace rotorbench {

namespace {

constexpr int kProgressSteps = 1000;

QString timeLeft(double seconds) {
  const QLocale locale;
  if (seconds < 1) return StatusBar::tr("less than 1 s left");
  if (seconds < 100) return StatusBar::tr("%1 s left").arg(locale.toString(seconds, 'f', 0));
  return StatusBar::tr("%1 min left").arg(locale.toString(seconds / 60, 'f', 1));
}

QString stateText(const RunStatus& status) {
  const QString time = QLocale().toString(status.progress.time, 'f', 2);
  switch (status.state) {
    case RunState::Idle:
      return StatusBar::tr("Not run yet");
    case RunState::Building:
      return StatusBar::tr("Preparing the run");
    case RunState::Running:
      return StatusBar::tr("%1, t = %2 s")
          .arg(QString::fromStdString(status.progress.activity), time);
    case RunState::Paused:
      return StatusBar::tr("Paused, t = %1 s").arg(time);
    case RunState::Finished:
      return StatusBar::tr("Finished");
    case RunState::Failed:
      return StatusBar::tr("Failed");
    case RunState::Stopped:
      return StatusBar::tr("Stopped, t = %1 s").arg(time);
  }
  return {};
}

}  // namespace

StatusBar::StatusBar(QWidget* parent)
    : QStatusBar(parent),
      run_(new QLabel),
      progress_(new QProgressBar),
      problems_(new QToolButton) {
  setObjectName("statusBar");
  run_->setObjectName("runStatus");
  run_->setAccessibleName(tr("State of the run"));
  progress_->setObjectName("runProgress");
  progress_->setAccessibleName(tr("Progress of the run"));
  progress_->setRange(0, kProgressSteps);
  progress_->setFixedWidth(180);
  progress_->setMaximumHeight(fontMetrics().height() + 2);
  problems_->setObjectName("problemCount");
  problems_->setAutoRaise(true);
  addPermanentWidget(run_);
  addPermanentWidget(progress_);
  addPermanentWidget(problems_);
  progress_->hide();
  connect(problems_, &QToolButton::clicked, this, &StatusBar::problemsClicked);
  showProblems({});
}

void StatusBar::showRun(const RunStatus& status) {
  run_->setText(stateText(status));
  progress_->setVisible(isActive(status.state));
  progress_->setValue(static_cast<int>(kProgressSteps * status.progress.fraction));
  progress_->setFormat(status.secondsLeft ? timeLeft(*status.secondsLeft) : QString("%p %"));
}

void StatusBar::showProblems(const std::vector<Problem>& problems) {
  const auto errors = static_cast<int>(std::ranges::count(problems, false, &Problem::warning));
  problems_->setText(errors == 0   ? tr("No problems")
                     : errors == 1 ? tr("1 problem")
                                   : tr("%1 problems").arg(errors));
  problems_->setToolTip(problems.empty() ? QString()
                                         : QString::fromStdString(problems.front().message()));
}

}  // namespace rotorbench
