// Every run of this session: what was asked (a copy of the experiment), what came out (its
// recordings) and how it is shown. A model of one column; RunsPanel draws it, the charts follow its
// signals.
#pragma once

#include <QAbstractListModel>
#include <QColor>
#include <QDateTime>
#include <QString>
#include <vector>

#include "sim/document/experiment.h"
#include "sim/run/run_worker.h"

namespace rotorbench {

struct RunRecord {
  int id = 0;  ///< unique in the session, never reused
  QString name, note;
  QColor color;
  QDateTime started;
  bool visible = true;
  bool measured = false;  ///< imported data: there is a recording, but no experiment it came from
  Experiment begun;       ///< as it was when the run began
  Experiment experiment;  ///< with all that has changed while it ran: repeats the run
  bool changed = false;   ///< something has
  RunStatus status;       ///< with the recordings
};

/// True if two experiments give the same numbers: titles, notes and chart panes do not count.
bool sameInputs(const Experiment& a, const Experiment& b);

class RunList : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { IdRole = Qt::UserRole, ColorRole, NoteRole, DetailRole, OutOfDateRole };

  explicit RunList(QObject* parent = nullptr);

  [[nodiscard]] const std::vector<RunRecord>& records() const { return records_; }
  /// The record with this id, or null.
  [[nodiscard]] const RunRecord* find(int id) const;
  [[nodiscard]] int rowOf(int id) const;

  /// Adds a run on top of the list; returns its id.
  int add(const Experiment& experiment);
  /// Adds imported data; `note` says where they are from. Returns the id.
  int addMeasured(const QString& name, const QString& note,
                  std::shared_ptr<const Recording> recording);
  void setStatus(int id, RunStatus status);
  void rename(int id, const QString& name);
  void setNote(int id, const QString& note);
  void setVisible(int id, bool visible);
  void remove(int id);
  /// Marks runs whose inputs differ from this document.
  void setCurrentExperiment(const Experiment& experiment);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

 signals:
  /// Recordings were added, removed, shown, hidden or renamed.
  void runsChanged();
  /// The experiment of this run has changed while it goes on; the record has it.
  void changesMade(int id);

 private:
  RunRecord* edit(int id);
  void announce(int id);
  /// Puts a record with id, colour and time on top of the list.
  int insert(RunRecord record, bool outOfDate);

  std::vector<RunRecord> records_;
  std::vector<bool> outOfDate_;
  Experiment current_;
  int nextId_ = 1;
};

/// What a run came to that nobody asked for, in the reader's locale: "below the ground at 3.1 s";
/// empty if nothing.
QStringList verdictTexts(const RunStatus& status);

/// "Measured, 154 rows", "30 s in 0.42 s", "Stopped at 3.2 s of simulated time", in the reader's
/// locale.
QString runDetail(const RunRecord& record);

}  // namespace rotorbench
