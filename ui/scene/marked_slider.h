// A horizontal slider with ticks at chosen places of its groove.
#pragma once

#include <QSlider>
#include <vector>

namespace rotorbench {

class MarkedSlider : public QSlider {
  Q_OBJECT
 public:
  explicit MarkedSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}

  /// Parts, 0..1, of the groove.
  void setMarks(std::vector<double> places);
  [[nodiscard]] const std::vector<double>& marks() const { return marks_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<double> marks_;
};

}  // namespace rotorbench
