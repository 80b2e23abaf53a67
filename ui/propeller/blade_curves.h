// Chord and twist of a blade over its radius, drawn with a handle at every station that can be
// dragged up and down. Knows no document: it shows the stations it is given and says what a person
// wants changed. Radii and chords are fractions of the tip radius; angles in rad, shown in degrees.
//
// Mouse: drag a handle; double click adds a station there. Keys: left and right choose a station,
// up and down change it (with Shift ten times as much), Space goes from chord to twist, Insert adds
// a station after it, Delete removes it.
#pragma once

#include <QWidget>
#include <vector>

#include "sim/propulsion/rotor/blade.h"
#include "ui/charts/plot_painter.h"

namespace rotorbench {

class BladeCurves : public QWidget {
  Q_OBJECT

 public:
  enum class Quantity { Chord, Twist };

  explicit BladeCurves(QWidget* parent = nullptr);

  void setStations(std::vector<BladeStation> stations);
  [[nodiscard]] int station() const { return station_; }
  [[nodiscard]] Quantity quantity() const { return quantity_; }
  /// Where the handle is on the widget.
  [[nodiscard]] QPointF handle(int station, Quantity quantity) const;

  [[nodiscard]] QSize minimumSizeHint() const override { return {260, 160}; }
  [[nodiscard]] QSize sizeHint() const override { return {560, 280}; }

 signals:
  /// The chosen station's new chord or twist.
  void chordChosen(int station, double chord);
  void twistChosen(int station, double twist);
  void insertAsked(double radius);
  void removeAsked(int station);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void layOut();
  void choose(int station, Quantity quantity);
  void offer(double value);
  [[nodiscard]] double valueOf(const BladeStation& station, Quantity quantity) const;
  [[nodiscard]] bool pick(QPointF place);
  void paintCurve(QPainter& painter, Quantity quantity, const ChartTheme& theme) const;

  std::vector<BladeStation> stations_;
  ChartFrame frame_;
  PlotLayout layout_;
  LabelWidths labelWidths_;
  int station_ = 0;
  Quantity quantity_ = Quantity::Chord;
  bool dragging_ = false;
};

}  // namespace rotorbench
