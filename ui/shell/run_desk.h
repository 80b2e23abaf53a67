// What happens round a run: it is refused while the document has errors, its recordings appear in
// charts and scene while they grow, its figures and its end are noted, and the scene's time is the
// charts' cursor.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "ui/runs/run_controller.h"
#include "ui/shell/document_controller.h"
#include "ui/shell/live_flight.h"
#include "ui/shell/planned_channels.h"
#include "ui/shell/workbench.h"

namespace rotorbench {

class RunDesk : public QObject {
  Q_OBJECT

 public:
  RunDesk(DocumentController& documents, Workbench& bench, RunList& runs, RunController& controller,
          QObject* parent = nullptr);

  ~RunDesk() override;

  /// Starts a run, or goes on with a paused one.
  void run();
  /// One row further; starts a run that is paused from the beginning if there is none.
  void step();
  /// Speed for experiments that are flown; comparisons always run as fast as possible.
  void setPace(Pace pace);
  /// How the last run of the open document goes or went; idle before its first.
  [[nodiscard]] RunStatus status() const;
  [[nodiscard]] static bool isPaced(const Experiment& experiment);

 signals:
  /// One sentence for the status bar.
  void message(const QString& sentence);

 private:
  void start(bool paused);
  bool refuse();
  void onDocumentOpened();
  void onDocumentChanged();
  void onUpdated();
  void onStateChanged(RunState state);
  void noteEnd(const RunRecord& record);
  void reject(const RunRecord& record);
  [[nodiscard]] std::vector<Problem> doubts() const;
  void showRun(int id);
  void showMarks(const RunRecord& record);
  void showMetrics(int id);
  void fillRunSet();
  void drawDocument();
  void takeOver(int id);

  DocumentController& documents_;
  Workbench& bench_;
  RunList& runs_;
  RunController& controller_;
  /// What the last build refused, and why.
  struct Rejected {
    Experiment experiment;
    std::vector<Problem> problems;
  };
  std::optional<Rejected> rejected_;
  PlannedChannels planned_;
  LiveFlight live_;
  QTimer drawTimer_;
  Pace pace_;
  int shown_ = 0;            ///< the run in the scene
  int earlier_ = 0;          ///< the last run of the document before this one
  bool sceneBound_ = false;  ///< the shown run's recording is in the scene
};

}  // namespace rotorbench
