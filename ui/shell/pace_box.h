// The speed of runs: slower, real time, faster or as fast as possible. Remembered in the settings.
#pragma once

#include <QComboBox>

#include "sim/run/run_worker.h"

namespace rotorbench {

class PaceBox : public QComboBox {
  Q_OBJECT

 public:
  explicit PaceBox(QWidget* parent = nullptr);
  [[nodiscard]] Pace pace() const;
  void setPace(Pace pace);

 signals:
  void paceChanged(rotorbench::Pace pace);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace rotorbench
