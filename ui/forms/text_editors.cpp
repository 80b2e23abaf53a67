#include "ui/forms/text_editors.h"

#include <QCompleter>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QStringListModel>
#include <QToolButton>

#include "ui/forms/field_text.h"

namespace rotorbench {

namespace {

/// Completes the last name of "a, b, c".
class ListCompleter : public QCompleter {
 public:
  using QCompleter::QCompleter;

 protected:
  [[nodiscard]] QStringList splitPath(const QString& path) const override {
    return {path.mid(path.lastIndexOf(QLatin1Char(',')) + 1).trimmed()};
  }
  [[nodiscard]] QString pathFromIndex(const QModelIndex& index) const override {
    const QString typed = static_cast<QLineEdit*>(widget())->text();
    const qsizetype comma = typed.lastIndexOf(QLatin1Char(','));
    const QString kept = comma < 0 ? QString() : typed.left(comma + 1) + QLatin1Char(' ');
    return kept + QCompleter::pathFromIndex(index);
  }
};

}  // namespace

void TextLine::commit() {
  if (!hasUncommittedText()) return;
  const QString typed = text();
  showText(typed);
  emit committed(typed);
}

TextLineEditor::TextLineEditor(const FormContext& context, const schema::Field& field,
                               const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), edit_(new TextLine(this)) {
  edit_->setObjectName(path);
  fillWith(edit_);
  adopt(edit_);
  connect(edit_, &TextLine::committed, this, &TextLineEditor::store);
  if (field.role == schema::TextRole::FilePath) addBrowseButton();
  if (field.role == schema::TextRole::Channels) addChannelCompletion();
}

bool TextLineEditor::isWide() const {
  return field().role != schema::TextRole::Line;
}

void TextLineEditor::store(const QString& text) {
  if (const auto problem = model().set(path(), text.toStdString())) {
    model().setInvalidText(path(), text, problemSentence(*problem));
  }
}

void TextLineEditor::addBrowseButton() {
  auto* browse = new QToolButton(this);
  browse->setObjectName(path() + QStringLiteral(".browse"));
  browse->setText(QStringLiteral("…"));
  browse->setToolTip(tr("Choose a file"));
  browse->setAccessibleName(tr("Choose a file for %1").arg(toQString(field().label)));
  static_cast<QHBoxLayout*>(layout())->addWidget(browse);
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, toQString(field().label), edit_->text());
    if (!file.isEmpty()) store(file);
  });
}

void TextLineEditor::addChannelCompletion() {
  if (!context().channelNames) return;
  auto* completer = new ListCompleter(new QStringListModel(context().channelNames(), this), this);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  completer->setFilterMode(Qt::MatchContains);
  edit_->setCompleter(completer);
}

void TextLineEditor::refresh() {
  const auto invalid = model().invalidText(path());
  edit_->setShown(invalid ? invalid->text : toQString(std::get<std::string>(model().get(path()))));
}

ParagraphEdit::ParagraphEdit(QWidget* parent) : QPlainTextEdit(parent) {
  setUndoRedoEnabled(false);
  setTabChangesFocus(true);
}

bool ParagraphEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      emit finished();
      event->ignore();
      return true;
    }
  }
  return QPlainTextEdit::event(event);
}

void ParagraphEdit::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Undo)) return emit undoRequested();
  if (event->matches(QKeySequence::Redo)) return emit redoRequested();
  QPlainTextEdit::keyPressEvent(event);
}

void ParagraphEdit::focusOutEvent(QFocusEvent* event) {
  if (event->reason() != Qt::PopupFocusReason) emit finished();
  QPlainTextEdit::focusOutEvent(event);
}

ParagraphEditor::ParagraphEditor(const FormContext& context, const schema::Field& field,
                                 const QString& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), edit_(new ParagraphEdit(this)) {
  constexpr int kLines = 4;
  constexpr int kPauseMs = 600;
  edit_->setObjectName(path);
  edit_->setFixedHeight(edit_->fontMetrics().lineSpacing() * kLines + 12);
  fillWith(edit_);
  pause_.setSingleShot(true);
  pause_.setInterval(kPauseMs);
  connect(edit_, &QPlainTextEdit::textChanged, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, &ParagraphEditor::commit);
  connect(edit_, &ParagraphEdit::finished, this, &ParagraphEditor::commit);
  connect(edit_, &ParagraphEdit::undoRequested, model().undoStack(), &QUndoStack::undo);
  connect(edit_, &ParagraphEdit::redoRequested, model().undoStack(), &QUndoStack::redo);
}

void ParagraphEditor::commit() {
  pause_.stop();
  const std::string text = edit_->toPlainText().toStdString();
  model().set(path(), text, DocumentModel::Edit::Repeated);
}

void ParagraphEditor::refresh() {
  const QString text = toQString(std::get<std::string>(model().get(path())));
  if (edit_->toPlainText() == text) return;
  const QSignalBlocker quiet(edit_);
  edit_->setPlainText(text);
}

}  // namespace rotorbench
