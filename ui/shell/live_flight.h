// What the window changes of a flight that goes on: edits of the form that can act at once, and
// set-points in the hand. Says which fields act now, what could not be changed, and marks every
// change in charts and playback.
#pragma once

#include <QObject>
#include <memory>

#include "ui/runs/run_controller.h"

namespace rotorbench {

class DocumentController;
struct Flight;
class Workbench;

class LiveFlight : public QObject {
  Q_OBJECT

 public:
  LiveFlight(DocumentController& documents, Workbench& bench, RunList& runs,
             RunController& controller, QObject* parent = nullptr);
  ~LiveFlight() override;

 signals:
  /// One sentence for the status bar.
  void message(const QString& sentence);

 private:
  void onStateChanged(RunState state);
  void onDocumentChanged();
  void onUpdated();
  void begin();
  void end();
  void send(const Change& change);
  void showMarks(int id);
  [[nodiscard]] bool flies() const { return told_ != nullptr; }

  DocumentController& documents_;
  Workbench& bench_;
  RunList& runs_;
  RunController& controller_;
  std::unique_ptr<Flight> told_;  ///< the document as the run has been told; null: none goes on
  int run_ = 0;                   ///< its id
  std::size_t refused_ = 0;
  QString saidLater_;  ///< label of the field last said to act from the next run on
};

}  // namespace rotorbench
