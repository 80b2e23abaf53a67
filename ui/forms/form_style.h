// The one look of the forms: spacing grid, colours derived from the palette (so that light and dark
// both work), and a frame that marks a widget without changing its size. Lengths are
// device-independent pixels.
#pragma once

#include <QColor>
#include <QPalette>
#include <QPointer>
#include <QWidget>

class QLabel;

namespace rotorbench::form_style {

constexpr int kGrid = 4;
constexpr int kMargin = 2 * kGrid;
constexpr int kUnitWidth = 56;
constexpr int kMarkerWidth = 20;
constexpr int kWidestForm = 620;

/// Beside what acts at once in a flight that goes on.
constexpr QChar kLiveMark(0x25CF);
QString liveMarkHtml(const QPalette& palette);

enum class Severity { None, Warning, Error };

/// Red or amber with enough contrast on the palette's window colour.
QColor severityColour(Severity severity, const QPalette& palette);
/// Text that steps back: between the text and the window colour.
QColor dimmed(const QPalette& palette);
void setDimmed(QWidget* label);
void setTextColour(QWidget* widget, const QColor& colour);
/// The widget's font scaled, optionally bold.
void setFontScale(QWidget* widget, double scale, bool bold = false);
/// Small round marks for trees and lists: a filled disc in `colour`.
QIcon discIcon(const QColor& colour);
QIcon severityIcon(Severity severity, const QPalette& palette);

/// A coloured frame drawn over `target`; transparent for the mouse, follows its size.
class Frame : public QWidget {
  Q_OBJECT

 public:
  explicit Frame(QWidget* target);
  /// Moves the frame to another widget.
  void setTarget(QWidget* target);
  void setSeverity(Severity severity);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Severity severity_ = Severity::None;
};

/// Keeps the wheel from changing a combo box or spin box that has no focus; the form scrolls
/// instead.
class WheelGuard : public QObject {
  Q_OBJECT

 public:
  /// Guards `widget` for its lifetime and takes it out of wheel focus.
  static void install(QWidget* widget);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using QObject::QObject;
};

}  // namespace rotorbench::form_style
