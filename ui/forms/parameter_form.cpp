#include "ui/forms/parameter_form.h"

#include <QApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QTimer>
#include <QToolButton>
#include <algorithm>

#include "ui/forms/field_text.h"
#include "ui/forms/library_button.h"
#include "ui/forms/sections.h"

namespace rotorbench {

using form_style::Severity;
using schema::Kind;

ParameterForm::ParameterForm(const FormContext& context, QWidget* parent)
    : QScrollArea(parent), context_(context) {
  setObjectName(QStringLiteral("parameterForm"));
  setAccessibleName(tr("Parameters"));
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  DocumentModel* model = context.model;
  connect(model, &DocumentModel::valueChanged, this, &ParameterForm::onValueChanged);
  connect(model, &DocumentModel::structureChanged, this, &ParameterForm::onStructureChanged);
  connect(model, &DocumentModel::problemsChanged, this, &ParameterForm::showProblems);
  connect(model, &DocumentModel::documentReplaced, this, [this] {
    section_.clear();
    opened_.clear();
    rebuild();
  });
  connect(context.units, &UnitPreferences::changed, this, [this] {
    for (auto* row : rows_) row->unitsChanged();
    for (auto& [path, list] : lists_) list->refresh();
  });
  rebuild();
}

void ParameterForm::showSection(const QString& path) {
  if (path == section_ && content_ != nullptr && !rebuildPending_) return;
  if (!rebuildPending_) {
    for (auto* row : rows_) row->editor()->commit();
  }
  section_ = path;
  rebuild();
}

void ParameterForm::focusPlace(const QString& path) {
  showSection(sectionOf(context_.model->root(), path));
  if (rebuildPending_) rebuild();
  if (ListEditor* list = listFor(path)) {
    list->focusPlace(path);
    ensureWidgetVisible(list);
    return;
  }
  FormRow* row = rowFor(path);
  if (row == nullptr) return;
  for (auto& part : parts_) {
    if (std::find(part.rows.begin(), part.rows.end(), row) != part.rows.end()) {
      setMoreShown(part, true);
    }
  }
  // The layout must know its size before the field can be scrolled into view.
  content_->layout()->activate();
  row->editor()->focusPlace(path);
  ensureWidgetVisible(row->editor());
}

void ParameterForm::showLive() {
  for (auto* row : rows_) row->refreshNames();
  for (auto& [path, list] : lists_) list->refresh();
}

void ParameterForm::rebuildLater() {
  if (rebuildPending_) return;
  rebuildPending_ = true;
  QTimer::singleShot(0, this, [this] {
    if (rebuildPending_) rebuild();
  });
}

void ParameterForm::rebuild() {
  rebuildPending_ = false;
  const QWidget* focused = QApplication::focusWidget();
  const bool hadFocus =
      content_ != nullptr && focused != nullptr && content_->isAncestorOf(focused);
  const QString focusedName = hadFocus ? focused->objectName() : QString();
  dropContent();
  while (!section_.isEmpty() && !context_.model->find(section_)) {
    section_ =
        section_.left(std::max<qsizetype>(0, std::max(section_.lastIndexOf(QLatin1Char('.')),
                                                      section_.lastIndexOf(QLatin1Char('[')))));
  }
  content_ = new QWidget;
  content_->setObjectName(QStringLiteral("formContent"));
  content_->setMaximumWidth(form_style::kWidestForm);
  grid_ = new QGridLayout(content_);
  grid_->setContentsMargins(form_style::kMargin, form_style::kMargin, form_style::kMargin,
                            form_style::kMargin);
  grid_->setHorizontalSpacing(form_style::kGrid);
  grid_->setVerticalSpacing(form_style::kGrid);
  grid_->setColumnStretch(0, 5);
  grid_->setColumnStretch(1, 4);
  grid_->setColumnMinimumWidth(2, form_style::kUnitWidth);
  grid_->setColumnMinimumWidth(3, form_style::kMarkerWidth);
  nextRow_ = 0;
  addHeader();
  addSection();
  grid_->setRowStretch(nextRow_, 1);
  setWidget(content_);
  for (auto* row : rows_) row->refresh();
  for (auto& part : parts_) setMoreShown(part, opened_.contains(part.key));
  showProblems();
  if (!hadFocus) return;
  auto* again = focusedName.isEmpty() ? nullptr : content_->findChild<QWidget*>(focusedName);
  if (again != nullptr) again->setFocus(Qt::OtherFocusReason);
}

void ParameterForm::dropContent() {
  // The old editors may be in the middle of a signal, so they go later; losing the focus must not
  // make them write to places that are no longer theirs.
  for (auto* row : rows_) row->detach();
  rows_.clear();
  lists_.clear();
  parts_.clear();
  headMessage_ = nullptr;
  if (content_ != nullptr) takeWidget()->deleteLater();
}

void ParameterForm::addBreadcrumb() {
  QStringList links;
  QString walked = section_;
  while (!walked.isEmpty()) {
    const qsizetype cut =
        std::max(walked.lastIndexOf(QLatin1Char('.')), walked.lastIndexOf(QLatin1Char('[')));
    walked = walked.left(std::max<qsizetype>(0, cut));
    // Only places that have a form of their own; inline groups are part of their owner's.
    if (sectionOf(context_.model->root(), walked) != walked) continue;
    const QString place = placeText(context_.model->root(), walked);
    links.prepend(
        QStringLiteral("<a href=\"%1\">%2</a>")
            .arg(walked.isEmpty() ? QStringLiteral(".") : walked,
                 place.mid(place.lastIndexOf(QChar(0x203A)) + 1).trimmed().toHtmlEscaped()));
  }
  if (links.isEmpty()) return;
  auto* crumb = new QLabel(links.join(QStringLiteral(" › ")), content_);
  crumb->setObjectName(QStringLiteral("breadcrumb"));
  crumb->setWordWrap(true);
  crumb->setAccessibleName(tr("Sections above"));
  crumb->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  form_style::setFontScale(crumb, 0.92);
  connect(crumb, &QLabel::linkActivated, this, [this](const QString& link) {
    emit sectionRequested(link == QLatin1String(".") ? QString() : link);
  });
  addWide(crumb);
}

QLabel* ParameterForm::makeText(const QString& text) {
  auto* label = new QLabel(text, content_);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  form_style::setFontScale(label, 0.92);
  form_style::setDimmed(label);
  return label;
}

void ParameterForm::addText(const QString& text) {
  if (!text.isEmpty()) addWide(makeText(text));
}

void ParameterForm::addHeader() {
  addBreadcrumb();
  const QString place = placeText(context_.model->root(), section_);
  auto* title = new QLabel(place.mid(place.lastIndexOf(QChar(0x203A)) + 1).trimmed(), content_);
  title->setObjectName(QStringLiteral("formTitle"));
  title->setTextFormat(Qt::PlainText);
  title->setWordWrap(true);
  form_style::setFontScale(title, 1.15, true);
  addWide(title, section_);
  headMessage_ = new QLabel(content_);
  headMessage_->setObjectName(QStringLiteral("formMessage"));
  headMessage_->setTextFormat(Qt::PlainText);
  headMessage_->setWordWrap(true);
  form_style::setFontScale(headMessage_, 0.92);
  headMessage_->hide();
  addWide(headMessage_);
}

void ParameterForm::addSection() {
  const auto at = context_.model->find(section_);
  if (at && !at->element) {
    if (at->field->kind == Kind::List) {
      addText(toQString(at->field->help));
      addList(*at->field, section_, false);
      return;
    }
    if (at->field->kind == Kind::Variant) {
      addRow(makeFieldEditor(context_, *at->field, section_, false, content_));
    }
  }
  const auto object = context_.model->object(section_);
  if (!object) return;
  addText(toQString(object->type->help));
  addObject(*object, section_);
}

void ParameterForm::addFields(schema::ConstRef object, const QString& path, bool advanced) {
  // Fields first: after a titled part they would seem to belong to it.
  const auto isPart = [&](const schema::Field& field) {
    return !field.isLeaf() && isInline(field, object.object);
  };
  for (const bool parts : {false, true}) {
    for (const auto& field : object.type->fields) {
      if (field.advanced != advanced || isPart(field) != parts) continue;
      addField(object, field, joinPath(path, toQString(field.key)));
    }
  }
}

void ParameterForm::addObject(schema::ConstRef object, const QString& path) {
  addFields(object, path, false);
  const auto& fields = object.type->fields;
  const bool hasAdvanced =
      std::any_of(fields.begin(), fields.end(), [](const auto& field) { return field.advanced; });
  if (!hasAdvanced) return;
  const bool nested = collecting_ != nullptr;
  if (!nested) addMore(toQString(object.type->key));
  addFields(object, path, true);
  if (!nested) collecting_ = nullptr;
}

void ParameterForm::addField(schema::ConstRef object, const schema::Field& field,
                             const QString& path) {
  const bool here = isInline(field, object.object);
  if (field.kind == Kind::List && here) return addList(field, path, true);
  if (field.kind != Kind::Group || !here) {
    FormRow* row = addRow(makeFieldEditor(context_, field, path, !here, content_));
    if (field.kind == Kind::Variant && here) row->makeHead();
  }
  if (field.isLeaf() || !here) return;
  const schema::ConstRef child(&field.childType(object.object, 0),
                               field.constChild(object.object, 0));
  if (field.kind == Kind::Group) {
    addTitle(toQString(field.label), toQString(field.help.empty() ? child.type->help : field.help),
             path);
  } else {
    addWide(makeText(toQString(child.type->help)), path);
  }
  addObject(child, path);
}

FormRow* ParameterForm::addRow(FieldEditor* editor) {
  auto* row = new FormRow(context_, editor, content_);
  nextRow_ = row->place(grid_, nextRow_);
  rows_.push_back(row);
  if (collecting_ != nullptr) collecting_->rows.push_back(row);
  connect(editor, &FieldEditor::openRequested, this, &ParameterForm::sectionRequested);
  return row;
}

void ParameterForm::addList(const schema::Field& field, const QString& path, bool titled) {
  if (titled) addTitle(toQString(field.label), toQString(field.help), path);
  ListEditor* list = makeListEditor(context_, field, path, content_);
  addWide(list);
  lists_.emplace_back(path, list);
  connect(list, &ListEditor::openRequested, this, &ParameterForm::sectionRequested);
}

void ParameterForm::addTitle(const QString& title, const QString& help, const QString& path) {
  auto* label = new QLabel(title, content_);
  label->setTextFormat(Qt::PlainText);
  label->setContentsMargins(0, form_style::kMargin, 0, 0);
  label->setToolTip(help);
  form_style::setFontScale(label, 1.0, true);
  addWide(label, path);
}

void ParameterForm::addMore(const QString& key) {
  auto* more = new QToolButton(content_);
  more->setObjectName(QStringLiteral("more.") + key);
  more->setText(tr("More"));
  more->setToolTip(tr("Fields that are seldom changed"));
  more->setCheckable(true);
  more->setAutoRaise(true);
  more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  grid_->addWidget(more, nextRow_++, 0, 1, 4, Qt::AlignLeft);
  parts_.push_back({more, key, {}, {}});
  collecting_ = &parts_.back();
  const std::size_t index = parts_.size() - 1;
  connect(more, &QToolButton::clicked, this,
          [this, index](bool shown) { setMoreShown(parts_[index], shown); });
}

void ParameterForm::addWide(QWidget* widget) {
  grid_->addWidget(widget, nextRow_++, 0, 1, 4);
  if (collecting_ != nullptr) collecting_->widgets.push_back(widget);
}

void ParameterForm::addWide(QLabel* label, const QString& path) {
  QToolButton* library = makeLibraryButton(context_, path, content_);
  if (library == nullptr) return addWide(label);
  auto* line = new QWidget(content_);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label, 1);
  row->addWidget(library, 0, Qt::AlignBottom);
  addWide(line);
}

