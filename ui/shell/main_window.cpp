#include "ui/shell/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTimer>

#include "sim/document/resources.h"
#include "ui/forms/help_table.h"
#include "ui/forms/problems_panel.h"
#include "ui/measurement/import_dialog.h"
#include "ui/shell/chart_binding.h"
#include "ui/shell/export_dialog.h"
#include "ui/shell/gallery.h"
#include "ui/shell/help_viewer.h"
#include "ui/shell/log_panel.h"
#include "ui/shell/run_desk.h"
#include "ui/shell/schema_types.h"
#include "ui/shell/screen_fit.h"
#include "ui/shell/status_bar.h"
#include "ui/shell/theme.h"
#include "ui/shell/tools.h"
#include "ui/shell/workbench.h"

namespace rotorbench {

namespace {

constexpr auto kGeometryKey = "window/geometry";
constexpr auto kThemeKey = "window/theme";
constexpr int kMessageMilliseconds = 8000;
constexpr QSize kUsualSize{1440, 900};

/// By the ending; whatever else is dropped is taken for an experiment.
bool isMeasuredData(const QString& file) {
  static const QStringList endings{"csv", "txt", "tsv", "log", "dat"};
  return endings.contains(QFileInfo(file).suffix().toLower());
}

QString autosaveFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/autosave";
}

/// Palette and icons come first: everything made after them looks right from the start.
Theme startTheme() {
  const Theme theme = themeFromKey(QSettings().value(kThemeKey).toString());
  applyTheme(theme);
  return theme;
}

QString parameterTable(const QString& typeKey) {
  const schema::Type* type = findType(schema::typeOf<Experiment>(), typeKey.toStdString());
  return type == nullptr ? QString() : parameterTableHtml(*type, QLocale());
}

}  // namespace

MainWindow::MainWindow(RunController::Builder builder, QWidget* parent)
    : QMainWindow(parent),
      theme_(startTheme()),
      documents_(autosaveFolder()),
      controller_(runs_, std::move(builder)),
      actions_(buildActions(*this, *documents_.model().undoStack())),
      dialogs_(new DocumentDialogs(documents_, *this)) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  setContextMenuPolicy(Qt::NoContextMenu);
  buildPages();
  connectFileActions();
  connectRunActions();
  connectTools();
  connectViewActions();
  connectHelpActions();
  resize(fittedSize(kUsualSize, screen()->availableSize()));
  new ScreenFit(this);
  restoreGeometry(QSettings().value(kGeometryKey).toByteArray());
  // It may have been saved on a larger screen.
  if (!isMaximized() && !isFullScreen()) resize(fittedSize(size(), screen()->availableSize()));
  showGallery();
  updateTitle();
  updateRunActions();
  QTimer::singleShot(0, dialogs_, &DocumentDialogs::offerRecovery);
}

// The pages look at documents and runs, which are members and would go first.
MainWindow::~MainWindow() {
  controller_.stopAndWait();
  delete desk_;
  delete takeCentralWidget();
}

void MainWindow::buildPages() {
  status_ = new StatusBar(this);
  setStatusBar(status_);
  gallery_ = new Gallery(documents_.recentFiles());
  bench_ = new Workbench(documents_.model(), runs_);
  desk_ = new RunDesk(documents_, *bench_, runs_, controller_, this);
  new ChartBinding(documents_.model(), bench_->charts(), bench_);
  pages_ = new QStackedWidget;
  pages_->setObjectName("pages");
  pages_->addWidget(gallery_);
  pages_->addWidget(bench_);
  setCentralWidget(pages_);
  connect(gallery_, &Gallery::experimentChosen, this,
          [this](const QString& file) { dialogs_->openFile(file, true); });
  connect(gallery_, &Gallery::fileChosen, this, &MainWindow::openFile);
  connect(gallery_, &Gallery::openRequested, dialogs_, &DocumentDialogs::openWithDialog);
  connect(gallery_, &Gallery::backRequested, this, &MainWindow::showWorkbench);
  connect(gallery_, &Gallery::newRequested, this, [this] { dialogs_->startNew(); });
  connect(&documents_, &DocumentController::opened, this, &MainWindow::showWorkbench);
  connect(&documents_, &DocumentController::titleChanged, this, &MainWindow::updateTitle);
  connect(desk_, &RunDesk::message, this, &MainWindow::say);
  connect(status_, &StatusBar::problemsClicked, this, [this] {
    showWorkbench();
    bench_->bringUp(bench_->problems());
  });
  const auto showProblems = [this] { status_->showProblems(documents_.model().problems()); };
  connect(&documents_.model(), &DocumentModel::problemsChanged, this, showProblems);
  showProblems();
}

