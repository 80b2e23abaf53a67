#include "ui/shell/actions.h"

#include <QApplication>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>

#include "sim/document/experiment.h"
#include "ui/shell/theme.h"
#include "ui/shell/tools.h"

namespace rotorbench {

namespace {

constexpr auto kIconProperty = "themedIcon";

QString tr(const char* text) {
  return QCoreApplication::translate("Actions", text);
}

/// Gives an action its name, icon, shortcuts and, in words, what it does.
QAction* prepared(QMainWindow& window, QAction* action, const char* name, const char* icon,
                  const QList<QKeySequence>& keys, const char* help = "") {
  action->setObjectName(name);
  action->setShortcuts(keys);
  action->setStatusTip(tr(help));
  if (*icon != '\0') {
    action->setProperty(kIconProperty, QString(icon));
    action->setIcon(themedIcon(icon));
  }
  window.addAction(action);
  return action;
}

QAction* make(QMainWindow& window, const char* text, const char* name, const char* icon,
              const QList<QKeySequence>& keys = {}, const char* help = "") {
  return prepared(window, new QAction(tr(text), &window), name, icon, keys, help);
}

void makeFileActions(Actions& a, QMainWindow& w) {
  a.gallery = make(w, "Start &page", "actionGallery", "go-home", {QKeySequence("Ctrl+Shift+H")},
                   "Show the ready experiments");
  a.create =
      make(w, "&New", "actionNew", "document-new", {QKeySequence::New}, "Start a new experiment");
  a.open = make(w, "&Open…", "actionOpen", "document-open", {QKeySequence::Open},
                "Open an experiment from a file");
  a.save =
      make(w, "&Save", "actionSave", "document-save", {QKeySequence::Save}, "Save the experiment");
  a.saveAs = make(w, "Save &as…", "actionSaveAs", "document-save-as",
                  {QKeySequence("Ctrl+Shift+S")}, "Save the experiment under another name");
  a.exportFigures = make(w, "&Export…", "actionExport", "document-export", {QKeySequence("Ctrl+E")},
                         "Export charts and recordings");
  a.quit = make(w, "&Quit", "actionQuit", "application-exit", {QKeySequence::Quit});
}

void makeRunActions(Actions& a, QMainWindow& w) {
  a.run = make(w, "&Run", "actionRun", "media-playback-start", {QKeySequence("F5")},
               "Run the experiment, or go on after a pause");
  a.pause = make(w, "&Pause", "actionPause", "media-playback-pause", {QKeySequence("F6")},
                 "Hold the run; Run goes on");
  a.step = make(w, "S&tep", "actionStep", "media-skip-forward", {QKeySequence("F10")},
                "Compute one recorded row, then pause");
  a.stop = make(w, "&Stop", "actionStop", "media-playback-stop", {QKeySequence("Shift+F5")},
                "End the run; what was recorded is kept");
  a.pace = new PaceBox;
}

void makeViewActions(Actions& a, QMainWindow& w) {
  a.resetLayout = make(w, "&Reset layout", "actionResetLayout", "view-restore", {},
                       "Put all panels where they were at first");
  a.fullScreen =
      make(w, "&Full screen", "actionFullScreen", "view-fullscreen", {QKeySequence("F11")});
  a.fullScreen->setCheckable(true);
  a.theme = new QActionGroup(&w);
  const std::pair<Theme, const char*> themes[]{
      {Theme::System, "&System"}, {Theme::Light, "&Light"}, {Theme::Dark, "&Dark"}};
  for (const auto& [theme, text] : themes) {
    auto* action = a.theme->addAction(tr(text));
    action->setObjectName("theme:" + themeKey(theme));
    action->setData(themeKey(theme));
    action->setCheckable(true);
  }
}

void makeHelpActions(Actions& a, QMainWindow& w) {
  a.helpHere = make(w, "Help on this &panel", "actionHelpHere", "help-contextual",
                    {QKeySequence("F1")}, "Open the help page of the panel or section in view");
  a.helpContents =
      make(w, "&Contents", "actionHelpContents", "help-contents", {QKeySequence("Shift+F1")});
  a.about = make(w, "&About Rotorbench", "actionAbout", "help-about");
}

QMenu* addMenu(QMainWindow& window, const char* title, const char* name) {
  QMenu* menu = window.menuBar()->addMenu(tr(title));
  menu->setObjectName(name);
  return menu;
}

/// One entry for each kind of experiment.
QMenu* newOfKindMenu(QMainWindow& window) {
  auto* menu = new QMenu(tr("New of &kind"), &window);
  menu->setObjectName("menuNewOfKind");
  const auto& kinds = schema::typeOf<Experiment>().field("setup")->options;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    QAction* action = menu->addAction(QString::fromStdString(kinds[kind].label));
    action->setObjectName("new:" + QString::fromStdString(kinds[kind].key));
    action->setData(static_cast<uint>(kind));
  }
  return menu;
}

void buildMenus(Actions& a, QMainWindow& window) {
  QMenu* file = addMenu(window, "&File", "menuFile");
  file->addAction(a.create);
  a.newOfKind = newOfKindMenu(window);
  file->addMenu(a.newOfKind);
  file->addAction(a.open);
  a.recent = file->addMenu(tr("Open &recent"));
  a.recent->setObjectName("menuRecent");
  file->addAction(a.gallery);
  file->addSeparator();
  file->addActions({a.save, a.saveAs});
  file->addSeparator();
  file->addAction(a.exportFigures);
  file->addSeparator();
  file->addAction(a.quit);
  addMenu(window, "&Edit", "menuEdit")->addActions({a.undo, a.redo});
  addMenu(window, "&Run", "menuRun")->addActions({a.run, a.pause, a.step, a.stop});
  a.tools = addMenu(window, "&Tools", "menuTools");
  for (const Tool& tool : tools()) {
    a.tools->addAction(make(window, tool.text, tool.name, tool.icon, {}, tool.help));
  }
  QMenu* view = addMenu(window, "&View", "menuView");
  a.panels = view->addMenu(tr("&Panels"));
  a.panels->setObjectName("menuPanels");
  QMenu* theme = view->addMenu(tr("&Theme"));
  theme->addActions(a.theme->actions());
  view->addSeparator();
  view->addActions({a.resetLayout, a.fullScreen});
  addMenu(window, "&Help", "menuHelp")->addActions({a.helpHere, a.helpContents, a.about});
}

void buildToolBar(Actions& a, QMainWindow& window) {
  QToolBar* bar = window.addToolBar(tr("Tool bar"));
  bar->setObjectName("mainToolBar");
  bar->setMovable(false);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  bar->setIconSize({20, 20});
  bar->addActions({a.create, a.open, a.save});
  bar->addSeparator();
  bar->addActions({a.undo, a.redo});
  bar->addSeparator();
  bar->addActions({a.run, a.pause, a.step, a.stop});
  auto* create = qobject_cast<QToolButton*>(bar->widgetForAction(a.create));
  create->setMenu(a.newOfKind);
  create->setPopupMode(QToolButton::MenuButtonPopup);
  // The one button a newcomer looks for says its name.
  auto* run = qobject_cast<QToolButton*>(bar->widgetForAction(a.run));
  run->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addWidget(a.pace);
  bar->addSeparator();
  bar->addAction(a.exportFigures);
}

}  // namespace

Actions buildActions(QMainWindow& window, QUndoStack& undoStack) {
  Actions a{};
  makeFileActions(a, window);
  a.undo = prepared(window, undoStack.createUndoAction(&window, tr("&Undo")), "actionUndo",
                    "edit-undo", {QKeySequence::Undo});
  a.redo = prepared(window, undoStack.createRedoAction(&window, tr("&Redo")), "actionRedo",
                    "edit-redo", {QKeySequence::Redo});
  makeRunActions(a, window);
  makeViewActions(a, window);
  makeHelpActions(a, window);
  buildMenus(a, window);
  buildToolBar(a, window);
  return a;
}

void refreshIcons(QWidget& window) {
  for (QAction* action : window.findChildren<QAction*>()) {
    const QString icon = action->property(kIconProperty).toString();
    if (!icon.isEmpty()) action->setIcon(themedIcon(icon));
  }
}

}  // namespace rotorbench
