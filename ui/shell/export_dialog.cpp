#include "ui/shell/export_dialog.h"

#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QtConcurrentRun>

#include "sim/run/preflight.h"
#include "sim/run/run_files.h"
#include "ui/charts/chart_grid.h"
#include "ui/charts/chart_pane.h"
#include "ui/charts/export_figure.h"
#include "ui/scene/scene_panel.h"

namespace rotorbench {

namespace {

constexpr auto kFolderKey = "export/folder";
constexpr auto kFormatKey = "export/format";
constexpr QSize kScenePicture{1600, 1000};

QString fileNameFrom(const QString& title) {
  QString name;
  for (const QChar c : title.toLower().simplified()) name += c.isLetterOrNumber() ? c : QChar('-');
  return name.isEmpty() ? QString("chart") : name;
}

}  // namespace

ExportDialog::ExportDialog(ChartGrid& charts, ScenePanel& scene, const RunList& runs,
                           QWidget* parent)
    : QDialog(parent),
      charts_(charts),
      scene_(scene),
      runs_(runs),
      what_(new QComboBox),
      format_(new QComboBox),
      target_(new QLineEdit),
      message_(new QLabel) {
  setObjectName("exportDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Export"));
  setMinimumWidth(520);
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  folder_ = QSettings().value(kFolderKey, documents).toString();
  what_->setObjectName("exportWhat");
  format_->setObjectName("exportFormat");
  target_->setObjectName("exportTarget");
  message_->setObjectName("exportMessage");
  message_->setWordWrap(true);
  message_->setMinimumHeight(2 * message_->fontMetrics().lineSpacing());
  auto* browse = new QPushButton(tr("Browse…"));
  browse->setObjectName("exportBrowse");
  auto* place = new QHBoxLayout;
  place->addWidget(target_, 1);
  place->addWidget(browse);
  auto* form = new QFormLayout;
  form->addRow(tr("&What"), what_);
  form->addRow(tr("&Format"), format_);
  form->addRow(tr("&To"), place);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  export_ = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
  export_->setObjectName("exportButton");
  export_->setDefault(true);
  copy_ = buttons->addButton(tr("&Copy to clipboard"), QDialogButtonBox::ActionRole);
  copy_->setObjectName("exportCopy");
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(message_);
  layout->addWidget(buttons);
  connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
  connect(copy_, &QPushButton::clicked, this, &ExportDialog::copy);
  connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(what_, &QComboBox::currentIndexChanged, this, &ExportDialog::updateForItem);
  connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::updateTarget);
  connect(&writing_, &QFutureWatcher<QString>::finished, this, &ExportDialog::finishRun);
  fillItems(runs);
}

ExportDialog::~ExportDialog() {
  writing_.waitForFinished();
}

void ExportDialog::fillItems(const RunList& runs) {
  const auto& panes = charts_.panes();
  for (int i = 0; i < static_cast<int>(panes.size()); ++i) {
    const QString title = QString::fromStdString(panes[static_cast<std::size_t>(i)]->spec().title);
    addItem(tr("Chart %1: %2").arg(i + 1).arg(title.isEmpty() ? tr("without title") : title),
            {What::Chart, i});
  }
  if (panes.size() > 1) addItem(tr("All charts"), {What::AllCharts, 0});
  addItem(tr("3D view"), {What::Scene, 0});
  for (const RunRecord& record : runs.records()) {
    if (record.measured || isActive(record.status.state) || record.status.outputs.empty()) continue;
    addItem(tr("Recording and metrics of %1").arg(record.name), {What::Run, record.id});
  }
  updateForItem();
}

void ExportDialog::addItem(const QString& text, Item item) {
  items_.push_back(item);
  what_->addItem(text);
}

ExportDialog::Item ExportDialog::item() const {
  return items_[static_cast<std::size_t>(std::max(0, what_->currentIndex()))];
}

ChartPane& ExportDialog::pane() const {
  return *charts_.panes()[static_cast<std::size_t>(item().index)];
}

bool ExportDialog::toFolder() const {
  return item().what == What::AllCharts || item().what == What::Run;
}

