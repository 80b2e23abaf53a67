#include "ui/forms/form_row.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QTimer>
#include <QToolButton>

#include "ui/forms/default_values.h"
#include "ui/forms/field_text.h"
#include "ui/forms/unit_button.h"

namespace rotorbench {

using form_style::Severity;
using schema::Kind;

namespace {
enum Column { kLabel, kEditor, kUnit, kMarker, kColumns };
}

void FieldLabel::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) {
    emit clicked();
  }
  QLabel::mouseReleaseEvent(event);
}

FormRow::FormRow(const FormContext& context, FieldEditor* editor, QWidget* content)
    : QObject(content),
      context_(context),
      editor_(editor),
      label_(new FieldLabel(labelHtml(editor->field()), content)),
      frame_(new form_style::Frame(editor->inputWidget())) {
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::RichText);
  label_->setObjectName(path() + QStringLiteral(".label"));
  label_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(label_, &FieldLabel::clicked, editor, &FieldEditor::labelClicked);
  connect(label_, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& at) { showMenu(label_->mapToGlobal(at)); });
  for (auto* input : editor->findChildren<QWidget*>()) {
    if (input->focusPolicy() != Qt::NoFocus) input->installEventFilter(this);
  }
  if (QWidget* unit = editor->unitWidget()) unit->setFocusPolicy(Qt::NoFocus);
  makeMarker(content);
  makeMessage(content);
  connect(editor, &FieldEditor::judged, this, [this](const QString& sentence) {
    typing_ = sentence;
    showProblem();
  });
  connect(context.model, &DocumentModel::commitRequested, editor, &FieldEditor::commit);
}

void FormRow::makeMarker(QWidget* content) {
  const Kind kind = editor_->field().kind;
  if (!editor_->field().isLeaf() && kind != Kind::Variant) return;
  marker_ = new QToolButton(content);
  marker_->setObjectName(path() + QStringLiteral(".reset"));
  marker_->setText(QStringLiteral("↺"));
  marker_->setAutoRaise(true);
  marker_->setFixedSize(form_style::kMarkerWidth, form_style::kMarkerWidth);
  marker_->setFocusPolicy(Qt::NoFocus);
  QSizePolicy keepPlace = marker_->sizePolicy();
  keepPlace.setRetainSizeWhenHidden(true);
  marker_->setSizePolicy(keepPlace);
  form_style::setTextColour(marker_, content->palette().color(QPalette::Highlight));
  connect(marker_, &QToolButton::clicked, this, &FormRow::resetToDefault);
}

void FormRow::makeMessage(QWidget* content) {
  message_ = new QLabel(content);
  message_->setObjectName(path() + QStringLiteral(".message"));
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  form_style::setFontScale(message_, 0.92);
  message_->setMinimumHeight(message_->fontMetrics().height());
  message_->hide();
}

int FormRow::place(QGridLayout* grid, int gridRow) {
  grid->addWidget(label_, gridRow, kLabel);
  if (marker_ != nullptr) grid->addWidget(marker_, gridRow, kMarker, Qt::AlignVCenter);
  QWidget* unit = editor_->unitWidget();
  if (editor_->isWide()) {
    if (unit != nullptr) grid->addWidget(unit, gridRow, kUnit);
    grid->addWidget(editor_, ++gridRow, kLabel, 1, kColumns - 1);
  } else if (unit != nullptr) {
    grid->addWidget(editor_, gridRow, kEditor);
    grid->addWidget(unit, gridRow, kUnit);
  } else {
    const bool number = editor_->field().kind == Kind::Integer;
    grid->addWidget(editor_, gridRow, kEditor, 1, number ? 1 : 2);
  }
  grid->addWidget(message_, ++gridRow, kLabel, 1, kColumns);
  return gridRow + 1;
}

QString FormRow::defaultText() const {
  const schema::Field& field = editor_->field();
  if (!field.isLeaf()) return {};
  const auto value = defaultValue(context_.model->root(), context_.model->defaults(), path());
  if (!value) return {};
  return valueText(field, *value, context_.units->shownUnit(field), context_.locale);
}

void FormRow::refresh() {
  editor_->refresh();
  refreshMarker();
  refreshNames();
}

void FormRow::unitsChanged() {
  editor_->unitsChanged();
  refreshMarker();
  refreshNames();
}

void FormRow::refreshMarker() {
  if (marker_ == nullptr) return;
  const qsizetype dot = path().lastIndexOf(QLatin1Char('.'));
  DefaultsCursor cursor(context_.model->root(), context_.model->defaults());
  if (dot > 0 && !cursor.descend(path().left(dot))) return;
  const schema::Field& field = editor_->field();
  const void* owner = cursor.object().object;
  const bool changed = field.kind == Kind::Variant
                           ? field.chosen(owner) != field.chosen(cursor.defaultObject())
                           : differsFromDefault(field, owner, cursor.defaultObject());
  marker_->setVisible(changed && visible_);
  const QString text = defaultText();
  marker_->setToolTip(text.isEmpty() ? tr("Changed. Click to reset to the default.")
                                     : tr("Changed. Click to reset to %1.").arg(text));
  marker_->setAccessibleName(tr("Reset %1 to its default").arg(toQString(field.label)));
}

