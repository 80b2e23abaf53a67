// The component library: find, look at, use, and keep one's own. Opened from a form it offers what
// fits the place and fills it; opened from the menu it shows all kinds. Shipped components are
// never changed; one's own are files in a folder of their own.
#pragma once

#include <QDialog>
#include <functional>
#include <memory>
#include <optional>

#include "sim/library/component_library.h"
#include "ui/forms/unit_preferences.h"
#include "ui/library/component_info_dialog.h"

class QLabel;
class QPushButton;

namespace rotorbench {

class ComponentDetails;
class ComponentList;

/// What the place that asks for a component is like.
struct LibraryRequest {
  QString title;                                             ///< of the dialog: "Motor"
  std::vector<const ComponentKind*> kinds;                   ///< that fit
  std::function<std::optional<schema::ConstRef>()> current;  ///< to be saved; may be empty
  std::function<void(const Component&)> use;                 ///< empty: only to look and manage
};

/// All kinds, nothing to fill.
LibraryRequest browseRequest();

/// The user's folder of components, in the place the system has for data of a program.
std::filesystem::path ownLibraryDirectory();

class LibraryDialog : public QDialog {
  Q_OBJECT

 public:
  /// Reads the library anew. Deletes itself when closed.
  LibraryDialog(LibraryRequest request, QWidget* parent);
  ~LibraryDialog() override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* buildManaging();
  QWidget* buildClosing();
  QPushButton* addButton(QWidget* box, const char* name, const QString& text, const QString& help,
                         void (LibraryDialog::*slot)());
  void showCurrent();
  void say(const QString& sentence, bool wrong = false);
  void sayFaults();

  void use();
  void saveCurrent();
  void duplicate();
  void rename();
  void importFiles();
  void exportFile();
  void remove();

  void askInfo(const QString& title, const ComponentInfo& info, ComponentInfoDialog::Accept accept);
  void importOne(const QString& file, QStringList& done, QStringList& faults);
  /// Runs what changes the library; the sentence of the fault, if there is one.
  QString change(const std::function<const LibraryEntry*()>& action);

  LibraryRequest request_;
  ComponentLibrary library_;
  UnitPreferences units_;
  ComponentList* list_;
  ComponentDetails* details_;
  QLabel* message_;
  QPushButton *use_ = nullptr, *duplicate_ = nullptr, *rename_ = nullptr, *export_ = nullptr,
              *delete_ = nullptr;
};

}  // namespace rotorbench
