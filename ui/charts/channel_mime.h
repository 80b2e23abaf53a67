// How channels travel by drag and drop from the signal tree to a chart.
#pragma once

#include <QMimeData>
#include <QStringList>
#include <memory>

namespace rotorbench {

inline constexpr char kChannelMimeType[] = "application/x-rotorbench-channels";

inline std::unique_ptr<QMimeData> channelMimeData(const QStringList& channels) {
  auto data = std::make_unique<QMimeData>();
  data->setData(kChannelMimeType, channels.join(u'\n').toUtf8());
  data->setText(channels.join(QStringLiteral(", ")));
  return data;
}

inline QStringList channelsIn(const QMimeData* data) {
  if (!data || !data->hasFormat(kChannelMimeType)) return {};
  return QString::fromUtf8(data->data(kChannelMimeType)).split(u'\n', Qt::SkipEmptyParts);
}

}  // namespace rotorbench
