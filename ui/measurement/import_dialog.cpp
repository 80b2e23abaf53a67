#include "ui/measurement/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/forms/field_text.h"
#include "ui/measurement/mapping_memory.h"
#include "ui/measurement/mapping_table.h"

namespace rotorbench {

namespace {

constexpr auto kFolderKey = "measurement/folder";
constexpr int kCheckMilliseconds = 150;
constexpr int kReportLines = 5;

/// A box with the options of a described choice, their keys as data.
QComboBox* choiceBox(const schema::Type& type, std::string_view field, const char* name) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  for (const schema::Option& option : type.field(field)->options) {
    box->addItem(toQString(option.label), toQString(option.key));
  }
  box->setAccessibleName(toQString(type.field(field)->label));
  return box;
}

template <class Owner>
QString keyOf(const Owner& owner, std::string_view field) {
  const schema::Field& f = *schema::typeOf<Owner>().field(field);
  return toQString(std::get<std::string>(f.read(&owner)));
}

template <class Owner>
void take(Owner& owner, std::string_view field, const QComboBox& box) {
  schema::typeOf<Owner>().field(field)->write(&owner, box.currentData().toString().toStdString());
}

}  // namespace

ImportDialog::ImportDialog(RunList& runs, QWidget* parent) : QDialog(parent), runs_(runs) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import measured data"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(900, 620);
  build();
  checkTimer_.setSingleShot(true);
  checkTimer_.setInterval(kCheckMilliseconds);
  connect(&checkTimer_, &QTimer::timeout, this, &ImportDialog::check);
  say(tr("Choose a file: a table of text, such as the log of a thrust stand."), false);
}

void ImportDialog::build() {
  file_ = new QLineEdit;
  file_->setObjectName("importFile");
  file_->setAccessibleName(tr("File"));
  auto* browse = new QPushButton(QIcon::fromTheme("document-open"), tr("Choose…"));
  browse->setObjectName("importBrowse");
  browse->setAutoDefault(false);
  name_ = new QLineEdit;
  name_->setObjectName("importName");
  name_->setAccessibleName(tr("Name in the list of runs"));
  auto* fileRow = new QHBoxLayout;
  fileRow->addWidget(file_, 1);
  fileRow->addWidget(browse);
  auto* form = new QFormLayout;
  form->addRow(tr("File:"), fileRow);
  form->addRow(tr("Name:"), name_);
  layoutRow_ = buildLayoutRow();
  form->addRow(tr("Cells:"), layoutRow_);
  group_ = choiceBox(schema::typeOf<ImportSettings>(), "group", "importGroup");
  form->addRow(tr("Compare with:"), group_);

  table_ = new MappingTable;
  report_ = new QPlainTextEdit;
  report_->setObjectName("importReport");
  report_->setAccessibleName(tr("What will be imported"));
  report_->setReadOnly(true);
  report_->setTabChangesFocus(true);
  report_->setMaximumHeight((kReportLines + 1) * fontMetrics().lineSpacing());
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Import"));
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(table_, 1);
  layout->addWidget(report_);
  layout->addWidget(buttons_);

  connect(browse, &QPushButton::clicked, this, &ImportDialog::browse);
  connect(file_, &QLineEdit::editingFinished, this, [this] {
    const QString path = QDir::fromNativeSeparators(file_->text().trimmed());
    if (!path.isEmpty() && file_->isModified()) openFile(path);
  });
  connect(group_, &QComboBox::currentIndexChanged, this, &ImportDialog::mappingEdited);
  connect(table_, &MappingTable::mappingChanged, this, &ImportDialog::mappingEdited);
  connect(buttons_, &QDialogButtonBox::accepted, this, &ImportDialog::finish);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

// A path that loses the focus while its dialog is taken apart is not to be opened.
ImportDialog::~ImportDialog() {
  file_->disconnect(this);
}

// Enter in the path opens the file; it must not import what was open before.
void ImportDialog::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!enter || !file_->hasFocus()) QDialog::keyPressEvent(event);
}

QWidget* ImportDialog::buildLayoutRow() {
  const schema::Type& type = schema::typeOf<CsvLayout>();
  separator_ = choiceBox(type, "separator", "importSeparator");
  mark_ = choiceBox(type, "decimalMark", "importDecimalMark");
  const auto spin = [&](const char* field, const char* name) {
    auto* box = new QSpinBox;
    box->setObjectName(name);
    box->setAccessibleName(toQString(type.field(field)->label));
    box->setToolTip(toQString(type.field(field)->help));
    box->setRange(0, 1000000);
    box->setKeyboardTracking(false);
    return box;
  };
  header_ = spin("headerLine", "importHeaderLine");
  skipped_ = spin("skippedLines", "importSkippedLines");
  auto* widget = new QWidget;
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  for (auto [label, box] :
       std::initializer_list<std::pair<QString, QWidget*>>{{tr("Separated by"), separator_},
                                                           {tr("Decimal mark"), mark_},
                                                           {tr("Names in line"), header_},
                                                           {tr("Then skip"), skipped_}}) {
    row->addWidget(new QLabel(label));
    row->addWidget(box);
  }
  row->addStretch(1);
  for (QComboBox* box : {separator_, mark_})
    connect(box, &QComboBox::currentIndexChanged, this, &ImportDialog::layoutEdited);
  for (QSpinBox* box : {header_, skipped_})
    connect(box, &QSpinBox::valueChanged, this, &ImportDialog::layoutEdited);
  return widget;
}

