// A copy of unsaved work that outlives a crash. Each running window has a session in the data
// folder: a lock file with its process id, the experiment as last edited, and where it belongs. A
// session whose process is gone is offered for recovery at the next start. A clean end leaves
// nothing behind.
#pragma once

#include <QDateTime>
#include <QFuture>
#include <QLockFile>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "sim/document/experiment.h"

namespace rotorbench {

/// Unsaved work that a window left behind.
struct LostWork {
  QString session;   ///< name of the session's files
  QString document;  ///< file the work belongs to, empty if it was never saved
  QString title;
  QDateTime time;  ///< of the last edit kept
};

class Autosave {
 public:
  /// `folder` is made if needed; without one that can be written nothing is kept.
  explicit Autosave(const QString& folder);
  /// Takes the session's files away: the window ended as it should.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Keeps this state of the work; written in the background, in one step.
  void keep(const Experiment& experiment, const QString& document);
  /// The work is saved or given up.
  void forget();
  /// Returns when what was given to keep() is on disk.
  void flush();

  /// Work of sessions whose process has ended. They are this window's from now on: another window
  /// started meanwhile does not see them.
  std::vector<LostWork> takeLostWork();
  /// The experiment of a lost session. Throws InputError if it cannot be read.
  [[nodiscard]] Experiment recover(const LostWork& work) const;
  void discard(const LostWork& work);

 private:
  [[nodiscard]] QString file(const QString& session, const char* ending) const;
  void removeFiles(const QString& session) const;

  QString folder_, session_;
  QLockFile lock_;
  std::vector<std::unique_ptr<QLockFile>> adopted_;
  QFuture<void> writing_;
};

}  // namespace rotorbench
