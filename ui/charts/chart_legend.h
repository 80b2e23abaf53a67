// The legend of a chart: a click on an entry hides or shows its curve. While cursors are set it is
// a table of read-outs: the value at A, at B, and the difference. Where it is narrow names come
// before read-outs: these move below the name, and the last columns go.
#pragma once

#include <QScrollArea>
#include <QStringList>
#include <vector>

#include "ui/charts/legend_item.h"

namespace rotorbench {

class ChartLegend : public QScrollArea {
  Q_OBJECT

 public:
  explicit ChartLegend(QWidget* parent = nullptr);

  void setEntries(const std::vector<LegendEntry>& entries);
  /// One list of cells per entry, and the heads of the columns; empty heads end the table.
  void setReadouts(const QStringList& heads, const std::vector<QStringList>& cells);
  /// The most height the legend may take below its plot; beyond it scrolls.
  void setMostHeight(int height);
  /// Beside the plot instead, as a column as wide as its names and read-outs need, but no wider
  /// than this; 0: below it.
  void setMostWidth(int width);
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
  void fixSize(int content, int rowHeight);
  [[nodiscard]] int columnWidth(int rowHeight) const;
  [[nodiscard]] LegendPlace placeOf(const LegendItem& item, int room) const;
  /// What all entries have in common where this many px are there for each.
  void choosePlaces(int room);
  void paintHeads();
  void askMenu(LegendItem* item, QPoint globalPosition);

  QWidget* body_;
  std::vector<LegendItem*> items_;
  QStringList heads_;
  int mostHeight_ = 120;
  int mostWidth_ = 0;
  bool shortNames_ = false;
  LegendPlace cells_;   ///< of all entries, without lines
  int widestCell_ = 0;  ///< grows while cursors are set, so that columns stay in place
};

}  // namespace rotorbench
