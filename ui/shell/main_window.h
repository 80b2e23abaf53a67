// The window: start page and workbench, with the menus, the tool bar and the status bar that belong
// to both. Owns document, runs and panels and connects them; each does its own work.
#pragma once

#include <QMainWindow>
#include <memory>

#include "sim/run/simulation.h"
#include "ui/runs/run_controller.h"
#include "ui/shell/actions.h"
#include "ui/shell/document_controller.h"
#include "ui/shell/document_dialogs.h"
#include "ui/shell/theme.h"

class QStackedWidget;

namespace rotorbench {

class Gallery;
class HelpViewer;
class RunDesk;
class StatusBar;
class Workbench;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Tests give their own simulation builder.
  explicit MainWindow(RunController::Builder builder = buildSimulation, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] DocumentController& documents() { return documents_; }
  [[nodiscard]] RunList& runs() { return runs_; }
  [[nodiscard]] RunController& controller() { return controller_; }
  [[nodiscard]] Workbench& workbench() { return *bench_; }

  /// Opens a file given on the command line or dropped on the window.
  void openFile(const QString& file);
  void resetLayout();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void buildPages();
  void connectFileActions();
  void connectRunActions();
  void connectTools();
  void answerHelpKey(const QString& topic);
  void importData(const QString& file);
  void connectViewActions();
  void connectHelpActions();
  void showGallery();
  void showWorkbench();
  void fillRecentMenu();
  void updateTitle();
  void updateRunActions();
  void chooseTheme(const QString& key);
  void showExport();
  void showHelp(const QStringList& topics);
  void showAbout();
  void say(const QString& sentence);

  Theme theme_;
  DocumentController documents_;
  RunList runs_;
  RunController controller_;
  Actions actions_;
  DocumentDialogs* dialogs_;
  QStackedWidget* pages_ = nullptr;
  Gallery* gallery_ = nullptr;
  Workbench* bench_ = nullptr;
  RunDesk* desk_ = nullptr;
  StatusBar* status_ = nullptr;
  HelpViewer* help_ = nullptr;
  bool openedOnce_ = false;  ///< the workbench has an experiment to go back to
  bool closing_ = false;
};

}  // namespace rotorbench
