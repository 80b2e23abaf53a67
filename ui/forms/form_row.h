// One line of a form: label with symbol, editor, unit, the mark of a changed value, and below it
// the sentence of what is wrong. Lays itself into the form's grid; knows the document only through
// its editor.
#pragma once

#include <QLabel>
#include <QObject>

#include "ui/forms/field_editor.h"
#include "ui/forms/form_style.h"

class QGridLayout;
class QMenu;
class QToolButton;

namespace rotorbench {

/// A label that can be clicked like the label of a check box.
class FieldLabel : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;

 signals:
  void clicked();

 protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
};

class FormRow : public QObject {
  Q_OBJECT

 public:
  FormRow(const FormContext& context, FieldEditor* editor, QWidget* content);

  /// Puts the widgets into `grid` from `gridRow` on; returns the next free row.
  int place(QGridLayout* grid, int gridRow);

  [[nodiscard]] const QString& path() const { return editor_->path(); }
  [[nodiscard]] FieldEditor* editor() const { return editor_; }

  void refresh();
  /// Label and tips anew.
  void refreshNames();
  void unitsChanged();
  void setVisible(bool visible);
  /// What the document finds wrong here; None clears it.
  void setProblem(form_style::Severity severity, const QString& sentence, const QString& place);
  /// Shows the row as the head of a part (the choice of a variant above its fields).
  void makeHead();
  void resetToDefault();
  /// From now on the editor no longer writes to the document.
  void detach();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeMarker(QWidget* content);
  void makeMessage(QWidget* content);
  void refreshMarker();
  void showProblem();
  void showMenu(const QPoint& globalPosition);
  void addFieldActions(QMenu* menu);
  [[nodiscard]] QString defaultText() const;

  const FormContext& context_;
  FieldEditor* editor_;
  FieldLabel* label_;
  QToolButton* marker_ = nullptr;
  QLabel* message_ = nullptr;
  form_style::Frame* frame_;
  form_style::Severity severity_ = form_style::Severity::None;
  QString sentence_;  ///< the document's
  QString typing_;    ///< the present text's
  bool visible_ = true;
};

}  // namespace rotorbench
