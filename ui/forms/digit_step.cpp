#include "ui/forms/digit_step.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace rotorbench {

namespace {

/// Beyond this many digits the whole-number arithmetic below would no longer be exact.
constexpr int kMostDigits = 15;

struct Written {
  bool negative = false;
  QString whole, fraction, exponent;
};

std::optional<Written> take(const QString& text) {
  static const QRegularExpression kPlain(
      QStringLiteral("^([+-]?)(\\d*)(?:[.,](\\d*))?([eE][+-]?\\d+)?$"));
  const auto match = kPlain.match(text);
  if (!match.hasMatch()) return std::nullopt;
  Written w{match.captured(1) == QLatin1String("-"), match.captured(2), match.captured(3),
            match.captured(4)};
  const auto digits = w.whole.size() + w.fraction.size();
  if (digits == 0 || digits > kMostDigits) return std::nullopt;
  return w;
}

}  // namespace

std::optional<SteppedText> stepDigit(const QString& text, int cursor, int steps, int placesUp,
                                     QChar decimalPoint) {
  auto written = take(text);
  if (!written) return std::nullopt;
  const int sign = text.startsWith(QLatin1Char('-')) || text.startsWith(QLatin1Char('+')) ? 1 : 0;
  const int wholeEnd = sign + static_cast<int>(written->whole.size());
  const int decimals = static_cast<int>(written->fraction.size());
  const int mantissaEnd = wholeEnd + (decimals > 0 ? 1 + decimals : 0);
  const int beside = std::clamp(cursor, sign + 1, std::max(sign + 1, mantissaEnd));
  // Place of the digit left of the cursor: 0 for ones, -1 for tenths. The separator itself counts
  // as ones.
  const int digit = beside <= wholeEnd ? wholeEnd - beside : std::min(0, -(beside - wholeEnd - 1));
  const int place = digit + placesUp;
  const int kept = std::max(decimals, -place);
  auto scaled = (written->whole + written->fraction + QString(kept - decimals, QLatin1Char('0')))
                    .toLongLong();
  if (written->negative) scaled = -scaled;
  const int power = place + kept;
  if (power > kMostDigits) return std::nullopt;
  scaled += steps * static_cast<qint64>(std::llround(std::pow(10.0, power)));

  QString digits = QString::number(std::abs(scaled)).rightJustified(kept + 1, QLatin1Char('0'));
  if (kept > 0) digits.insert(digits.size() - kept, decimalPoint);
  const QString result = (scaled < 0 ? QStringLiteral("-") : QString()) + digits;
  // The digit that was stepped, counted from the end of the mantissa.
  const int fromEnd = digit >= 0 ? digit + (kept > 0 ? kept + 1 : 0) : kept + digit;
  const int at = std::max(static_cast<int>(result.size()) - fromEnd, scaled < 0 ? 2 : 1);
  return SteppedText{result + written->exponent, at};
}

}  // namespace rotorbench
