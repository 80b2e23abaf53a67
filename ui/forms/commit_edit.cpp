#include "ui/forms/commit_edit.h"

#include <QKeyEvent>

namespace rotorbench {

CommitEdit::CommitEdit(QWidget* parent) : QLineEdit(parent) {
  setFocusPolicy(Qt::StrongFocus);
}

void CommitEdit::showText(const QString& text) {
  shownText_ = text;
  if (this->text() == text) return;
  setText(text);
  setCursorPosition(hasFocus() ? static_cast<int>(text.size()) : 0);
}

void CommitEdit::revert() {
  showText(shownText_);
  emit reverted();
}

bool CommitEdit::event(QEvent* event) {
  // Once committed, undo is the document's: leave the keys to the window's shortcuts.
  if (event->type() == QEvent::ShortcutOverride && !hasUncommittedText()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void CommitEdit::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo)) {
    hasUncommittedText() ? revert() : emit undoRequested();
    return;
  }
  if (event->matches(QKeySequence::Redo)) {
    if (!hasUncommittedText()) emit redoRequested();
    return;
  }
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    commit();
    selectAll();
    return;
  }
  if (event->key() == Qt::Key_Escape && hasUncommittedText()) return revert();
  QLineEdit::keyPressEvent(event);
}

void CommitEdit::focusOutEvent(QFocusEvent* event) {
  // A popup (the context menu, the unit menu) does not end the editing.
  if (event->reason() != Qt::PopupFocusReason) commit();
  QLineEdit::focusOutEvent(event);
}

}  // namespace rotorbench
