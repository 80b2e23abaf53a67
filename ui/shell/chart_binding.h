// Keeps the charts on screen and `outputs.charts` of the document the same: what a person does to a
// chart is an edit of the experiment and can be undone. A document that names no charts shows those
// of its kind.
#pragma once

#include <QObject>

#include "ui/charts/chart_grid.h"
#include "ui/forms/document_model.h"

namespace rotorbench {

class ChartBinding : public QObject {
  Q_OBJECT

 public:
  ChartBinding(DocumentModel& model, ChartGrid& charts, QObject* parent = nullptr);

 private:
  void toCharts();
  void toDocument();

  DocumentModel& model_;
  ChartGrid& charts_;
  bool writing_ = false;
};

}  // namespace rotorbench
