// The first rows of a table of measurements below two rows of choices: what each column is, and its unit.
#pragma once

#include <QTableWidget>

#include "sim/measurement/import_settings.h"

class QComboBox;

namespace rotorbench {

class MappingTable : public QTableWidget {
  Q_OBJECT

 public:
  static constexpr int kQuantityRow = 0, kUnitRow = 1, kFirstDataRow = 2;

  explicit MappingTable(QWidget* parent = nullptr);

  /// Shows a preview with these choices; columns without one are left out.
  void show(const CsvPreview& preview, const std::vector<ColumnMapping>& columns);
  [[nodiscard]] const std::vector<ColumnMapping>& columns() const { return columns_; }

 signals:
  /// A person chose something.
  void mappingChanged();

 private:
  void addChoices(int column);
  void fillUnits(int column);
  void chooseQuantity(int column, const QString& key);
  QComboBox* addBox(int row, int column, const QString& objectName, const QString& accessibleName);

  std::vector<ColumnMapping> columns_;
};

}  // namespace rotorbench
