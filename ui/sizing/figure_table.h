// A sheet of figures as a table: groups with a title each, quantity, symbol, value in a sensible
// unit, and how it is worked out or what limits it; warnings below. Numbers in the reader's locale,
// in sentences too. Copies as text, or as CSV for programs.
#pragma once

#include <QWidget>

#include "sim/sizing/figure.h"

class QLabel;
class QTableWidget;

namespace rotorbench {

class FigureTable : public QWidget {
  Q_OBJECT

 public:
  /// What the last column holds; the other one is in the tool tip.
  enum class Detail { Formula, Note };

  explicit FigureTable(Detail detail, QWidget* parent = nullptr);

  void setSheet(const FigureSheet& sheet);
  /// In place of figures: why there are none.
  void setProblem(const QString& sentence);
  [[nodiscard]] const FigureSheet& sheet() const { return sheet_; }

 public slots:
  void copyText() const;
  void copyCsv() const;

 signals:
  /// Whether there is something to copy.
  void filled(bool figures);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum Column { kQuantity, kSymbol, kValue, kDetail, kColumns };

  void rebuild();
  void updateRows();
  void showWarnings();
  void fitLastColumn();
  [[nodiscard]] QString detailOf(const Figure& figure) const;
  [[nodiscard]] QString tipOf(const Figure& figure) const;

  Detail detail_;
  FigureSheet sheet_;
  QString problem_;
  QTableWidget* table_;
  QLabel* warnings_;
};

}  // namespace rotorbench
