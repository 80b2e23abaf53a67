// The parameters of a described struct as an HTML table for the help pages: made from the schema,
// so that help and forms cannot disagree.
#pragma once

#include <QLocale>
#include <QString>

#include "sim/core/schema.h"

namespace rotorbench {

/// Symbol, label, unit, range, default, help and source of every field, in display units. Nested
/// groups follow with their own heading rows; alternatives and lists name what they hold.
QString parameterTableHtml(const schema::Type& type, const QLocale& locale = QLocale::c());

}  // namespace rotorbench
