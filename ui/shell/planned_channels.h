// The channels the open experiment will record, known before its first run: it is built, not run,
// on another thread, and its recordings asked. Follows the document; a change of a number changes
// no channel.
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>
#include <optional>
#include <vector>

#include "sim/core/channel.h"
#include "ui/shell/document_controller.h"

namespace rotorbench {

class PlannedChannels : public QObject {
  Q_OBJECT

 public:
  explicit PlannedChannels(DocumentController& documents, QObject* parent = nullptr);

 signals:
  /// All channels of all its recordings, each name once; empty as soon as another document is open.
  void found(const std::vector<rotorbench::Channel>& channels);

 private:
  using Channels = std::optional<std::vector<Channel>>;  ///< empty: the experiment cannot be built

  void onOpened();
  void onValueChanged(const QString& path);
  void build();
  void finish();

  DocumentController& documents_;
  QTimer timer_;
  QFutureWatcher<Channels> building_;
  bool outdated_ = false;   ///< the document has changed since the build began
  bool buildable_ = false;  ///< the last build succeeded
};

}  // namespace rotorbench
