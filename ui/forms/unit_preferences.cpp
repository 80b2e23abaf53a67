#include "ui/forms/unit_preferences.h"

#include <QSettings>

#include "sim/core/units.h"

namespace rotorbench {

namespace {

constexpr auto kSettingsGroup = "units";

/// Settings keys may not hold the slashes and stars that unit symbols are full of.
QString settingsKey(const QString& unit) {
  return QString::fromLatin1(unit.toUtf8().toPercentEncoding());
}

}  // namespace

UnitPreferences::UnitPreferences(QSettings* settings, QObject* parent)
    : QObject(parent), settings_(settings) {
  if (settings_ == nullptr) return;
  settings_->beginGroup(kSettingsGroup);
  for (const QString& key : settings_->childKeys()) {
    chosen_[QString::fromUtf8(QByteArray::fromPercentEncoding(key.toLatin1()))] =
        settings_->value(key).toString();
  }
  settings_->endGroup();
}

QString UnitPreferences::shownUnit(const schema::Field& field) const {
  const QString declared = QString::fromStdString(field.displayUnit);
  const QString chosen = chosen_.value(declared);
  return !chosen.isEmpty() && choices(field).contains(chosen) ? chosen : declared;
}

QStringList UnitPreferences::choices(const schema::Field& field) {
  // A plain number is not asked for in per cent unless it was declared so.
  if (field.displayUnit == "1") return {QStringLiteral("1")};
  QStringList symbols;
  for (const Unit* unit : unitsLike(field.unit)) {
    symbols += QString::fromUtf8(unit->symbol.data(), static_cast<qsizetype>(unit->symbol.size()));
  }
  return symbols;
}

void UnitPreferences::setShownUnit(const schema::Field& field, const QString& unit) {
  if (unit == shownUnit(field) || !choices(field).contains(unit)) return;
  const QString declared = QString::fromStdString(field.displayUnit);
  chosen_[declared] = unit;
  if (settings_ != nullptr) {
    settings_->beginGroup(kSettingsGroup);
    settings_->setValue(settingsKey(declared), unit);
    settings_->endGroup();
  }
  emit changed();
}

}  // namespace rotorbench