void FormRow::refreshNames() {
  const schema::Field& field = editor_->field();
  const QString unit = context_.units->shownUnit(field);
  const bool live = context_.flying && field.live;
  label_->setText(labelHtml(field) +
                  (live ? form_style::liveMarkHtml(label_->palette()) : QString()));
  QString tip = toolTipHtml(field, path(), unit, defaultText(), context_.locale);
  if (live) tip += tr("<p>Acts at once in the flight that goes on.</p>");
  label_->setToolTip(tip);
  editor_->setToolTip(tip);
  QWidget* input = editor_->inputWidget();
  input->setWhatsThis(tip);
  const QString pretty = prettyUnit(unit);
  if (input->accessibleName().isEmpty() || field.kind == Kind::Number) {
    input->setAccessibleName(pretty.isEmpty()
                                 ? toQString(field.label)
                                 : tr("%1, in %2").arg(toQString(field.label), pretty));
  }
  const QString wrong = typing_.isEmpty() ? sentence_ : typing_;
  input->setAccessibleDescription(wrong.isEmpty() ? toQString(field.help) : wrong);
}

void FormRow::setVisible(bool visible) {
  visible_ = visible;
  for (QWidget* widget :
       {static_cast<QWidget*>(label_), static_cast<QWidget*>(editor_), editor_->unitWidget()}) {
    if (widget != nullptr) widget->setVisible(visible);
  }
  if (marker_ != nullptr && !visible) marker_->hide();
  if (visible) refreshMarker();
  message_->setVisible(visible && !message_->text().isEmpty());
}

void FormRow::makeHead() {
  form_style::setFontScale(label_, 1.0, true);
}

void FormRow::setProblem(Severity severity, const QString& sentence, const QString& place) {
  frame_->setTarget(editor_->inputFor(place));
  if (severity == severity_ && sentence == sentence_ && typing_.isEmpty()) return;
  severity_ = severity;
  sentence_ = sentence;
  typing_.clear();
  showProblem();
}

void FormRow::showProblem() {
  // A line that opened between press and release would move the button under the pointer.
  if (QGuiApplication::mouseButtons() != Qt::NoButton) {
    constexpr int kLookAgainMs = 30;
    QTimer::singleShot(kLookAgainMs, this, &FormRow::showProblem);
    return;
  }
  const Severity severity = typing_.isEmpty() ? severity_ : Severity::Error;
  const QString text = typing_.isEmpty() ? sentence_ : typing_;
  frame_->setSeverity(severity);
  form_style::setTextColour(message_, form_style::severityColour(severity, label_->palette()));
  message_->setText(text);
  // Once open, the line stays, so that putting the value right moves nothing.
  if (!text.isEmpty() && visible_) message_->show();
  refreshNames();
}

void FormRow::detach() {
  for (auto* input : editor_->findChildren<QWidget*>()) input->disconnect(editor_);
  context_.model->disconnect(editor_);
}

void FormRow::resetToDefault() {
  const schema::Field& field = editor_->field();
  DocumentModel& model = *context_.model;
  if (field.kind == Kind::Variant) {
    const qsizetype dot = path().lastIndexOf(QLatin1Char('.'));
    DefaultsCursor cursor(model.root(), model.defaults());
    if (dot > 0 && !cursor.descend(path().left(dot))) return;
    model.choose(path(), field.chosen(cursor.defaultObject()));
    return;
  }
  if (const auto value = defaultValue(model.root(), model.defaults(), path())) {
    model.set(path(), *value);
    editor_->refresh();
  }
}

bool FormRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ContextMenu) {
    auto* input = qobject_cast<QWidget*>(watched);
    const auto* asked = static_cast<QContextMenuEvent*>(event);
    QMenu* menu = nullptr;
    if (auto* line = qobject_cast<QLineEdit*>(input)) menu = line->createStandardContextMenu();
    if (auto* text = qobject_cast<QPlainTextEdit*>(input)) menu = text->createStandardContextMenu();
    if (menu == nullptr) menu = new QMenu(input);
    menu->setObjectName(QStringLiteral("fieldMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (!menu->isEmpty()) menu->addSeparator();
    addFieldActions(menu);
    menu->popup(asked->globalPos());
    return true;
  }
  return QObject::eventFilter(watched, event);
}

void FormRow::showMenu(const QPoint& globalPosition) {
  auto* menu = new QMenu(label_);
  menu->setObjectName(QStringLiteral("fieldMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addFieldActions(menu);
  menu->popup(globalPosition);
}

void FormRow::addFieldActions(QMenu* menu) {
  if (marker_ != nullptr) {
    QAction* reset = menu->addAction(tr("Reset to default"), this, &FormRow::resetToDefault);
    reset->setEnabled(marker_->isVisible());
  }
  if (editor_->unitWidget() != nullptr) {
    if (QMenu* units = makeUnitMenu(context_, editor_->field(), menu)) {
      units->setTitle(tr("Unit"));
      menu->addMenu(units);
    }
  }
  menu->addAction(tr("Copy path for the command line"), this,
                  [this] { QGuiApplication::clipboard()->setText(path()); });
}

}  // namespace rotorbench
