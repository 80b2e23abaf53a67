// The list of runs with what can be done to them: show or hide, rename, note, compare, take over as
// the experiment in the editor, delete.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/runs/run_list.h"

class QAction;
class QListView;
class QStackedLayout;

namespace rotorbench {

class RunsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit RunsPanel(RunList& runs, QWidget* parent = nullptr);
  /// Ids of the selected runs, from top to bottom.
  [[nodiscard]] std::vector<int> selection() const;
  void select(int id);
  void clearSelection();

 signals:
  /// The user wants this run's experiment in the editor.
  void duplicateRequested(int id);
  /// The one selected run; its figures are shown.
  void selected(int id);

 private:
  QAction* addAction(const QString& icon, const QString& text, const QString& name,
                     void (RunsPanel::*slot)());
  void buildActions();
  void updateActions();
  void rename();
  void editNote();
  void duplicate();
  void compare();
  void removeSelected();

  RunList& runs_;
  QListView* view_;
  QStackedLayout* pages_;
  QAction* rename_ = nullptr;
  QAction* note_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* compare_ = nullptr;
  QAction* remove_ = nullptr;
};

}  // namespace rotorbench
