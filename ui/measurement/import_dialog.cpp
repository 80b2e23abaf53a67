#include "ui/measurement/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ui/measurement/choice_box.h"
#include "ui/measurement/layout_row.h"
#include "ui/measurement/mapping_memory.h"
#include "ui/measurement/mapping_table.h"
#include "ui/measurement/propeller_row.h"

namespace rotorbench {

namespace {

constexpr auto kFolderKey = "measurement/folder";
constexpr int kCheckMilliseconds = 150;
constexpr int kReportLines = 5;

/// "log" of "log.csv" and of "log.csv.gz".
QString nameOf(const QString& file) {
  const QFileInfo info(file);
  const QString name = info.completeBaseName();
  return info.suffix() == "gz" ? QFileInfo(name).completeBaseName() : name;
}

/// With the line or the column it is about.
QString placedSentence(const Problem& problem) {
  if (problem.path.empty()) return problemSentence(problem);
  Problem placed = problem;
  placed.what = problem.path + ": " + problem.what;
  return problemSentence(placed);
}

}  // namespace

ImportDialog::ImportDialog(RunList& runs, QWidget* parent) : QDialog(parent), runs_(runs) {
  setObjectName("importDialog");
  setWindowTitle(tr("Import measured data"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(960, 660);
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
  layoutRow_ = new LayoutRow;
  form->addRow(tr("Cells:"), layoutRow_);
  group_ = choiceBox(schema::typeOf<ImportSettings>(), "group", "importGroup");
  propeller_ = new PropellerRow;
  propeller_->hide();
  auto* groupRow = new QHBoxLayout;
  groupRow->addWidget(group_);
  groupRow->addWidget(propeller_);
  groupRow->addStretch(1);
  form->addRow(tr("Compare with:"), groupRow);

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
  connect(layoutRow_, &LayoutRow::edited, this, &ImportDialog::layoutEdited);
  connect(propeller_, &PropellerRow::speedChosen, this, &ImportDialog::mappingEdited);
  connect(propeller_, &PropellerRow::said, this, [this](const QString& sentence) {
    report_->setPlainText(sentence);
    emit imported(sentence);
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

// Enter in a line takes over what was typed there; it must not import what was open before.
void ImportDialog::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool inLine = qobject_cast<QLineEdit*>(focusWidget()) != nullptr && !name_->hasFocus();
  if (!enter || !inLine) QDialog::keyPressEvent(event);
}

void ImportDialog::browse() {
  const QString folder = QSettings().value(kFolderKey, QDir::homePath()).toString();
  const QString chosen = QFileDialog::getOpenFileName(
      this, tr("Import measured data"), folder,
      tr("Tables of text (*.csv *.txt *.tsv *.dat *.log *.gz);;All files (*)"));
  if (!chosen.isEmpty()) openFile(chosen);
}

void ImportDialog::openFile(const QString& file) {
  file_->setText(QDir::toNativeSeparators(file));
  file_->setModified(false);
  name_->setText(nameOf(file));
  QSettings().setValue(kFolderKey, QFileInfo(file).absolutePath());
  lines_.reset();
  try {
    lines_ = TextLines::fromFile(file.toStdString());
  } catch (const InputError& error) {
    preview_ = {};
    table_->show(preview_, {});
    propeller_->hide();
    return say(placedSentence(error.problems().front()), false);
  }
  const std::string title(lines_->tooLong(0) ? std::string_view() : lines_->line(0));
  propeller_->setNames({toQString(title), name_->text()}, file);
  const ImportSettings guessed = guessSettings(*lines_);
  guessed_ = previewOf(*lines_, guessed.layout);
  ImportSettings settings = rememberedSettings(guessed_).value_or(guessed);
  // The same columns may stand below other lines than last time.
  if (!checkSettings(settings, previewOf(*lines_, settings.layout)).empty())
    settings.layout = guessed.layout;
  takeSettings(settings);
}

void ImportDialog::takeSettings(const ImportSettings& settings) {
  settings_ = settings;
  layoutRow_->show(settings.layout);
  {
    const QSignalBlocker quiet(group_);
    showChoice(settings, "group", *group_);
  }
  preview_ = previewOf(*lines_, settings_.layout);
  table_->show(preview_, settings_.columns);
  check();
}

// Other columns may be other quantities: choices for columns of the same name stay, the rest is
// guessed.
void ImportDialog::layoutEdited() {
  if (!lines_) return;
  settings_.layout = layoutRow_->layout();
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
  takeChoice(settings_, "group", *group_);
  settings_.columns = table_->columns();
  checkTimer_.start();
}

void ImportDialog::check() {
  if (!lines_) return;
  const ImportResult result = importTable(*lines_, settings_);
  propeller_->show(result.usable() ? result.table : MeasuredTable{});
  const MeasuredTable table = propeller_->chosen(result.table);
  table_->showRanges(table, settings_.group);
  if (const QStringList faults = table_->faults(); !faults.isEmpty())
    return say(faults.join('\n'), false);
  QStringList sentences;
  if (result.usable()) {
    QStringList names;
    for (const Channel& channel : table.channels) names << toQString(channel.name);
    sentences << tr("%n row(s) of %1 will be imported.", nullptr, static_cast<int>(table.rows()))
                     .arg(names.join(", "));
  }
  for (const Problem& problem : result.problems) sentences << placedSentence(problem);
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
  settings_.columns = table_->columns();
  const ImportResult result = importTable(*lines_, settings_);
  if (!result.usable() || !table_->faults().isEmpty()) return check();
  const MeasuredTable table = propeller_->chosen(result.table);
  rememberSettings(guessed_, settings_);
  const QString name = name_->text().trimmed().isEmpty() ? tr("Measured data") : name_->text();
  runs_.addMeasured(name, tr("From %1").arg(file_->text()), recordingOf(table));
  emit imported(
      tr("%1: %n row(s) imported.", nullptr, static_cast<int>(table.rows())).arg(name.trimmed()));
  accept();
}

}  // namespace rotorbench
