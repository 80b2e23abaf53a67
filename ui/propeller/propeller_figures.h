// What a propeller does, live beside its editor: thrust and power coefficient and efficiency over
// the advance ratio at a rotor speed a person chooses, and the figures one looks for in a sentence.
// Standard air at sea level.
#pragma once

#include <QWidget>

#include "sim/propulsion/rotor/blade.h"
#include "ui/charts/chart_link.h"
#include "ui/charts/run_set.h"

class QDoubleSpinBox;
class QLabel;

namespace rotorbench {

class ChartPane;

class PropellerFigures : public QWidget {
  Q_OBJECT

 public:
  explicit PropellerFigures(QWidget* parent = nullptr);
  ~PropellerFigures() override;

  /// The geometry must satisfy its schema.
  void setPropeller(const PropellerGeometry& geometry);
  /// Instead of figures: why there are none.
  void setMessage(const QString& sentence);
  [[nodiscard]] QString text() const;

 private:
  void compute();

  PropellerGeometry geometry_;
  RunSet runs_;
  ChartLink link_;
  QDoubleSpinBox* speed_;
  QLabel* text_;
  ChartPane* pane_;
};

}  // namespace rotorbench
