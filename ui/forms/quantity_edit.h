// A line in which a person types one number: with either decimal separator, as an expression
// ("3*2"), with or without a unit ("10 cm"). Arrow keys step the digit beside the cursor, Page keys
// the next higher one; the wheel does so only with the keyboard focus. Knows nothing of documents;
// values are SI.
#pragma once

#include <QLocale>
#include <QTimer>

#include "sim/core/schema.h"
#include "ui/forms/commit_edit.h"
#include "ui/forms/typed_value.h"

namespace rotorbench {

class QuantityEdit : public CommitEdit {
  Q_OBJECT

 public:
  /// `field` gives unit and range and must outlive the editor; Integer fields take whole numbers
  /// only.
  QuantityEdit(const schema::Field& field, const QLocale& locale, QWidget* parent = nullptr);

  /// Shows a value, discarding what was typed.
  void setValue(double si);
  /// Shows the value in another unit; invalid text stays as it is.
  void setShownUnit(const QString& unit);
  /// Puts back text that was typed before and is no value.
  void setInvalidText(const QString& text);

  /// What the present text means.
  [[nodiscard]] TypedValue reading() const;
  [[nodiscard]] bool hasUncommittedText() const override;
  /// Emits committed() or rejected() if the text was changed.
  void commit() override;
  void revert() override;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  /// `repeated` for steps that belong to one movement.
  void committed(const schema::Value& value, bool repeated);
  void rejected(const QString& text, const QString& sentence);
  /// While typing, after a short pause: the sentence of the present text, empty if it is fine.
  void judged(const QString& sentence);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void step(int steps, int placesUp);
  [[nodiscard]] QString written(double si) const;

  const schema::Field& field_;
  QLocale locale_;
  QString unit_;
  double value_ = 0;
  bool showsValue_ = false;  ///< false while invalid text stands in
  int wheelRest_ = 0;
  QTimer pause_;
};

}  // namespace rotorbench
