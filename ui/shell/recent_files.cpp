#include "ui/shell/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace rotorbench {

namespace {
constexpr auto kRecentFilesKey = "recentFiles";
}

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}

QStringList RecentFiles::files() const {
  return QSettings().value(kRecentFilesKey).toStringList();
}

void RecentFiles::add(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  QStringList list = files();
  list.removeAll(path);
  list.prepend(path);
  while (list.size() > kMost) list.removeLast();
  store(list);
}

void RecentFiles::remove(const QString& file) {
  QStringList list = files();
  list.removeAll(file);
  store(list);
}

void RecentFiles::clear() {
  store({});
}

void RecentFiles::store(const QStringList& files) {
  QSettings().setValue(kRecentFilesKey, files);
  emit changed();
}

}  // namespace rotorbench
