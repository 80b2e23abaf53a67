#include "ui/charts/run_set.h"

#include <algorithm>
#include <set>

namespace rotorbench {

const ChartRun* RunSet::find(const QString& id) const {
  const auto at =
      std::find_if(runs_.begin(), runs_.end(), [&](const ChartRun& r) { return r.id == id; });
  return at == runs_.end() ? nullptr : &*at;
}

ChartRun* RunSet::edit(const QString& id) {
  return const_cast<ChartRun*>(find(id));
}

void RunSet::setRuns(std::vector<ChartRun> runs) {
  std::erase_if(runs, [](const ChartRun& run) { return !run.recording; });
  for (const auto& old : runs_) {
    const bool kept = std::any_of(runs.begin(), runs.end(), [&](const ChartRun& run) {
      return run.recording == old.recording;
    });
    if (!kept) summaries_.forget(old.recording.get());
  }
  runs_ = std::move(runs);
  emit changed();
}

void RunSet::add(ChartRun run) {
  auto runs = runs_;
  const auto at =
      std::find_if(runs.begin(), runs.end(), [&](const ChartRun& r) { return r.id == run.id; });
  if (at == runs.end()) {
    runs.push_back(std::move(run));
  } else {
    *at = std::move(run);
  }
  setRuns(std::move(runs));
}

void RunSet::remove(const QString& id) {
  auto runs = runs_;
  std::erase_if(runs, [&](const ChartRun& run) { return run.id == id; });
  setRuns(std::move(runs));
}

void RunSet::setVisible(const QString& id, bool visible) {
  if (auto* run = edit(id); run && run->visible != visible) {
    run->visible = visible;
    emit changed();
  }
}

void RunSet::rename(const QString& id, const QString& name) {
  if (auto* run = edit(id); run && run->name != name) {
    run->name = name;
    emit changed();
  }
}

void RunSet::setColor(const QString& id, const QColor& color) {
  if (auto* run = edit(id); run && run->color != color) {
    run->color = color;
    emit changed();
  }
}

void RunSet::setMarks(const QString& id, std::vector<RunMark> marks) {
  if (auto* run = edit(id)) {
    run->marks = std::move(marks);
    emit marksChanged();
  }
}

std::vector<Channel> RunSet::channels() const {
  std::vector<Channel> all;
  std::set<std::string> seen;
  for (const auto& run : runs_) {
    if (!run.visible) continue;
    for (const auto& channel : run.recording->channels()) {
      if (seen.insert(channel.name).second) all.push_back(channel);
    }
  }
  return all;
}

QString RunSet::reasonOfAbsence(const std::vector<std::string>& channels) const {
  for (const ChartRun& run : runs_) {
    if (!run.visible) continue;
    for (const AbsentChannels& absent : run.absent) {
      const auto begins = [&](const std::string& c) { return c.starts_with(absent.beginning); };
      if (std::ranges::any_of(channels, begins)) return QString::fromStdString(absent.reason);
    }
  }
  return {};
}

bool RunSet::growing() const {
  return std::any_of(runs_.begin(), runs_.end(),
                     [](const ChartRun& run) { return run.visible && !run.recording->finished(); });
}

}  // namespace rotorbench
