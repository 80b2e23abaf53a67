// The first rows of a table of measurements below rows of choices: what each column is, its unit,
// by what its numbers are multiplied and what is added to them, and from where to where they then
// go.
#pragma once

#include <QTableWidget>
#include <map>

#include "sim/logs/import_settings.h"
#include "sim/logs/measured_table.h"

class QComboBox;

namespace rotorbench {

class MappingTable : public QTableWidget {
  Q_OBJECT

 public:
  enum Row { kQuantityRow, kUnitRow, kScaleRow, kOffsetRow, kRangeRow, kFirstDataRow };

  explicit MappingTable(QWidget* parent = nullptr);

  /// Shows a preview with these choices; columns without one are left out.
  void show(const CsvPreview& preview, const std::vector<ColumnMapping>& columns);
  [[nodiscard]] const std::vector<ColumnMapping>& columns() const { return columns_; }
  /// One sentence for each scale or offset that was typed and cannot be read.
  [[nodiscard]] QStringList faults() const;
  /// Least and largest value of each column in what would be imported.
  void showRanges(const MeasuredTable& table, ChannelGroup group);

 signals:
  /// A person chose something.
  void mappingChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addChoices(int column);
  void addNumber(int row, int column, double ColumnMapping::*member);
  void fillUnits(int column);
  void enableNumbers(int column);
  void chooseQuantity(int column, const QString& key);
  void place(QWidget* widget, int row, int column, const char* name, const QString& accessibleName);

  std::vector<ColumnMapping> columns_;
  std::map<std::pair<int, int>, QString> faults_;  ///< by column and row
};

}  // namespace rotorbench
