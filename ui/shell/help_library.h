// The help pages: HTML files in resources/help. A page names itself in <title> and lists in <meta
// name="topics" content="…"> the panels and schema sections it explains, so that F1 finds it
// without a table elsewhere. A line <!-- parameters: KEY --> stands for the table of the parameters
// of that schema type, made from the schema.
#pragma once

#include <QHash>
#include <QList>
#include <QString>
#include <QStringList>
#include <functional>

namespace rotorbench {

struct HelpPage {
  QString name;  ///< file name without ending
  QString title;
  QStringList topics;
  int order = 0;  ///< place in the contents, from <meta name="order">
};

class HelpLibrary {
 public:
  /// HTML table of a schema type's parameters by its key; empty if there is no such type.
  using TableMaker = std::function<QString(const QString& typeKey)>;

  HelpLibrary(const QString& folder, TableMaker tables);
  [[nodiscard]] const QList<HelpPage>& pages() const { return pages_; }
  /// Name of the page for the first topic that has one; the overview if none has.
  [[nodiscard]] QString pageFor(const QStringList& topics) const;
  /// The page ready to show; a page that does not exist says so.
  [[nodiscard]] QString html(const QString& name) const;

 private:
  QString folder_;
  TableMaker tables_;
  QList<HelpPage> pages_;
};

}  // namespace rotorbench
