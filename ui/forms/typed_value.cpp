#include "ui/forms/typed_value.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "sim/core/units.h"
#include "ui/forms/field_text.h"

namespace rotorbench {

using schema::Kind;

namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("TypedValue", text);
}

TypedValue readNumber(const schema::Field& field, const QString& text, const QString& shownUnit,
                      const QLocale& locale) {
  const auto parsed =
      parseQuantity(text.trimmed().toStdString(), field.unit, shownUnit.toStdString());
  if (!parsed.value) return {std::nullopt, asSentence(toQString(parsed.error))};
  const bool whole = field.kind == Kind::Integer;
  if (whole && std::trunc(*parsed.value) != *parsed.value) {
    return {std::nullopt, tr("Must be a whole number.")};
  }
  if (!field.range.contains(*parsed.value)) {
    const QString range = rangeText(field, shownUnit, locale);
    return {std::nullopt,
            range.isEmpty() ? tr("The number is too large.") : tr("Must be %1.").arg(range)};
  }
  if (whole) return {schema::Value(static_cast<std::int64_t>(*parsed.value)), {}};
  return {schema::Value(*parsed.value), {}};
}

TypedValue readBoolean(const QString& text) {
  const QString word = text.trimmed().toLower();
  for (const char* yes : {"on", "true", "yes", "1"}) {
    if (word == QLatin1String(yes)) return {schema::Value(true), {}};
  }
  for (const char* no : {"off", "false", "no", "0"}) {
    if (word == QLatin1String(no)) return {schema::Value(false), {}};
  }
  return {std::nullopt, tr("Must be on or off.")};
}

TypedValue readOption(const schema::Field& field, const QString& text) {
  const QString word = text.trimmed();
  QStringList labels;
  for (const auto& option : field.options) {
    const QString label = toQString(option.label);
    if (word == toQString(option.key) || word.compare(label, Qt::CaseInsensitive) == 0) {
      return {schema::Value(option.key), {}};
    }
    labels += label;
  }
  return {std::nullopt, tr("Must be one of: %1.").arg(labels.join(QStringLiteral(", ")))};
}

}  // namespace

TypedValue readTyped(const schema::Field& field, const QString& text, const QString& shownUnit,
                     const QLocale& locale) {
  switch (field.kind) {
    case Kind::Boolean:
      return readBoolean(text);
    case Kind::Choice:
      return readOption(field, text);
    case Kind::Text:
      return {schema::Value(text.toStdString()), {}};
    default:
      return readNumber(field, text, shownUnit, locale);
  }
}

}  // namespace rotorbench