void ImportDialog::browse() {
  const QString folder = QSettings().value(kFolderKey, QDir::homePath()).toString();
  const QString chosen = QFileDialog::getOpenFileName(
      this, tr("Import measured data"), folder,
      tr("Tables of text (*.csv *.txt *.tsv *.dat *.log);;All files (*)"));
  if (!chosen.isEmpty()) openFile(chosen);
}

void ImportDialog::openFile(const QString& file) {
  file_->setText(QDir::toNativeSeparators(file));
  file_->setModified(false);
  name_->setText(QFileInfo(file).completeBaseName());
  QSettings().setValue(kFolderKey, QFileInfo(file).absolutePath());
  lines_.reset();
  try {
    lines_ = TextLines::fromFile(file.toStdString());
  } catch (const InputError& error) {
    preview_ = {};
    table_->show(preview_, {});
    return say(problemSentence(error.problems().front()), false);
  }
  const ImportSettings guessed = guessSettings(*lines_);
  const CsvPreview preview = previewOf(*lines_, guessed.layout);
  takeSettings(rememberedSettings(preview).value_or(guessed));
}

void ImportDialog::takeSettings(const ImportSettings& settings) {
  settings_ = settings;
  const QSignalBlocker quiet[] = {QSignalBlocker(separator_), QSignalBlocker(mark_),
                                  QSignalBlocker(header_), QSignalBlocker(skipped_),
                                  QSignalBlocker(group_)};
  separator_->setCurrentIndex(separator_->findData(keyOf(settings.layout, "separator")));
  mark_->setCurrentIndex(mark_->findData(keyOf(settings.layout, "decimalMark")));
  header_->setValue(settings.layout.headerLine);
  skipped_->setValue(settings.layout.skippedLines);
  group_->setCurrentIndex(group_->findData(keyOf(settings, "group")));
  preview_ = previewOf(*lines_, settings_.layout);
  table_->show(preview_, settings_.columns);
  check();
}

CsvLayout ImportDialog::chosenLayout() const {
  CsvLayout layout = settings_.layout;
  take(layout, "separator", *separator_);
  take(layout, "decimalMark", *mark_);
  layout.headerLine = header_->value();
  layout.skippedLines = skipped_->value();
  return layout;
}

// Other columns may be other quantities: choices for columns of the same name stay, the rest is guessed.
void ImportDialog::layoutEdited() {
  if (!lines_) return;
  settings_.layout = chosenLayout();
  preview_ = previewOf(*lines_, settings_.layout);
  std::vector<ColumnMapping> columns = guessMapping(preview_);
  for (ColumnMapping& column : columns) {
    for (const ColumnMapping& known : table_->columns()) {
      if (known.column == column.column && !known.quantity.empty()) column = known;
    }
  }
  settings_.columns = columns;
  table_->show(preview_, columns);
  checkTimer_.start();
}

void ImportDialog::mappingEdited() {
  if (!lines_) return;
  take(settings_, "group", *group_);
  settings_.columns = table_->columns();
  checkTimer_.start();
}

void ImportDialog::check() {
  if (!lines_) return;
  const ImportResult result = importTable(*lines_, settings_);
  QStringList sentences;
  if (result.usable()) {
    QStringList names;
    for (const Channel& channel : result.table.channels) names << toQString(channel.name);
    sentences << tr("%n row(s) of %1 will be imported.", nullptr,
                    static_cast<int>(result.table.rows()))
                     .arg(names.join(", "));
  }
  for (const Problem& problem : result.problems) sentences << problemSentence(problem);
  say(sentences.join('\n'), result.usable());
}

void ImportDialog::say(const QString& text, bool usable) {
  report_->setPlainText(text);
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(usable);
  for (QWidget* widget : std::initializer_list<QWidget*>{layoutRow_, group_, table_, name_})
    widget->setEnabled(lines_.has_value());
}

void ImportDialog::finish() {
  checkTimer_.stop();
  const ImportResult result = importTable(*lines_, settings_);
  if (!result.usable()) return check();
  rememberSettings(preview_, settings_);
  const QString name = name_->text().trimmed().isEmpty() ? tr("Measured data") : name_->text();
  runs_.addMeasured(name, tr("From %1").arg(file_->text()), recordingOf(result.table));
  emit imported(tr("%1: %n row(s) imported.", nullptr, static_cast<int>(result.table.rows()))
                    .arg(name.trimmed()));
  accept();
}

}  // namespace rotorbench
