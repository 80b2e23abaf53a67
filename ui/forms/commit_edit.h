// A line edit whose text counts only when it is committed (Enter, or leaving the field). Until then
// Ctrl+Z and Escape take back what was typed; afterwards undo and redo belong to the document.
#pragma once

#include <QLineEdit>

namespace rotorbench {

class CommitEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit CommitEdit(QWidget* parent = nullptr);

  /// True if the text differs from what the document holds.
  [[nodiscard]] virtual bool hasUncommittedText() const { return text() != shownText_; }
  /// Takes the present text over, as pressing Enter.
  virtual void commit() = 0;
  /// Back to what the document holds, as pressing Escape.
  virtual void revert();

 signals:
  void reverted();
  void undoRequested();
  void redoRequested();

 protected:
  /// Shows text that the document holds.
  void showText(const QString& text);
  [[nodiscard]] const QString& shownText() const { return shownText_; }

  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QString shownText_;
};

}  // namespace rotorbench
