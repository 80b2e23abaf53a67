// What is wrong with the document, one line each: where and what. A click (or Enter) asks to go
// there.
#pragma once

#include <QWidget>

#include "ui/forms/form_context.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace rotorbench {

class ProblemsPanel : public QWidget {
  Q_OBJECT

 public:
  /// `model` must outlive the panel.
  explicit ProblemsPanel(DocumentModel* model, QWidget* parent = nullptr);

 signals:
  void jumpTo(const QString& path);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void rebuild();
  void jump(const QTreeWidgetItem* item);

  DocumentModel* model_;
  QTreeWidget* list_;
  QLabel* empty_;
};

}  // namespace rotorbench
