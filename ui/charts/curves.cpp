#include "ui/charts/curves.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <map>

#include "ui/charts/channel_pattern.h"
#include "ui/runs/run_colors.h"

namespace rotorbench {
namespace {

constexpr int kMostQuantities = 3;

QString channelKey(const Curve& curve) {
  return QString::fromStdString(curve.x().name + "|" + curve.y().name);
}
QString runChannelKey(const Curve& curve) {
  return curve.runId + u'|' + channelKey(curve);
}

/// Distinct last parts of channel names, or the full name if there is only one channel.
QString quantityOf(const std::vector<QString>& names) {
  QStringList distinct, last;
  for (const auto& name : names) {
    if (!distinct.contains(name)) distinct += name;
    const QString part = name.section(u'.', -1);
    if (!last.contains(part)) last += part;
  }
  if (distinct.size() == 1) return distinct.first();
  return last.size() <= kMostQuantities ? last.join(QStringLiteral(", ")) : QString();
}

/// Each name without the parts that all begin and end with; at least one part of each is left.
/// Empty if all are alike.
std::map<QString, QString> toldApart(const QStringList& names, const QRegularExpression& separators,
                                     const QString& joint) {
  QList<QStringList> parts;
  for (const QString& name : names) {
    const QStringList some = name.split(separators, Qt::SkipEmptyParts);
    if (some.isEmpty()) return {};
    parts << some;
  }
  if (names.isEmpty() || names.count(names.front()) == names.size()) return {};
  const auto removeCommon = [&parts](bool first) {
    const auto end = [first](const QStringList& p) { return first ? p.front() : p.back(); };
    const auto spare = [&](const QStringList& p) {
      return p.size() > 1 && end(p) == end(parts.front());
    };
    while (std::ranges::all_of(parts, spare)) {
      for (QStringList& p : parts) p.removeAt(first ? 0 : p.size() - 1);
    }
  };
  removeCommon(true);
  removeCommon(false);
  std::map<QString, QString> shortened;
  for (qsizetype i = 0; i < names.size(); ++i) shortened[names[i]] = parts[i].join(joint);
  return shortened;
}

/// Labels, long and short, by what tells the curves apart.
void setLabels(std::vector<Curve>& curves, bool severalRuns) {
  // Where all show the same channel, the axis names it.
  const bool severalChannels = std::ranges::any_of(
      curves, [&](const Curve& curve) { return curve.y().name != curves.front().y().name; });
  QStringList runNames, channelNames;
  for (const Curve& curve : curves) {
    runNames << curve.runName;
    channelNames << QString::fromStdString(curve.y().name);
  }
  static const QRegularExpression phrases(QStringLiteral(", |: ")), steps(QStringLiteral("\\."));
  const auto runs = toldApart(runNames, phrases, QStringLiteral(", "));
  const auto channels = toldApart(channelNames, steps, QStringLiteral("."));
  const auto shortOf = [](const std::map<QString, QString>& known, const QString& name) {
    const auto at = known.find(name);
    return at == known.end() ? name : at->second;
  };
  const QString colon = QStringLiteral(": ");
  for (Curve& curve : curves) {
    const QString name = QString::fromStdString(curve.y().name);
    const QString run = shortOf(runs, curve.runName), channel = shortOf(channels, name);
    curve.label = !severalRuns       ? name
                  : !severalChannels ? curve.runName
                                     : curve.runName + colon + name;
    curve.shortLabel = !severalRuns ? channel : !severalChannels ? run : run + colon + channel;
  }
}

/// Several runs: colour by run, dash by rotor or else by channel. One run: colour by channel.
void setStyles(std::vector<Curve>& curves, bool severalRuns, const RunSet& runs, bool markers) {
  std::map<std::string, int> order;
  for (auto& curve : curves) {
    const int ordinal =
        order.try_emplace(curve.x().name + "|" + curve.y().name, static_cast<int>(order.size()))
            .first->second;
    const int index = indexInName(curve.y().name);
    const int indexDash = index > 0 ? (index - 1) % kDashCount : 0;
    const bool measured = runs.find(curve.runId)->measured;
    curve.style.markers = markers || measured;
    curve.style.line = !measured;
    if (severalRuns) {
      curve.style.color = runs.find(curve.runId)->color;
      curve.style.dash = index > 0 ? indexDash : ordinal % kDashCount;
    } else {
      curve.style.color = runColor(ordinal);
      curve.style.dash = indexDash;
    }
  }
}

}  // namespace

bool HiddenCurves::contains(const Curve& curve) const {
  return channels_.contains(channelKey(curve)) || runChannels_.contains(runChannelKey(curve));
}

void HiddenCurves::toggle(const Curve& curve, const std::vector<Curve>& curves) {
  const bool severalRuns = std::any_of(
      curves.begin(), curves.end(), [&](const Curve& other) { return other.runId != curve.runId; });
  const bool hide = !contains(curve);
  if (!severalRuns) {
    runChannels_.remove(runChannelKey(curve));
    if (hide) {
      channels_.insert(channelKey(curve));
    } else {
      channels_.remove(channelKey(curve));
    }
    return;
  }
  if (channels_.remove(channelKey(curve))) {
    for (const auto& other : curves) {
      if (channelKey(other) == channelKey(curve)) runChannels_.insert(runChannelKey(other));
    }
  }
  if (hide) {
    runChannels_.insert(runChannelKey(curve));
  } else {
    runChannels_.remove(runChannelKey(curve));
  }
}

void HiddenCurves::clear() {
  channels_.clear();
  runChannels_.clear();
}

CurveList chartCurves(const ChartSpec& spec, const RunSet& runs, const HiddenCurves& hidden) {
  CurveList list;
  for (const auto& run : runs.runs()) {
    if (!run.visible) continue;
    for (const auto& channels : resolveCurves(spec, run.recording->channels())) {
      Curve curve{run.id, run.name, run.recording, channels.x, channels.y, {}, {}, 0, {}, false};
      const auto at = std::find(list.units.begin(), list.units.end(), curve.y().unit);
      curve.axis = static_cast<std::size_t>(at - list.units.begin());
      if (at == list.units.end()) list.units.push_back(curve.y().unit);
      curve.hidden = hidden.contains(curve);
      list.curves.push_back(std::move(curve));
    }
  }
  const bool severalRuns =
      std::any_of(list.curves.begin(), list.curves.end(),
                  [&](const Curve& curve) { return curve.runId != list.curves.front().runId; });
  setStyles(list.curves, severalRuns, runs, spec.markers);
  setLabels(list.curves, severalRuns);
  return list;
}

QString axisQuantity(const CurveList& list, std::size_t axis) {
  std::vector<QString> names;
  for (const auto& curve : list.curves) {
    if (curve.axis == axis) names.push_back(QString::fromStdString(curve.y().name));
  }
  return quantityOf(names);
}

QString abscissaQuantity(const CurveList& list) {
  std::vector<QString> names;
  for (const auto& curve : list.curves) names.push_back(QString::fromStdString(curve.x().name));
  return names.empty() ? QStringLiteral("time") : quantityOf(names);
}

}  // namespace rotorbench
