// The lower edge of the window: the last message, how a run goes, and how many problems the
// document has.
#pragma once

#include <QStatusBar>

#include "sim/run/run_worker.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace rotorbench {

class StatusBar : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusBar(QWidget* parent = nullptr);
  void showRun(const RunStatus& status);
  void showProblems(const std::vector<Problem>& problems);

 signals:
  void problemsClicked();

 private:
  QLabel* run_;
  QProgressBar* progress_;
  QToolButton* problems_;
};

}  // namespace rotorbench
