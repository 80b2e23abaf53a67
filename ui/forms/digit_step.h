// Stepping a written decimal number by the digit beside the cursor, as on the dials of an
// instrument. Pure text in, text out: what the digits mean (unit, range) is the caller's business.
#pragma once

#include <QChar>
#include <QString>
#include <optional>

namespace rotorbench {

struct SteppedText {
  QString text;
  int cursor = 0;
};

/// Adds `steps` times the place value of the digit left of `cursor` (right of it at the start) to
/// the number `text`, written with `decimalPoint` and possibly an exponent. `placesUp` moves to a
/// higher digit (1: tenfold). The cursor stays beside the same digit. Empty if the text is not a
/// plain number.
std::optional<SteppedText> stepDigit(const QString& text, int cursor, int steps, int placesUp,
                                     QChar decimalPoint);

}  // namespace rotorbench
