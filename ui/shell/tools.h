// The commands of the Tools menu: dialogs beside the experiment, one line each. A tool gets what it
// may work with and opens itself; adding one is one line in tools.cpp.
#pragma once

#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace rotorbench {

class DocumentController;
class RunList;
class Workbench;

struct ToolContext {
  QWidget* window;  ///< parent of the dialog
  DocumentController& documents;
  RunList& runs;
  Workbench& bench;
  std::function<void(const QString&)> say;  ///< one sentence for the status bar and the log
};

struct Tool {
  const char* name;   ///< object name of the action
  const char* text;   ///< in the menu
  const char* icon;   ///< of the icon theme
  const char* help;   ///< one line for the status bar
  const char* topic;  ///< page of the help that F1 opens in its dialog
  void (*open)(const ToolContext&);
};

/// In the order of the menu.
const std::vector<Tool>& tools();

}  // namespace rotorbench
