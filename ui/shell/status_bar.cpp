#include "ui/shell/status_bar.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>

#include "ui/runs/run_list.h"

namespace rotorbench {

namespace {

constexpr int kProgressSteps = 1000;

QString timeLeft(double seconds) {
  const QLocale locale;
  if (seconds < 1) return StatusBar::tr("less than 1 s left");
  if (seconds < 100) return StatusBar::tr("%1 s left").arg(locale.toString(seconds, 'f', 0));
  return StatusBar::tr("%1 min left").arg(locale.toString(seconds / 60, 'f', 1));
}

QString countText(qsizetype errors, qsizetype warnings) {
  QStringList parts;
  if (errors > 0)
    parts << (errors == 1 ? StatusBar::tr("1 problem") : StatusBar::tr("%1 problems").arg(errors));
  if (warnings > 0) {
    parts << (warnings == 1 ? StatusBar::tr("1 warning")
                            : StatusBar::tr("%1 warnings").arg(warnings));
  }
  return parts.empty() ? StatusBar::tr("No problems") : parts.join(", ");
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
  const QStringList verdicts = verdictTexts(status);
  const QString state = stateText(status);
  run_->setText(verdicts.empty() ? state : tr("%1: %2").arg(state, verdicts.first()));
  run_->setToolTip(verdicts.join('\n'));
  progress_->setVisible(isActive(status.state));
  progress_->setValue(static_cast<int>(kProgressSteps * status.progress.fraction));
  progress_->setFormat(status.secondsLeft ? timeLeft(*status.secondsLeft) : QString("%p %"));
}

void StatusBar::showProblems(const std::vector<Problem>& problems) {
  const auto warnings = std::ranges::count(problems, true, &Problem::warning);
  const auto all = static_cast<qsizetype>(problems.size());
  problems_->setText(countText(all - warnings, warnings));
  const auto worst = std::ranges::find(problems, false, &Problem::warning);
  problems_->setToolTip(problems.empty()
                            ? QString()
                            : QString::fromStdString(
                                  (worst == problems.end() ? problems.front() : *worst).message()));
}

}  // namespace rotorbench
