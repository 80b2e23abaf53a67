// What can be done with the table of a propeller beside showing it: only the curve of one speed
// goes to the charts, and the whole of it becomes a component to fly with. Hidden for other tables.
#pragma once

#include <QWidget>

#include "sim/logs/measured_table.h"

class QComboBox;
class QPushButton;

namespace rotorbench {

class QuantityEdit;

class PropellerRow : public QWidget {
  Q_OBJECT

 public:
  explicit PropellerRow(QWidget* parent = nullptr);

  /// A file was opened. The first of these names, most trusted first, that tells a diameter
  /// ("10x4.7") gives it and the component's name.
  void setNames(const QStringList& names, const QString& file);
  /// Offers what can be done with this table; keeps a chosen speed it has.
  void show(const MeasuredTable& table);
  /// The rows of the chosen speed; all where none is chosen.
  [[nodiscard]] MeasuredTable chosen(const MeasuredTable& table) const;

 signals:
  /// A person chose another speed.
  void speedChosen();
  /// One sentence of what was done, or why not.
  void said(const QString& sentence);

 private:
  void save();

  MeasuredTable table_;
  QString name_, file_;
  QComboBox* speeds_;
  QWidget* component_;  ///< what makes a component
  QuantityEdit* diameter_;
};

}  // namespace rotorbench
