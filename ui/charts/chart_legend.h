// The legend of a chart: a click on an entry hides or shows its curve. While cursors are set it is a table of
// read-outs: the value at A, at B, and the difference.
#pragma once

#include <QAbstractButton>
#include <QScrollArea>
#include <QStringList>
#include <vector>

#include "ui/charts/chart_theme.h"

namespace rotorbench {

struct LegendEntry {
  QString label;
  QString tip;
  CurveStyle style;
  bool hidden = false;
  QString channel;  ///< name to remove from the chart
  bool operator==(const LegendEntry&) const = default;
};

/// One entry: a sample of the line, the name, and the read-outs as table cells.
class LegendItem : public QAbstractButton {
  Q_OBJECT

 public:
  explicit LegendItem(QWidget* parent);
  void setEntry(const LegendEntry& entry);
  void setCells(const QStringList& cells, int cellWidth);
  [[nodiscard]] const LegendEntry& entry() const { return entry_; }
  [[nodiscard]] const QStringList& cells() const { return cells_; }
  QSize sizeHint() const override;

 signals:
  void menuAsked(QPoint globalPosition);
  void removeAsked();

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  LegendEntry entry_;
  QStringList cells_;
  int cellWidth_ = 0;
};

class ChartLegend : public QScrollArea {
  Q_OBJECT

 public:
  explicit ChartLegend(QWidget* parent = nullptr);

  void setEntries(const std::vector<LegendEntry>& entries);
  /// One list of cells per entry, and the heads of the columns; empty heads end the table.
  void setReadouts(const QStringList& heads, const std::vector<QStringList>& cells);
  /// The most height the legend may take below its plot; beyond it scrolls.
  void setMostHeight(int height);
  /// Beside the plot instead, as a column of this width; 0: below it.
  void setColumnWidth(int width);
  [[nodiscard]] const std::vector<LegendItem*>& items() const { return items_; }
  [[nodiscard]] const QStringList& heads() const { return heads_; }

 signals:
  void toggled(std::size_t entry);
  void removeAsked(const QString& channel);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void arrange();
  [[nodiscard]] int cellWidth() const;
  void paintHeads();
  void askMenu(LegendItem* item, QPoint globalPosition);

  QWidget* body_;
  std::vector<LegendItem*> items_;
  QStringList heads_;
  int mostHeight_ = 120;
  int columnWidth_ = 0;
  int widestCell_ = 0;  ///< grows while cursors are set, so that columns stay in place
};

}  // namespace rotorbench
