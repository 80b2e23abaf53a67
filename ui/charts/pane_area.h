// The room of a grid's panes: rows of them, divided by handles a person can move. Where the window
// is too low for all, each keeps a height in which it can be read and the area scrolls.
#pragma once

#include <QScrollArea>
#include <vector>

namespace rotorbench {

class ChartPane;

using PaneRows = std::vector<std::vector<ChartPane*>>;

/// One column for up to three panes, since time axes are wide; then as square as it gets.
PaneRows usualRows(const std::vector<ChartPane*>& panes);
/// How many columns that is.
std::size_t usualColumns(std::size_t panes);

class PaneArea : public QScrollArea {
  Q_OBJECT

 public:
  explicit PaneArea(QWidget* parent = nullptr);
  /// Takes the panes over, all rows equally high.
  void place(const PaneRows& rows);
  /// Shows one pane alone, or all of them (null).
  void showOnly(ChartPane* pane);
  /// Scrolls to the pane, once it has its place.
  void reveal(ChartPane* pane);

  QSize minimumSizeHint() const override;

 private:
  PaneRows rows_;
};

}  // namespace rotorbench