void MainWindow::connectFileActions() {
  const Actions& a = actions_;
  connect(a.gallery, &QAction::triggered, this, &MainWindow::showGallery);
  connect(a.create, &QAction::triggered, this, [this] { dialogs_->startNew(); });
  connect(a.newOfKind, &QMenu::triggered, this,
          [this](const QAction* kind) { dialogs_->startNew(kind->data().toUInt()); });
  connect(a.open, &QAction::triggered, dialogs_, &DocumentDialogs::openWithDialog);
  connect(a.save, &QAction::triggered, dialogs_, &DocumentDialogs::save);
  connect(a.saveAs, &QAction::triggered, dialogs_, &DocumentDialogs::saveAs);
  connect(a.exportFigures, &QAction::triggered, this, &MainWindow::showExport);
  connect(a.quit, &QAction::triggered, this, &QWidget::close);
  connect(dialogs_, &DocumentDialogs::saved, this, [this](const QString& file) {
    const QString sentence = tr("Saved: %1").arg(QDir::toNativeSeparators(file));
    bench_->log().add(sentence);
    say(sentence);
  });
  connect(&documents_.recentFiles(), &RecentFiles::changed, this, &MainWindow::fillRecentMenu);
  fillRecentMenu();
}

void MainWindow::connectRunActions() {
  const Actions& a = actions_;
  connect(a.run, &QAction::triggered, desk_, &RunDesk::run);
  connect(a.pause, &QAction::triggered, &controller_, &RunController::pause);
  connect(a.step, &QAction::triggered, desk_, &RunDesk::step);
  connect(a.stop, &QAction::triggered, &controller_, &RunController::stop);
  connect(a.pace, &PaceBox::paceChanged, desk_, &RunDesk::setPace);
  desk_->setPace(a.pace->pace());
  connect(&controller_, &RunController::stateChanged, this, &MainWindow::updateRunActions);
  connect(&documents_, &DocumentController::opened, this, &MainWindow::updateRunActions);
  connect(&controller_, &RunController::updated, this,
          [this] { status_->showRun(desk_->status()); });
}

void MainWindow::connectTools() {
  const auto note = [this](const QString& sentence) {
    bench_->log().add(sentence);
    say(sentence);
  };
  const ToolContext context{this, documents_, runs_, *bench_, note};
  const QList<QAction*> actions = actions_.tools->actions();
  for (qsizetype i = 0; i < actions.size(); ++i) {
    const Tool& tool = tools()[static_cast<std::size_t>(i)];
    connect(actions[i], &QAction::triggered, this, [this, &tool, context] {
      showWorkbench();
      tool.open(context);
      answerHelpKey(tool.topic);
    });
  }
}

/// Gives the dialog that has just come up its page of the help; windows of their own do not see the
/// main window's keys.
void MainWindow::answerHelpKey(const QString& topic) {
  const QString name = QStringLiteral("helpKey");
  for (auto* dialog : findChildren<QDialog*>(Qt::FindDirectChildrenOnly)) {
    if (dialog->findChild<QShortcut*>(name, Qt::FindDirectChildrenOnly) != nullptr) continue;
    auto* key = new QShortcut(QKeySequence(Qt::Key_F1), dialog);
    key->setObjectName(name);
    connect(key, &QShortcut::activated, this, [this, topic] { showHelp({topic}); });
  }
}

void MainWindow::connectViewActions() {
  const Actions& a = actions_;
  a.panels->addActions(bench_->panelActions());
  connect(a.resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
  connect(a.fullScreen, &QAction::toggled, this,
          [this](bool on) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, on)); });
  connect(a.theme, &QActionGroup::triggered, this,
          [this](const QAction* action) { chooseTheme(action->data().toString()); });
  for (QAction* action : a.theme->actions()) {
    action->setChecked(action->data() == themeKey(theme_));
  }
}

void MainWindow::connectHelpActions() {
  const Actions& a = actions_;
  connect(a.helpContents, &QAction::triggered, this, [this] { showHelp({"index"}); });
  connect(a.helpHere, &QAction::triggered, this, [this] {
    showHelp(pages_->currentWidget() == bench_ ? bench_->helpTopics(documents_.model())
                                               : QStringList{"gallery"});
  });
  connect(a.about, &QAction::triggered, this, &MainWindow::showAbout);
}

