// What leaves the program: a chart or all of them as a figure or table, the 3D view as a picture, a
// run's recordings with its metrics and experiment.
#pragma once

#include <QDialog>
#include <QFutureWatcher>

#include "ui/runs/run_list.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rotorbench {

class ChartGrid;
class ChartPane;
class ScenePanel;

class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(ChartGrid& charts, ScenePanel& scene, const RunList& runs,
               QWidget* parent = nullptr);
  ~ExportDialog() override;

 signals:
  /// A sentence about what was written.
  void exported(const QString& sentence);

 private:
  enum class What { Chart, AllCharts, Scene, Run };
  struct Item {
    What what;
    int index;  ///< of the pane, or id of the run
  };

  void fillItems(const RunList& runs);
  void addItem(const QString& text, Item item);
  void updateForItem();
  void updateTarget();
  void browse();
  void accept() override;
  void exportNow();
  void exportRun(int id);
  void finishRun();
  void copy();
  void report(const QString& error, const QString& success);
  [[nodiscard]] Item item() const;
  [[nodiscard]] ChartPane& pane() const;
  [[nodiscard]] bool toFolder() const;

  ChartGrid& charts_;
  ScenePanel& scene_;
  const RunList& runs_;
  std::vector<Item> items_;
  QString folder_;
  QComboBox* what_;
  QComboBox* format_;
  QLineEdit* target_;
  QLabel* message_;
  QPushButton* copy_;
  QPushButton* export_;
  QFutureWatcher<QString> writing_;
};

}  // namespace rotorbench
