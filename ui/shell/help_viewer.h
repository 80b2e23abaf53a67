// The window that shows the help pages, with contents and the way back.
#pragma once

#include <QWidget>

#include "ui/shell/help_library.h"

class QListWidget;
class QTextBrowser;

namespace rotorbench {

class HelpViewer : public QWidget {
  Q_OBJECT

 public:
  explicit HelpViewer(HelpLibrary library, QWidget* parent = nullptr);
  /// Shows the page for the first topic that has one, and the window.
  void showTopic(const QStringList& topics);
  [[nodiscard]] QString currentPage() const;

 private:
  void load(const QString& page);
  void markContents();

  HelpLibrary library_;
  QListWidget* contents_;
  QTextBrowser* browser_;
};

}  // namespace rotorbench
