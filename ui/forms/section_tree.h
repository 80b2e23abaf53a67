// The tree of a document's sections, made from the schema and the values: which there are, which
// hold a problem, which differ from the defaults. The search line finds parameters by label, key or
// symbol and shows where they are.
#pragma once

#include <QHash>
#include <QSet>
#include <QTimer>
#include <QWidget>

#include "ui/forms/form_context.h"

class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace rotorbench {

class SectionTree : public QWidget {
  Q_OBJECT

 public:
  explicit SectionTree(const FormContext& context, QWidget* parent = nullptr);

  [[nodiscard]] QString currentSection() const;
  /// Selects the item of the section without announcing it.
  void showSection(const QString& path);
  void focusSearch();

 signals:
  void sectionSelected(const QString& path);
  /// A parameter found by the search was chosen.
  void placeChosen(const QString& path);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Sections and, while searching, parameters found below them.
  using Found = QHash<QString, QList<QPair<QString, QString>>>;

  void rebuild();
  void addChildren(QTreeWidgetItem* parent, const QString& section, const Found* found);
  QTreeWidgetItem* makeItem(const QString& path, const QString& title, bool parameter);
  [[nodiscard]] Found search(const QString& words) const;
  void updateMarks();
  void updateMark(QTreeWidgetItem* item);
  void onCurrentChanged();

  const FormContext& context_;
  QLineEdit* search_;
  QTreeWidget* tree_;
  QHash<QString, QTreeWidgetItem*> items_;
  QSet<QString> collapsed_;
  QString section_;
  QTimer later_;
  bool building_ = false;
  bool shapeChanged_ = false;
};

}  // namespace rotorbench