void ExportDialog::updateForItem() {
  if (what_->currentIndex() < 0) return;
  const What what = item().what;
  const QSignalBlocker blocker(format_);
  format_->clear();
  if (what == What::Run) {
    format_->addItem(tr("CSV and JSON"), "csv");
  } else {
    format_->addItem(tr("PNG picture"), "png");
    if (what != What::Scene) {
      format_->addItem(tr("SVG drawing"), "svg");
      format_->addItem(tr("PDF drawing"), "pdf");
      format_->addItem(tr("CSV table of the visible range"), "csv");
    }
    const int last = format_->findData(QSettings().value(kFormatKey, "png"));
    format_->setCurrentIndex(std::max(0, last));
  }
  copy_->setEnabled(what == What::Chart || what == What::Scene);
  updateTarget();
}

void ExportDialog::updateTarget() {
  const QDir folder(folder_);
  QString name = folder.path();
  const QString ending = format_->currentData().toString();
  if (item().what == What::Chart) {
    name =
        folder.filePath(fileNameFrom(QString::fromStdString(pane().spec().title)) + '.' + ending);
  } else if (item().what == What::Scene) {
    name = folder.filePath("scene.png");
  } else if (item().what == What::Run) {
    name = folder.filePath(QString("run-%1").arg(item().index));
  }
  target_->setText(QDir::toNativeSeparators(name));
}

void ExportDialog::browse() {
  const bool folder = toFolder();
  auto* dialog = new QFileDialog(this, tr("Export to"), target_->text());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(folder ? QFileDialog::Directory : QFileDialog::AnyFile);
  dialog->setAcceptMode(folder ? QFileDialog::AcceptOpen : QFileDialog::AcceptSave);
  if (!folder) {
    dialog->setDefaultSuffix(format_->currentData().toString());
    dialog->selectFile(target_->text());
  }
  connect(dialog, &QFileDialog::fileSelected, target_,
          [this](const QString& path) { target_->setText(QDir::toNativeSeparators(path)); });
  dialog->open();
}

void ExportDialog::accept() {
  if (target_->text().trimmed().isEmpty()) {
    message_->setText(tr("Give a file or folder to export to."));
    return;
  }
  exportNow();
}

void ExportDialog::exportNow() {
  const QString path = QFileInfo(target_->text().trimmed()).absoluteFilePath();
  folder_ = item().what == What::AllCharts ? path : QFileInfo(path).path();
  QSettings().setValue(kFolderKey, folder_);
  if (item().what != What::Run) QSettings().setValue(kFormatKey, format_->currentData());
  const QString success = tr("Written: %1").arg(QDir::toNativeSeparators(path));
  const auto format = formatOf("x." + format_->currentData().toString());
  switch (item().what) {
    case What::Chart:
      return report(exportPane(pane(), path, *format), success);
    case What::AllCharts:
      QDir().mkpath(path);
      return report(exportAllPanes(charts_, path, *format), success);
    case What::Scene:
      return report(scene_.snapshot(kScenePicture).save(path)
                        ? QString()
                        : tr("“%1” cannot be written.").arg(path),
                    success);
    case What::Run:
      return exportRun(item().index);
  }
}

// A long recording is a large file: it is written while the window stays alive.
void ExportDialog::exportRun(int id) {
  const RunRecord* record = runs_.find(id);
  if (record == nullptr) return;
  message_->setText(tr("Writing…"));
  export_->setEnabled(false);
  const std::filesystem::path folder = QFileInfo(target_->text()).absoluteFilePath().toStdString();
  writing_.setFuture(QtConcurrent::run(
      [folder, experiment = record->experiment, runs = record->status.outputs,
       summary = RunSummary{record->status.metrics, record->status.verdicts,
                            preflight(record->experiment), record->status.events}]() -> QString {
        try {
          prepareRunDirectory(folder);
          writeRunFiles(folder, experiment, runs, summary);
          return {};
        } catch (const std::exception& error) {
          return QString::fromUtf8(error.what());
        }
      }));
}

void ExportDialog::finishRun() {
  export_->setEnabled(true);
  report(writing_.result(), tr("Written to %1").arg(target_->text()));
}

void ExportDialog::copy() {
  if (item().what == What::Chart) return report({}, copyPane(pane()));
  QGuiApplication::clipboard()->setImage(scene_.snapshot(kScenePicture));
  report({}, tr("The 3D view was copied."));
}

void ExportDialog::report(const QString& error, const QString& success) {
  message_->setText(error.isEmpty() ? success : error);
  if (error.isEmpty()) emit exported(success);
}

}  // namespace rotorbench
