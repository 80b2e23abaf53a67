// One entry of a chart's legend: a sample of the line, the name, and the read-outs as table cells
// beside or below it. The name is always whole: in full where there is room, else by what tells the
// curve apart, on several lines if need be.
#pragma once

#include <QAbstractButton>
#include <QStringList>

#include "ui/charts/chart_theme.h"

namespace rotorbench {

struct LegendEntry {
  QString label;
  QString shortLabel;  ///< what tells it apart from the others of the chart
  QString tip;
  CurveStyle style;
  bool hidden = false;
  QString channel;  ///< name to remove from the chart
  bool operator==(const LegendEntry&) const = default;
};

/// Where the parts of an entry stand.
struct LegendPlace {
  QStringList lines;        ///< of the name
  int cells = 0;            ///< of the read-outs, as many as there is room for
  int cellWidth = 0;        ///< px
  bool cellsBelow = false;  ///< on a line of their own below the name
  bool operator==(const LegendPlace&) const = default;
};

class LegendItem : public QAbstractButton {
  Q_OBJECT

 public:
  explicit LegendItem(QWidget* parent);
  void setEntry(const LegendEntry& entry);
  /// The read-outs with the heads of their columns.
  void setCells(const QStringList& heads, const QStringList& cells);
  void setPlace(const LegendPlace& place);

  [[nodiscard]] const LegendEntry& entry() const { return entry_; }
  [[nodiscard]] const QStringList& cells() const { return cells_; }
  [[nodiscard]] const LegendPlace& place() const { return place_; }
  /// With the full name on one line.
  QSize sizeHint() const override;
  [[nodiscard]] int heightOf(const LegendPlace& place) const;
  /// The name in lines of at most `width` px with the sample before them; broken inside words where
  /// it must be.
  [[nodiscard]] QStringList wrapped(const QString& name, int width) const;
  /// Width of a name on one line, with the sample before it.
  [[nodiscard]] int widthOf(const QString& name) const;

 signals:
  void menuAsked(QPoint globalPosition);
  void removeAsked();

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void updateTip();
  void paintSample(QPainter& painter, const ChartTheme& theme) const;
  [[nodiscard]] int lineHeight() const;

  LegendEntry entry_;
  QStringList heads_, cells_;
  LegendPlace place_;
};

}  // namespace rotorbench
