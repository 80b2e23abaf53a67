#include "ui/forms/quantity_edit.h"

#include <QKeyEvent>
#include <QWheelEvent>

#include "ui/forms/digit_step.h"
#include "ui/forms/field_text.h"

namespace rotorbench {

namespace {

/// Long enough not to call "1e" or "-" wrong while the rest is being typed.
constexpr int kTypingPauseMs = 350;
constexpr int kWheelNotch = 120;

double asNumber(const schema::Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::get<double>(value);
}

/// Figures of equal width, so that columns of numbers line up.
QFont tabularFont(QFont font) {
  font.setStyleHint(QFont::SansSerif);
  font.setKerning(false);
  return font;
}

}  // namespace

QuantityEdit::QuantityEdit(const schema::Field& field, const QLocale& locale, QWidget* parent)
    : CommitEdit(parent), field_(field), locale_(locale), unit_(toQString(field.displayUnit)) {
  setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setFont(tabularFont(font()));
  setMaxLength(200);
  pause_.setSingleShot(true);
  pause_.setInterval(kTypingPauseMs);
  connect(this, &QLineEdit::textEdited, &pause_, qOverload<>(&QTimer::start));
  connect(&pause_, &QTimer::timeout, this, [this] { emit judged(reading().sentence); });
}

QString QuantityEdit::written(double si) const {
  if (field_.kind == schema::Kind::Integer) return QString::number(static_cast<qint64>(si));
  return numberInUnit(si, unit_, locale_);
}

void QuantityEdit::setValue(double si) {
  // A number being stepped keeps its digits ("1.50") while the cursor stands in them.
  if (showsValue_ && value_ == si && !hasUncommittedText()) return;
  pause_.stop();
  value_ = si;
  showsValue_ = true;
  showText(written(si));
}

void QuantityEdit::setShownUnit(const QString& unit) {
  if (unit == unit_) return;
  const bool shows = showsValue_ && !hasUncommittedText();
  unit_ = unit;
  if (shows) showText(written(value_));
}

void QuantityEdit::setInvalidText(const QString& text) {
  pause_.stop();
  showsValue_ = false;
  showText(text);
}

bool QuantityEdit::hasUncommittedText() const {
  return !showsValue_ || CommitEdit::hasUncommittedText();
}

TypedValue QuantityEdit::reading() const {
  return readTyped(field_, text(), unit_, locale_);
}

void QuantityEdit::commit() {
  pause_.stop();
  if (!hasUncommittedText()) return;
  const TypedValue read = reading();
  if (!read.value) {
    const QString typed = text();
    setInvalidText(typed);
    emit rejected(typed, read.sentence);
    return;
  }
  showsValue_ = true;
  value_ = asNumber(*read.value);
  showText(written(value_));
  emit judged({});
  emit committed(*read.value, false);
}

void QuantityEdit::revert() {
  pause_.stop();
  emit judged({});
  CommitEdit::revert();
}

void QuantityEdit::step(int steps, int placesUp) {
  const TypedValue before = reading();
  if (!before.value) return;
  QString base = text().trimmed();
  int cursor = cursorPosition();
  auto stepped = stepDigit(base, cursor, steps, placesUp, locale_.decimalPoint().front());
  if (!stepped) {  // an expression or a unit: step what it amounts to
    base = written(asNumber(*before.value));
    stepped = stepDigit(base, static_cast<int>(base.size()), steps, placesUp,
                        locale_.decimalPoint().front());
  }
  if (!stepped) return;
  const QString typed = text();
  setText(stepped->text);
  const TypedValue after = reading();
  if (!after.value) {  // the range ends here
    setText(typed);
    setCursorPosition(cursor);
    return;
  }
  value_ = asNumber(*after.value);
  showsValue_ = true;
  showText(stepped->text);
  setCursorPosition(stepped->cursor);
  emit judged({});
  emit committed(*after.value, true);
}

void QuantityEdit::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return step(1, 0);
    case Qt::Key_Down:
      return step(-1, 0);
    case Qt::Key_PageUp:
      return step(1, 1);
    case Qt::Key_PageDown:
      return step(-1, 1);
    default:
      return CommitEdit::keyPressEvent(event);
  }
}

void QuantityEdit::wheelEvent(QWheelEvent* event) {
  if (!hasFocus() || isReadOnly()) {
    event->ignore();
    return;
  }
  wheelRest_ += event->angleDelta().y();
  const int notches = wheelRest_ / kWheelNotch;
  wheelRest_ -= notches * kWheelNotch;
  if (notches != 0) step(notches, 0);
  event->accept();
}

void QuantityEdit::focusOutEvent(QFocusEvent* event) {
  CommitEdit::focusOutEvent(event);
  // A stepped "1.50" becomes "1.5" again.
  if (event->reason() != Qt::PopupFocusReason && showsValue_) showText(written(value_));
}

QSize QuantityEdit::sizeHint() const {
  QSize hint = QLineEdit::sizeHint();
  hint.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0.00000000000")));
  return hint;
}

QSize QuantityEdit::minimumSizeHint() const {
  QSize hint = QLineEdit::minimumSizeHint();
  hint.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0.0000")) + 12);
  return hint;
}

}  // namespace rotorbench