void ParameterForm::setMoreShown(Part& part, bool shown) {
  if (shown) {
    opened_.insert(part.key);
  } else {
    opened_.remove(part.key);
  }
  part.more->setChecked(shown);
  part.more->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
  for (auto* row : part.rows) row->setVisible(shown);
  for (auto* widget : part.widgets) widget->setVisible(shown);
}

void ParameterForm::onValueChanged(const QString& path) {
  for (auto* row : rows_) {
    if (row->path() == path) row->refresh();
  }
  for (auto& [list, editor] : lists_) {
    if (isAtOrBelow(path, list)) editor->refresh();
  }
}

void ParameterForm::onStructureChanged(const QString& path) {
  for (auto& [list, editor] : lists_) {
    if (path == list) return editor->reload();
  }
  rebuildLater();
}

FormRow* ParameterForm::rowFor(const QString& path) const {
  FormRow* best = nullptr;
  for (auto* row : rows_) {
    if (!isAtOrBelow(path, row->path())) continue;
    if (best == nullptr || row->path().size() > best->path().size()) best = row;
  }
  return best;
}

ListEditor* ParameterForm::listFor(const QString& path) const {
  for (const auto& [list, editor] : lists_) {
    if (isAtOrBelow(path, list)) return editor;
  }
  return nullptr;
}

