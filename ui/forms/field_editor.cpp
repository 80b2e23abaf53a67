#include "ui/forms/field_editor.h"

#include <QHBoxLayout>

#include "ui/forms/choice_editors.h"
#include "ui/forms/commit_edit.h"
#include "ui/forms/number_editors.h"
#include "ui/forms/text_editors.h"

namespace rotorbench {

using schema::Kind;

FieldEditor::FieldEditor(const FormContext& context, const schema::Field& field, QString path,
                         QWidget* parent)
    : QWidget(parent), context_(context), field_(field), path_(std::move(path)) {}

FieldEditor::~FieldEditor() {
  // A line edit with the focus loses it while it is destroyed, and would commit to an editor that
  // is no more.
  for (QWidget* child : findChildren<QWidget*>()) child->disconnect(this);
}

QWidget* FieldEditor::inputFor(const QString&) {
  return inputWidget();
}

void FieldEditor::focusPlace(const QString& path) {
  inputFor(path)->setFocus(Qt::OtherFocusReason);
}

void FieldEditor::labelClicked() {
  inputWidget()->setFocus(Qt::MouseFocusReason);
}

void FieldEditor::adopt(CommitEdit* edit) {
  connect(edit, &CommitEdit::undoRequested, model().undoStack(), &QUndoStack::undo);
  connect(edit, &CommitEdit::redoRequested, model().undoStack(), &QUndoStack::redo);
}

void FieldEditor::fillWith(QWidget* input) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(input);
  setFocusProxy(input);
}

FieldEditor* makeFieldEditor(const FormContext& context, const schema::Field& field,
                             const QString& path, bool asLink, QWidget* parent) {
  if (asLink) return new LinkEditor(context, field, path, parent);
  switch (field.kind) {
    case Kind::Number:
    case Kind::Integer:
      return new NumberEditor(context, field, path, parent);
    case Kind::Vector:
      return new VectorEditor(context, field, path, parent);
    case Kind::Boolean:
      return new BooleanEditor(context, field, path, parent);
    case Kind::Choice:
      return new ChoiceEditor(context, field, path, parent);
    case Kind::Text:
      if (field.role == schema::TextRole::Paragraph) {
        return new ParagraphEditor(context, field, path, parent);
      }
      return new TextLineEditor(context, field, path, parent);
    case Kind::Variant:
      return new VariantEditor(context, field, path, parent);
    case Kind::Group:
    case Kind::List:
      break;
  }
  return new LinkEditor(context, field, path, parent);
}

}  // namespace rotorbench
