#include "ui/runs/run_list.h"

#include <QLocale>
#include <algorithm>

#include "ui/runs/run_colors.h"

namespace rotorbench {

bool sameInputs(const Experiment& a, const Experiment& b) {
  const auto inputs = [](Experiment e) {
    e.title.clear();
    e.summary.clear();
    e.notes.clear();
    e.outputs.charts.clear();
    return e;
  };
  return inputs(a) == inputs(b);
}

QStringList verdictTexts(const RunStatus& status) {
  QStringList texts;
  for (const Verdict& verdict : status.verdicts) {
    texts << RunList::tr("%1 at %2 s")
                 .arg(QString::fromStdString(verdict.what),
                      QLocale().toString(verdict.time, 'g', 4));
  }
  return texts;
}

namespace {

/// What else happened, as far as it fits a tool tip; verdicts are told apart.
QStringList eventTexts(const RunStatus& status) {
  constexpr qsizetype kMost = 6;
  QStringList texts;
  for (const RunEvent& event : status.events) {
    if (std::ranges::find(status.verdicts, event.name, &Verdict::name) != status.verdicts.end())
      continue;
    texts << RunList::tr("%1 at %2 s")
                 .arg(QString::fromStdString(event.what), QLocale().toString(event.time, 'g', 4));
  }
  if (texts.size() <= kMost) return texts;
  const auto more = static_cast<int>(texts.size() - kMost + 1);
  return texts.first(kMost - 1) << RunList::tr("and %n more", nullptr, more);
}

QString stateDetail(const RunRecord& record) {
  const QLocale locale;
  if (record.measured) {
    return RunList::tr("Measured, %n row(s)", nullptr,
                       static_cast<int>(record.status.outputs.front().recording->rows()));
  }
  const QString simulated = locale.toString(record.status.progress.time, 'g', 4);
  const QString wall = locale.toString(record.status.wallSeconds, 'g', 2);
  switch (record.status.state) {
    case RunState::Idle:
    case RunState::Building:
      return RunList::tr("Preparing");
    case RunState::Running:
      return RunList::tr("Running, at %1 s").arg(simulated);
    case RunState::Paused:
      return RunList::tr("Paused at %1 s").arg(simulated);
    case RunState::Finished:
      return RunList::tr("Finished, %1 s in %2 s").arg(simulated, wall);
    case RunState::Stopped:
      return RunList::tr("Stopped at %1 s").arg(simulated);
    case RunState::Failed:
      return record.status.outputs.empty() ? RunList::tr("Could not start")
                                           : RunList::tr("Failed at %1 s").arg(simulated);
  }
  return {};
}

}  // namespace

QString runDetail(const RunRecord& record) {
  const QStringList verdicts = verdictTexts(record.status);
  if (verdicts.empty()) return stateDetail(record);
  // The first one leads: the others mostly follow from it. It matters more than how long it took.
  const QString state =
      record.status.state == RunState::Finished ? RunList::tr("Finished") : stateDetail(record);
  return RunList::tr("%1: %2").arg(state, verdicts.first());
}

RunList::RunList(QObject* parent) : QAbstractListModel(parent) {}

const RunRecord* RunList::find(int id) const {
  const int row = rowOf(id);
  return row < 0 ? nullptr : &records_[static_cast<std::size_t>(row)];
}

int RunList::rowOf(int id) const {
  const auto it = std::ranges::find(records_, id, &RunRecord::id);
  return it == records_.end() ? -1 : static_cast<int>(it - records_.begin());
}

RunRecord* RunList::edit(int id) {
  return const_cast<RunRecord*>(find(id));
}

void RunList::announce(int id) {
  const QModelIndex changed = index(rowOf(id));
  emit dataChanged(changed, changed);
}

int RunList::add(const Experiment& experiment) {
  RunRecord record;
  record.name = tr("Run %1: %2").arg(nextId_).arg(QString::fromStdString(experiment.title));
  record.begun = record.experiment = experiment;
  record.status.state = RunState::Building;
  return insert(std::move(record), !sameInputs(experiment, current_));
}

int RunList::addMeasured(const QString& name, const QString& note,
                         std::shared_ptr<const Recording> recording) {
  RunRecord record;
  record.name = name.simplified();
  record.note = note;
  record.measured = true;
  record.status.state = RunState::Finished;
  record.status.outputs.push_back(
      {record.name.toStdString(), std::const_pointer_cast<Recording>(std::move(recording))});
  const int id = insert(std::move(record), false);
  emit runsChanged();
  return id;
}

int RunList::insert(RunRecord record, bool outOfDate) {
  record.id = nextId_++;
  record.color = runColor(record.id - 1);
  record.started = QDateTime::currentDateTime();
  const int id = record.id;
  beginInsertRows({}, 0, 0);
  records_.insert(records_.begin(), std::move(record));
  outOfDate_.insert(outOfDate_.begin(), outOfDate);
  endInsertRows();
  return id;
}

void RunList::setStatus(int id, RunStatus status) {
  RunRecord* record = edit(id);
  if (record == nullptr) return;
  const bool newRecordings = record->status.outputs.size() != status.outputs.size();
  const bool changed = status.changes != nullptr && status.changes != record->status.changes;
  record->status = std::move(status);
  if (changed) {
    setChanges(record->experiment, *record->status.changes);
    record->changed = !(record->experiment == record->begun);
  }
  announce(id);
  if (changed) emit changesMade(id);
  if (newRecordings) emit runsChanged();
}

void RunList::rename(int id, const QString& name) {
  RunRecord* record = edit(id);
  const QString wanted = name.simplified();
  if (record == nullptr || wanted.isEmpty() || wanted == record->name) return;
  record->name = wanted;
  announce(id);
  emit runsChanged();
}

void RunList::setNote(int id, const QString& note) {
  if (RunRecord* record = edit(id)) {
    record->note = note;
    announce(id);
  }
}

void RunList::setVisible(int id, bool visible) {
  RunRecord* record = edit(id);
  if (record == nullptr || record->visible == visible) return;
  record->visible = visible;
  announce(id);
  emit runsChanged();
}

void RunList::remove(int id) {
  const int row = rowOf(id);
  if (row < 0) return;
  beginRemoveRows({}, row, row);
  records_.erase(records_.begin() + row);
  outOfDate_.erase(outOfDate_.begin() + row);
  endRemoveRows();
  emit runsChanged();
}

void RunList::setCurrentExperiment(const Experiment& experiment) {
  current_ = experiment;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const bool outOfDate = !records_[i].measured && !sameInputs(records_[i].begun, current_);
    if (outOfDate == outOfDate_[i]) continue;
    outOfDate_[i] = outOfDate;
    announce(records_[i].id);
  }
}

