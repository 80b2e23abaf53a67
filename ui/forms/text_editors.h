// Editors of text: one line (with a browse button for files and completion for channel names) or a
// paragraph.
#pragma once

#include <QPlainTextEdit>
#include <QTimer>

#include "ui/forms/commit_edit.h"
#include "ui/forms/field_editor.h"

namespace rotorbench {

class TextLine : public CommitEdit {
  Q_OBJECT

 public:
  using CommitEdit::CommitEdit;
  void setShown(const QString& text) { showText(text); }
  void commit() override;

 signals:
  void committed(const QString& text);
};

class TextLineEditor : public FieldEditor {
  Q_OBJECT

 public:
  TextLineEditor(const FormContext& context, const schema::Field& field, const QString& path,
                 QWidget* parent);
  void refresh() override;
  void commit() override { edit_->commit(); }
  [[nodiscard]] bool isWide() const override;
  [[nodiscard]] QWidget* inputWidget() override { return edit_; }

 private:
  void addBrowseButton();
  void addChannelCompletion();
  void store(const QString& text);

  TextLine* edit_;
};

/// Several lines; what is typed reaches the document after a pause, as one undo step per visit.
class ParagraphEdit : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit ParagraphEdit(QWidget* parent = nullptr);

 signals:
  void finished();
  void undoRequested();
  void redoRequested();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
};

class ParagraphEditor : public FieldEditor {
  Q_OBJECT

 public:
  ParagraphEditor(const FormContext& context, const schema::Field& field, const QString& path,
                  QWidget* parent);
  void refresh() override;
  void commit() override;
  [[nodiscard]] bool isWide() const override { return true; }
  [[nodiscard]] QWidget* inputWidget() override { return edit_; }

 private:
  ParagraphEdit* edit_;
  QTimer pause_;
};

}  // namespace rotorbench
