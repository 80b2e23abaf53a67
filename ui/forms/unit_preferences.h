// In which unit people want to read a quantity. Fields that declare the same display unit switch
// together (all lengths declared in cm, but not the ones in inches); the choice is kept in the
// settings.
#pragma once

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>

#include "sim/core/schema.h"

class QSettings;

namespace rotorbench {

class UnitPreferences : public QObject {
  Q_OBJECT

 public:
  /// Choices are read from and written to `settings`, which may be null (nothing is remembered).
  explicit UnitPreferences(QSettings* settings, QObject* parent = nullptr);

  /// Unit symbol in which numbers of the field are shown and typed.
  [[nodiscard]] QString shownUnit(const schema::Field& field) const;
  /// Unit symbols the field can be shown in, the SI unit first.
  [[nodiscard]] static QStringList choices(const schema::Field& field);
  void setShownUnit(const schema::Field& field, const QString& unit);

 signals:
  void changed();

 private:
  QSettings* settings_;
  QHash<QString, QString> chosen_;  ///< by declared display unit
};

}  // namespace rotorbench
