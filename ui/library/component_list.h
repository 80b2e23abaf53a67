// The components of the library as a list with search: own ones and shipped ones under their
// headings.
#pragma once

#include <QLocale>
#include <QWidget>
#include <filesystem>
#include <vector>

#include "sim/library/component_library.h"
#include "ui/forms/unit_preferences.h"

class QComboBox;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace rotorbench {

class ComponentList : public QWidget {
  Q_OBJECT

 public:
  /// Shows components of `kinds`; with several of them also their kind, and a choice of one.
  ComponentList(const ComponentLibrary& library, const UnitPreferences& units,
                std::vector<const ComponentKind*> kinds, QWidget* parent = nullptr);

  /// The chosen component, null if none. Valid until the library changes.
  [[nodiscard]] const LibraryEntry* current() const;
  /// Shows what the library holds now and chooses the component of this file, or the nearest to
  /// what was chosen.
  void reload(const std::filesystem::path& choose = {});
  void focusSearch();

 signals:
  void currentChanged();
  void activated();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTree();
  void fill();
  QTreeWidgetItem* addGroup(const QString& title);
  void addEntry(QTreeWidgetItem* group, const LibraryEntry& entry);
  [[nodiscard]] bool isShown(const LibraryEntry& entry, const QStringList& words) const;
  void choose(const std::filesystem::path& file);

  const ComponentLibrary& library_;
  const UnitPreferences& units_;
  std::vector<const ComponentKind*> kinds_;
  QLocale locale_;
  QLineEdit* search_;
  QComboBox* kind_;
  QTreeWidget* tree_;
};

}  // namespace rotorbench
