// The runs the charts show: recordings with the name, colour and visibility a person gave them.
// Computed and measured data alike; the window feeds it, panes and signal tree follow its signal.
#pragma once

#include <QColor>
#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "sim/core/recording.h"
#include "sim/run/simulation.h"
#include "ui/charts/column_summary.h"
#include "ui/runs/run_marks.h"

namespace rotorbench {

struct ChartRun {
  QString id;  ///< unique; never shown
  QString name;
  QColor color;
  std::shared_ptr<const Recording> recording;
  bool visible = true;
  bool measured = false;                 ///< drawn as marks without a line
  std::vector<AbsentChannels> absent{};  ///< what it has not, and why
  std::vector<RunMark> marks{};          ///< in the order of their times
};

class RunSet : public QObject {
  Q_OBJECT

 public:
  explicit RunSet(QObject* parent = nullptr) : QObject(parent) {}

  [[nodiscard]] const std::vector<ChartRun>& runs() const { return runs_; }
  [[nodiscard]] const ChartRun* find(const QString& id) const;
  /// All at once; the signal is sent once.
  void setRuns(std::vector<ChartRun> runs);
  /// Adds a run, or replaces the one with this id.
  void add(ChartRun run);
  void remove(const QString& id);
  void setVisible(const QString& id, bool visible);
  void rename(const QString& id, const QString& name);
  void setColor(const QString& id, const QColor& color);
  /// Sends marksChanged() only.
  void setMarks(const QString& id, std::vector<RunMark> marks);

  /// Channels of the visible runs, each name once, in order of appearance. The abscissa is among
  /// them.
  [[nodiscard]] std::vector<Channel> channels() const;
  /// Why a visible run has not one of these channels or patterns, where it says so; else empty.
  [[nodiscard]] QString reasonOfAbsence(const std::vector<std::string>& channels) const;
  /// True while a visible run may still grow.
  [[nodiscard]] bool growing() const;
  /// Summaries shared by all panes; belongs to the GUI thread.
  [[nodiscard]] SummaryCache& summaries() { return summaries_; }

 signals:
  /// Runs were added, removed, shown, hidden, renamed or coloured.
  void changed();
  void marksChanged();

 private:
  ChartRun* edit(const QString& id);

  std::vector<ChartRun> runs_;
  SummaryCache summaries_;
};

}  // namespace rotorbench