int RunList::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(records_.size());
}

QVariant RunList::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
  const auto row = static_cast<std::size_t>(index.row());
  const RunRecord& record = records_[row];
  QString detail = runDetail(record);
  if (record.changed) detail = tr("%1 · changed in flight").arg(detail);
  if (outOfDate_[row]) detail = tr("%1 · older inputs").arg(detail);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return record.name;
    case Qt::CheckStateRole:
      return record.visible ? Qt::Checked : Qt::Unchecked;
    case Qt::AccessibleTextRole:
      return tr("%1, %2").arg(record.name, detail);
    case Qt::ToolTipRole: {
      QStringList lines{
          record.name,
          tr("Started %1").arg(QLocale().toString(record.started, QLocale::ShortFormat)), detail};
      lines << verdictTexts(record.status).mid(1) << eventTexts(record.status);
      if (record.status.failure) lines << QString::fromStdString(record.status.failure->message);
      if (!record.note.isEmpty()) lines << record.note;
      return lines.join('\n');
    }
    case IdRole:
      return record.id;
    case ColorRole:
      return record.color;
    case NoteRole:
      return record.note;
    case DetailRole:
      return detail;
    case OutOfDateRole:
      return static_cast<bool>(outOfDate_[row]);
    default:
      return {};
  }
}

bool RunList::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid()) return false;
  const int id = index.data(IdRole).toInt();
  if (role == Qt::EditRole) rename(id, value.toString());
  if (role == Qt::CheckStateRole) setVisible(id, value.toInt() == Qt::Checked);
  return role == Qt::EditRole || role == Qt::CheckStateRole;
}

Qt::ItemFlags RunList::flags(const QModelIndex& index) const {
  return QAbstractListModel::flags(index) | Qt::ItemIsEditable | Qt::ItemIsUserCheckable;
}

}  // namespace rotorbench
