#include "ui/library/component_info_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

namespace {

QPlainTextEdit* paragraph(const char* name, const QString& label, const std::string& text) {
  auto* edit = new QPlainTextEdit(toQString(text));
  edit->setObjectName(QString::fromLatin1(name));
  edit->setAccessibleName(label);
  edit->setTabChangesFocus(true);
  constexpr int kLines = 3;
  edit->setFixedHeight(kLines * edit->fontMetrics().lineSpacing() + 4 * form_style::kGrid);
  return edit;
}

}  // namespace

ComponentInfoDialog::ComponentInfoDialog(const QString& title, const ComponentInfo& info,
                                         Accept accept, QWidget* parent)
    : QDialog(parent),
      accept_(std::move(accept)),
      name_(new QLineEdit(toQString(info.name))),
      summary_(paragraph("infoSummary", tr("Summary"), info.summary)),
      source_(paragraph("infoSource", tr("Source"), info.source)),
      warning_(paragraph("infoWarning", tr("Note"), info.warning)),
      message_(new QLabel) {
  setObjectName(QStringLiteral("componentInfoDialog"));
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(420);
  name_->setObjectName(QStringLiteral("infoName"));
  name_->setAccessibleName(tr("Name"));
  name_->selectAll();
  source_->setPlaceholderText(tr("Where the numbers are from"));
  warning_->setPlaceholderText(tr("What must be known before use"));
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Summary"), summary_);
  form->addRow(tr("Source"), source_);
  form->addRow(tr("Note"), warning_);
  message_->setObjectName(QStringLiteral("infoMessage"));
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  message_->hide();
  form_style::setTextColour(message_,
                            form_style::severityColour(form_style::Severity::Error, palette()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setObjectName(QStringLiteral("infoOk"));
  connect(buttons, &QDialogButtonBox::accepted, this, &ComponentInfoDialog::finish);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(message_);
  column->addWidget(buttons);
  name_->setFocus();
}

void ComponentInfoDialog::finish() {
  const auto text = [](const QPlainTextEdit* edit) {
    return edit->toPlainText().trimmed().toStdString();
  };
  const QString sentence = accept_(
      {name_->text().trimmed().toStdString(), text(summary_), text(source_), text(warning_)});
  if (sentence.isEmpty()) return accept();
  message_->setText(sentence);
  message_->show();
  name_->setFocus();
}

}  // namespace rotorbench
