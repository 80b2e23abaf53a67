// What a person's text means as a value of a field: shared by line edits, table cells and pasted
// tables.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

#include "sim/core/schema.h"

namespace rotorbench {

struct TypedValue {
  std::optional<schema::Value> value;  ///< of the field's kind, SI; one component for Vector
  QString sentence;                    ///< why there is none, ready to be shown
};

/// Reads `text` for a leaf field; numbers without a unit are in `shownUnit`. Checks the range.
TypedValue readTyped(const schema::Field& field, const QString& text, const QString& shownUnit,
                     const QLocale& locale);

}  // namespace rotorbench