void MainWindow::openFile(const QString& file) {
  dialogs_->openFile(file);
}

void MainWindow::resetLayout() {
  bench_->resetLayout();
}

void MainWindow::showGallery() {
  gallery_->setOpenDocument(openedOnce_ ? documents_.displayName() : QString());
  pages_->setCurrentWidget(gallery_);
  updateTitle();
  updateRunActions();
}

void MainWindow::showWorkbench() {
  openedOnce_ = true;
  pages_->setCurrentWidget(bench_);
  updateTitle();
  updateRunActions();
}

void MainWindow::fillRecentMenu() {
  actions_.recent->clear();
  const QStringList files = documents_.recentFiles().files();
  actions_.recent->setEnabled(!files.isEmpty());
  for (const QString& file : files) {
    // An ampersand in a file name is no shortcut.
    QAction* action = actions_.recent->addAction(QDir::toNativeSeparators(file).replace('&', "&&"));
    connect(action, &QAction::triggered, this, [this, file] { openFile(file); });
  }
  if (files.isEmpty()) return;
  actions_.recent->addSeparator();
  actions_.recent->addAction(tr("Clear list"), &documents_.recentFiles(), &RecentFiles::clear);
}

void MainWindow::updateTitle() {
  setWindowTitle(openedOnce_ ? tr("%1[*] – Rotorbench").arg(documents_.displayName())
                             : tr("Rotorbench[*]"));
  setWindowFilePath(documents_.file());
  setWindowModified(documents_.hasUnsavedChanges());
}

void MainWindow::updateRunActions() {
  const RunState state = controller_.state();
  const bool bench = pages_->currentWidget() == bench_;
  const bool active = isActive(state);
  actions_.run->setEnabled(bench && (!active || state == RunState::Paused));
  actions_.run->setText(state == RunState::Paused ? tr("&Continue") : tr("&Run"));
  actions_.pause->setEnabled(bench && (state == RunState::Running || state == RunState::Building));
  actions_.step->setEnabled(bench);
  actions_.stop->setEnabled(bench && active);
  actions_.pace->setEnabled(bench && RunDesk::isPaced(documents_.experiment()));
  actions_.exportFigures->setEnabled(bench);
  if (openedOnce_) status_->showRun(desk_->status());
}

void MainWindow::chooseTheme(const QString& key) {
  theme_ = themeFromKey(key);
  QSettings().setValue(kThemeKey, key);
  applyTheme(theme_);
  refreshIcons(*this);
}

void MainWindow::showExport() {
  auto* dialog = new ExportDialog(bench_->charts(), bench_->scene(), runs_, this);
  connect(dialog, &ExportDialog::exported, this, [this](const QString& sentence) {
    bench_->log().add(sentence);
    say(sentence);
  });
  dialog->open();
}

void MainWindow::showHelp(const QStringList& topics) {
  if (help_ == nullptr) {
    const QString folder = QString::fromStdString((resourceDirectory() / "help").string());
    help_ = new HelpViewer(HelpLibrary(folder, parameterTable), this);
  }
  help_->showTopic(topics);
}

void MainWindow::showAbout() {
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About Rotorbench"),
                              tr("<h3>Rotorbench %1</h3>").arg(QApplication::applicationVersion()),
                              QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(
      tr("A workbench that simulates and analyses quadrotors and their parts.<br>"
         "Free software under the GNU General Public License, version 3 or later."));
  box->setIconPixmap(windowIcon().pixmap(64, 64));
  box->open();
}

void MainWindow::say(const QString& sentence) {
  status_->showMessage(sentence, kMessageMilliseconds);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closing_ && documents_.hasUnsavedChanges()) {
    event->ignore();
    dialogs_->guard([this] {
      closing_ = true;
      close();
    });
    return;
  }
  controller_.stopAndWait();
  documents_.autosave().forget();
  QSettings().setValue(kGeometryKey, saveGeometry());
  bench_->saveLayout();
  if (help_ != nullptr) help_->close();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  const QString file = event->mimeData()->urls().front().toLocalFile();
  if (isMeasuredData(file)) return importData(file);
  openFile(file);
}

/// Measured data dropped on the window: the same dialog as by the menu, with the file in it.
void MainWindow::importData(const QString& file) {
  showWorkbench();
  auto* dialog = new ImportDialog(runs_, this);
  connect(dialog, &ImportDialog::imported, this, &MainWindow::say);
  dialog->open();
  dialog->openFile(file);
  answerHelpKey("measured-data");
}

}  // namespace rotorbench
