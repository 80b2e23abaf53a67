// The editor of one field, made from its description. An editor shows what the document holds and
// turns what a person does into edits of the document; it keeps no value of its own.
#pragma once

#include <QWidget>

#include "ui/forms/form_context.h"

class QToolButton;

namespace rotorbench {

class CommitEdit;
class UnitButton;

class FieldEditor : public QWidget {
  Q_OBJECT

 public:
  FieldEditor(const FormContext& context, const schema::Field& field, QString path,
              QWidget* parent);
  ~FieldEditor() override;

  [[nodiscard]] const QString& path() const { return path_; }
  [[nodiscard]] const schema::Field& field() const { return field_; }

  /// Shows the document's value (or the invalid text typed before).
  virtual void refresh() = 0;
  /// Takes over what is being typed.
  virtual void commit() {}
  /// The unit in which numbers are shown has changed.
  virtual void unitsChanged() {}
  /// Puts the keyboard focus on the place `path`, at or below this field.
  void focusPlace(const QString& path);
  /// What a click on the label does besides taking the focus.
  virtual void labelClicked();
  /// True if the editor wants the whole width below its label.
  [[nodiscard]] virtual bool isWide() const { return false; }
  /// The button that shows and switches the unit; null for fields without one.
  [[nodiscard]] virtual QWidget* unitWidget() { return nullptr; }
  /// The widget that takes the focus and speaks to screen readers.
  [[nodiscard]] virtual QWidget* inputWidget() = 0;
  /// The widget for a place at or below this field (a component of a vector).
  [[nodiscard]] virtual QWidget* inputFor(const QString& path);

 signals:
  /// While typing: what is wrong with the present text, empty if nothing.
  void judged(const QString& sentence);
  /// The place has a section of its own and the user wants to go there.
  void openRequested(const QString& path);

 protected:
  [[nodiscard]] const FormContext& context() const { return context_; }
  [[nodiscard]] DocumentModel& model() const { return *context_.model; }
  [[nodiscard]] QString shownUnit() const { return context_.units->shownUnit(field_); }
  /// Routes the undo and redo keys of a line edit to the document.
  void adopt(CommitEdit* edit);
  /// Makes `input` the child that fills this editor.
  void fillWith(QWidget* input);

 private:
  const FormContext& context_;
  const schema::Field& field_;
  QString path_;
};

/// The editor of a field: leaves as described; a combo box for a variant that is shown here; a link
/// for what has a section of its own (`asLink`). `context` and `field` must outlive it.
FieldEditor* makeFieldEditor(const FormContext& context, const schema::Field& field,
                             const QString& path, bool asLink, QWidget* parent);

}  // namespace rotorbench
