#include "ui/measurement/layout_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>

#include "ui/measurement/choice_box.h"

namespace rotorbench {

namespace {

constexpr int kMostLines = 1000000;
constexpr int kLongestMark = 8;

const schema::Field& field(std::string_view name) {
  return *schema::typeOf<CsvLayout>().field(name);
}

template <class Widget>
Widget* described(std::string_view name, const char* objectName) {
  auto* widget = new Widget;
  widget->setObjectName(objectName);
  widget->setAccessibleName(toQString(field(name).label));
  widget->setToolTip(toQString(field(name).help));
  return widget;
}

QSpinBox* lineBox(std::string_view name, const char* objectName) {
  auto* box = described<QSpinBox>(name, objectName);
  box->setRange(0, kMostLines);
  box->setKeyboardTracking(false);
  return box;
}

}  // namespace

LayoutRow::LayoutRow(QWidget* parent)
    : QWidget(parent),
      separator_(choiceBox(schema::typeOf<CsvLayout>(), "separator", "importSeparator")),
      mark_(choiceBox(schema::typeOf<CsvLayout>(), "decimalMark", "importDecimalMark")),
      comment_(described<QLineEdit>("comment", "importComment")),
      header_(lineBox("headerLine", "importHeaderLine")),
      skipped_(lineBox("skippedLines", "importSkippedLines")) {
  comment_->setMaxLength(kLongestMark);
  comment_->setMaximumWidth(fontMetrics().horizontalAdvance("#####") +
                            2 * fontMetrics().horizontalAdvance("m"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  const std::initializer_list<std::pair<QString, QWidget*>> parts{{tr("S&eparated by"), separator_},
                                                                  {tr("&Decimal mark"), mark_},
                                                                  {tr("C&omment mark"), comment_},
                                                                  {tr("Na&mes in line"), header_},
                                                                  {tr("Then s&kip"), skipped_}};
  for (const auto& [text, widget] : parts) {
    auto* label = new QLabel(text);
    label->setBuddy(widget);
    row->addWidget(label);
    row->addWidget(widget);
  }
  row->addStretch(1);
  for (QComboBox* box : {separator_, mark_})
    connect(box, &QComboBox::currentIndexChanged, this, &LayoutRow::edited);
  for (QSpinBox* box : {header_, skipped_})
    connect(box, &QSpinBox::valueChanged, this, &LayoutRow::edited);
  connect(comment_, &QLineEdit::textChanged, this, &LayoutRow::edited);
}

void LayoutRow::show(const CsvLayout& layout) {
  const QSignalBlocker quiet(this);
  showChoice(layout, "separator", *separator_);
  showChoice(layout, "decimalMark", *mark_);
  comment_->setText(toQString(layout.comment));
  header_->setValue(layout.headerLine);
  skipped_->setValue(layout.skippedLines);
}

CsvLayout LayoutRow::layout() const {
  CsvLayout layout;
  takeChoice(layout, "separator", *separator_);
  takeChoice(layout, "decimalMark", *mark_);
  layout.comment = comment_->text().trimmed().toStdString();
  layout.headerLine = header_->value();
  layout.skippedLines = skipped_->value();
  return layout;
}

}  // namespace rotorbench