void ParameterForm::showProblems() {
  if (rebuildPending_) return;
  QHash<FormRow*, const Problem*> found;
  const Problem* ofSection = nullptr;
  for (const Problem& problem : context_.model->problems()) {
    const QString path = toQString(problem.path);
    FormRow* row = rowFor(path);
    if (row != nullptr && listFor(path) == nullptr) {
      if (!found.contains(row) || (found[row]->warning && !problem.warning)) found[row] = &problem;
    } else if (isAtOrBelow(path, section_) && ofSection == nullptr &&
               (!path.isEmpty() || section_.isEmpty())) {
      ofSection = &problem;
    }
  }
  for (auto* row : rows_) {
    const Problem* problem = found.value(row, nullptr);
    const bool leaf = row->editor()->field().isLeaf() || row->path() == section_;
    QString sentence = problem ? problemSentence(*problem) : QString();
    if (problem && !leaf && toQString(problem->path) != row->path()) {
      sentence = placeText(context_.model->root(), toQString(problem->path)) +
                 QStringLiteral(": ") + sentence;
    }
    row->setProblem(!problem           ? Severity::None
                    : problem->warning ? Severity::Warning
                                       : Severity::Error,
                    sentence, problem ? toQString(problem->path) : row->path());
  }
  for (auto& [list, editor] : lists_) editor->refresh();
  headMessage_->setText(ofSection ? problemSentence(*ofSection) : QString());
  if (ofSection != nullptr) headMessage_->show();
  form_style::setTextColour(
      headMessage_,
      form_style::severityColour(
          ofSection && ofSection->warning ? Severity::Warning : Severity::Error, palette()));
}

void ParameterForm::changeEvent(QEvent* event) {
  QScrollArea::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && content_ != nullptr) rebuildLater();
}

}  // namespace rotorbench
