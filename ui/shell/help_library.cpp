#include "ui/shell/help_library.h"

#include <QDir>
#include <QFile>
#include <QObject>
#include <QRegularExpression>
#include <algorithm>

namespace rotorbench {

namespace {

QString readFile(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString metaContent(const QString& html, const QString& name) {
  const QRegularExpression tag("<meta name=\"" + name + "\" content=\"([^\"]*)\"");
  return tag.match(html).captured(1);
}

QString titleOf(const QString& html) {
  static const QRegularExpression tag("<title>([^<]*)</title>");
  return tag.match(html).captured(1);
}

}  // namespace

HelpLibrary::HelpLibrary(const QString& folder, TableMaker tables)
    : folder_(folder), tables_(std::move(tables)) {
  for (const QFileInfo& info : QDir(folder_).entryInfoList({"*.html"}, QDir::Files)) {
    const QString html = readFile(info.filePath());
    pages_.push_back({info.completeBaseName(), titleOf(html),
                      metaContent(html, "topics").split(' ', Qt::SkipEmptyParts),
                      metaContent(html, "order").toInt()});
  }
  std::ranges::sort(pages_, {}, &HelpPage::order);
}

QString HelpLibrary::pageFor(const QStringList& topics) const {
  for (const QString& topic : topics) {
    for (const HelpPage& page : pages_) {
      if (page.name == topic || page.topics.contains(topic)) return page.name;
    }
  }
  return "index";
}

QString HelpLibrary::html(const QString& name) const {
  QString html = readFile(QDir(folder_).filePath(name + ".html"));
  if (html.isEmpty()) {
    return QObject::tr("<p>The help page “%1” is missing.</p>").arg(name.toHtmlEscaped());
  }
  static const QRegularExpression mark("<!-- parameters: ([\\w-]+) -->");
  for (auto match = mark.match(html); match.hasMatch(); match = mark.match(html)) {
    html.replace(match.capturedStart(), match.capturedLength(), tables_(match.captured(1)));
  }
  return html;
}

}  // namespace rotorbench
