#include "ui/shell/autosave.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QSet>
#include <QUuid>
#include <QtConcurrentRun>

#include "sim/document/experiment_file.h"

namespace rotorbench {

namespace {

constexpr auto kWork = ".json";
constexpr auto kMeta = ".meta";
constexpr auto kLock = ".lock";

// The experiment goes last: a session counts as lost work only once it is there.
void writeSession(const QString& metaFile, const QByteArray& meta, const QString& workFile,
                  const Experiment& experiment) {
  QSaveFile description(metaFile);
  if (!description.open(QIODevice::WriteOnly)) return;
  description.write(meta);
  if (!description.commit()) return;
  QSaveFile work(workFile);
  if (!work.open(QIODevice::WriteOnly)) return;
  work.write(QByteArray::fromStdString(writeExperiment(experiment)));
  work.commit();
}

QJsonObject readMeta(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                        : QJsonObject();
}

}  // namespace

Autosave::Autosave(const QString& folder)
    : folder_(folder),
      session_(QUuid::createUuid().toString(QUuid::WithoutBraces)),
      lock_(file(session_, kLock)) {
  QDir().mkpath(folder_);
  // A lock is stale only when its process is gone, however old it is.
  lock_.setStaleLockTime(0);
  lock_.tryLock();
}

Autosave::~Autosave() {
  forget();
}

void Autosave::keep(const Experiment& experiment, const QString& document) {
  flush();
  const QJsonObject meta{{"document", document},
                         {"title", QString::fromStdString(experiment.title)},
                         {"time", QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}};
  writing_ = QtConcurrent::run(writeSession, file(session_, kMeta), QJsonDocument(meta).toJson(),
                               file(session_, kWork), experiment);
}

void Autosave::forget() {
  flush();
  removeFiles(session_);
}

void Autosave::flush() {
  writing_.waitForFinished();
}

std::vector<LostWork> Autosave::takeLostWork() {
  std::vector<LostWork> found;
  // By both endings: a lock alone is a crash without unsaved work, work alone was left for later.
  QSet<QString> sessions;
  for (const QFileInfo& info : QDir(folder_).entryInfoList(
           {QString("*") + kLock, QString("*") + kWork}, QDir::Files, QDir::Time)) {
    sessions.insert(info.completeBaseName());
  }
  for (const QString& session : sessions) {
    if (session == session_) continue;
    auto lock = std::make_unique<QLockFile>(file(session, kLock));
    lock->setStaleLockTime(0);
    if (!lock->tryLock()) continue;
    if (!QFile::exists(file(session, kWork))) {
      removeFiles(session);
      continue;
    }
    const QJsonObject meta = readMeta(file(session, kMeta));
    found.push_back({session, meta["document"].toString(), meta["title"].toString(),
                     QDateTime::fromString(meta["time"].toString(), Qt::ISODate).toLocalTime()});
    adopted_.push_back(std::move(lock));
  }
  return found;
}

Experiment Autosave::recover(const LostWork& work) const {
  return loadExperiment(file(work.session, kWork).toStdString());
}

void Autosave::discard(const LostWork& work) {
  removeFiles(work.session);
}

QString Autosave::file(const QString& session, const char* ending) const {
  return QDir(folder_).filePath(session + ending);
}

void Autosave::removeFiles(const QString& session) const {
  QFile::remove(file(session, kWork));
  QFile::remove(file(session, kMeta));
}

}  // namespace rotorbench
