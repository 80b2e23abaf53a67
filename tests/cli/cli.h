// The program as tests call it, and what they read of its output.
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace rotorbench::test {

struct Outcome {
  int code;
  QByteArray out, err;
};

inline Outcome cli(const QStringList& arguments) {
  QProcess process;
  process.start(ROTORBENCH_CLI, arguments);
  if (!process.waitForFinished(120000) || process.exitStatus() != QProcess::NormalExit) {
    return {-1, process.readAllStandardOutput(), process.readAllStandardError()};
  }
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

inline QString shipped(const QString& name) {
  return QString(EXPERIMENTS_DIR "/%1.json").arg(name);
}

inline QByteArray contents(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Value of one figure of a printed sheet; -1 for null, -2 where there is no such figure.
inline double figure(const QByteArray& json, const QString& key) {
  for (const QJsonValue f : QJsonDocument::fromJson(json).object()["figures"].toArray()) {
    if (f["key"].toString() == key) return f["value"].toDouble(-1);
  }
  return -2;
}

}  // namespace rotorbench::test
