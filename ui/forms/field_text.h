// How fields, values and places of a document are written for people: numbers in the shown unit
// with the locale's decimal separator, symbols with subscripts, ranges, tool tips and "Vehicle ›
// Motor" instead of paths.
#pragma once

#include <QLocale>
#include <QString>

#include "sim/core/schema.h"

namespace rotorbench {

class UnitPreferences;

/// std::string (UTF-8) as QString.
QString toQString(std::string_view text);

/// An SI number in `unit` with the fewest digits that read back as the same number; no unit, no
/// grouping.
QString numberInUnit(double si, const QString& unit, const QLocale& locale);
/// prettyUnit() of sim/core/unit_text.h.
QString prettyUnit(const QString& symbol);
/// "0.12 Ω"; the number alone where there is no unit.
QString withUnit(const QString& number, const QString& unit);

/// A leaf value as a person reads it, in the unit `shownUnit`: "25 cm", "on", "Runge-Kutta 4".
QString valueText(const schema::Field& field, const schema::Value& value, const QString& shownUnit,
                  const QLocale& locale);
/// "above 0 and at most 10 cm"; empty if every number is allowed.
QString rangeText(const schema::Field& field, const QString& shownUnit, const QLocale& locale);

/// "k_T" as "<i>k</i><sub>T</sub>"; text is escaped.
QString symbolHtml(const QString& symbol);
/// Label with its symbol as rich text.
QString labelHtml(const schema::Field& field);
/// Help, range, default and source of a field as rich text.
QString toolTipHtml(const schema::Field& field, const QString& path, const QString& shownUnit,
                    const QString& defaultText, const QLocale& locale);

/// The name of vector component `index`: "x", or "1" if the schema gives none.
QString componentName(const schema::Field& field, std::size_t index);

/// What a list element is called: its own name or title if it has one, else "Label 3".
QString elementTitle(const schema::Field& list, const void* owner, std::size_t index);
/// "Vehicle › Motors › Motor 2 › Phase resistance"; the path itself where the document has no such
/// place.
QString placeText(schema::ConstRef root, const QString& path);

/// "is above the maximum" as "Is above the maximum."
QString asSentence(const QString& text);
/// Fault and remedy of a problem as sentences.
QString problemSentence(const Problem& problem);

}  // namespace rotorbench
