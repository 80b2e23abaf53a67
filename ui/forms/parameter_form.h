// The form of one section of the document, made from the schema alone: rows for the fields, titled
// parts for small groups, links to large ones, tables, and a "More" button before the advanced
// fields. A new field in a schema appears here without a line of code.
#pragma once

#include <QScrollArea>
#include <QSet>
#include <vector>

#include "ui/forms/form_row.h"
#include "ui/forms/list_editors.h"

class QGridLayout;
class QToolButton;

namespace rotorbench {

class ParameterForm : public QScrollArea {
  Q_OBJECT

 public:
  /// `context` must outlive the form.
  explicit ParameterForm(const FormContext& context, QWidget* parent = nullptr);

  [[nodiscard]] const QString& section() const { return section_; }
  /// Shows the section at `path` (the document itself for ""), or the nearest one above that
  /// exists.
  void showSection(const QString& path);
  /// Shows the section that holds `path`, opens "More" if needed and puts the focus on the field.
  void focusPlace(const QString& path);
  /// Marks the fields that act at once while a flight goes on, or no more.
  void showLive();
  /// Makes the form anew from the document and the context.
  void rebuild();

 signals:
  /// A link or a place in the title was clicked.
  void sectionRequested(const QString& path);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Part {
    QToolButton* more = nullptr;
    QString key;  ///< of the struct whose advanced fields the button shows
    std::vector<FormRow*> rows;
    std::vector<QWidget*> widgets;
  };

  void rebuildLater();
  void dropContent();
  void addHeader();
  void addBreadcrumb();
  QLabel* makeText(const QString& text);
  void addText(const QString& text);
  void addSection();
  void addObject(schema::ConstRef object, const QString& path);
  void addFields(schema::ConstRef object, const QString& path, bool advanced);
  void addField(schema::ConstRef object, const schema::Field& field, const QString& path);
  FormRow* addRow(FieldEditor* editor);
  void addList(const schema::Field& field, const QString& path, bool titled);
  void addTitle(const QString& title, const QString& help, const QString& path);
  void addMore(const QString& key);
  void addWide(QWidget* widget);
  /// With the library's button beside it where there are components for the place.
  void addWide(QLabel* label, const QString& path);
  void setMoreShown(Part& part, bool shown);

  void onValueChanged(const QString& path);
  void onStructureChanged(const QString& path);
  void showProblems();
  [[nodiscard]] FormRow* rowFor(const QString& path) const;
  [[nodiscard]] ListEditor* listFor(const QString& path) const;

  const FormContext& context_;
  QString section_;
  QWidget* content_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QLabel* headMessage_ = nullptr;
  int nextRow_ = 0;
  std::vector<FormRow*> rows_;
  std::vector<std::pair<QString, ListEditor*>> lists_;
  std::vector<Part> parts_;
  Part* collecting_ = nullptr;  ///< the advanced part being built
  QSet<QString> opened_;        ///< keys of the structs whose advanced fields are shown
  bool rebuildPending_ = false;
};

}  // namespace rotorbench
