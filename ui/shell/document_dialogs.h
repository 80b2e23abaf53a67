// Questions about documents: which file, save before closing, recover after a crash. All are
// window-modal and answered by signals or callbacks; none blocks the event loop.
#pragma once

#include <QObject>
#include <functional>

#include "ui/shell/document_controller.h"

class QWidget;

namespace rotorbench {

class DocumentDialogs : public QObject {
  Q_OBJECT

 public:
  DocumentDialogs(DocumentController& documents, QWidget& window);

  /// `kind`: the alternative of `setup`.
  void startNew(std::size_t kind = 0);
  void openWithDialog();
  /// `asTemplate`: a ready experiment from the gallery.
  void openFile(const QString& file, bool asTemplate = false);
  void save();
  void saveAs();
  /// Calls `proceed` at once if nothing is unsaved, else when the user has saved or given up the
  /// changes.
  void guard(std::function<void()> proceed);
  /// Offers work that a crash left behind, newest first.
  void offerRecovery();

 signals:
  void saved(const QString& file);

 private:
  bool saveTo(const QString& file);
  void askFileName(std::function<void()> then);
  void saveThen(std::function<void()> then);
  void askRecovery(const LostWork& work);
  void showProblems(const QString& title, const QString& text,
                    const std::vector<Problem>& problems);

  DocumentController& documents_;
  QWidget& window_;
};

/// "path: what; allowed", one line each, at most `most` of them.
QString problemLines(const std::vector<Problem>& problems, std::size_t most);

}  // namespace rotorbench
