// Every command of the window with its name, icon and shortcut, and the menus and the tool bar that
// show them. What a command does is connected by the main window.
#pragma once

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "ui/shell/pace_box.h"

class QMainWindow;
class QUndoStack;

namespace rotorbench {

struct Actions {
  // File
  QAction *gallery, *create, *open, *save, *saveAs, *exportFigures, *quit;
  QMenu *recent, *newOfKind;  ///< newOfKind: data() of its actions is the alternative of `setup`
  // Edit
  QAction *undo, *redo;
  // Run
  QAction *run, *pause, *step, *stop;
  PaceBox* pace;
  // Tools
  QMenu* tools;
  // View
  QMenu* panels;
  QActionGroup* theme;  ///< data(): themeKey()
  QAction *resetLayout, *fullScreen;
  // Help
  QAction *helpContents, *helpHere, *about;
};

/// Makes the actions as children of the window, its menu bar and its tool bar ("mainToolBar").
Actions buildActions(QMainWindow& window, QUndoStack& undoStack);

/// Sets the icons anew after a change of theme.
void refreshIcons(QWidget& window);

}  // namespace rotorbench
