// Where the cells of a table of text begin and end, in one line of choices.
#pragma once

#include <QWidget>

#include "sim/logs/import_settings.h"

class QComboBox;
class QLineEdit;
class QSpinBox;

namespace rotorbench {

class LayoutRow : public QWidget {
  Q_OBJECT

 public:
  explicit LayoutRow(QWidget* parent = nullptr);

  /// Shows a layout; says nothing.
  void show(const CsvLayout& layout);
  [[nodiscard]] CsvLayout layout() const;

 signals:
  /// A person chose something.
  void edited();

 private:
  QComboBox* separator_;
  QComboBox* mark_;
  QLineEdit* comment_;
  QSpinBox* header_;
  QSpinBox* skipped_;
};

}  // namespace rotorbench
