#include "ui/forms/form_style.h"

#include <QEvent>
#include <QIcon>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace rotorbench::form_style {

namespace {

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Window).lightness() < 128;
}

QColor mix(const QColor& a, const QColor& b, double share) {
  return QColor::fromRgbF(static_cast<float>(a.redF() * share + b.redF() * (1 - share)),
                          static_cast<float>(a.greenF() * share + b.greenF() * (1 - share)),
                          static_cast<float>(a.blueF() * share + b.blueF() * (1 - share)));
}

QPixmap markPixmap(const QColor& colour, const QString& sign) {
  constexpr int kSize = 32;  // drawn at twice its shown size, for dense screens
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(colour);
  painter.setPen(Qt::NoPen);
  if (sign.isEmpty()) {
    painter.drawEllipse(QRectF(10, 10, 12, 12));
    return pixmap;
  }
  painter.drawEllipse(QRectF(3, 3, 26, 26));
  painter.setPen(colour.lightness() > 140 ? Qt::black : Qt::white);
  QFont font;
  font.setPixelSize(22);
  font.setBold(true);
  painter.setFont(font);
  painter.drawText(pixmap.rect(), Qt::AlignCenter, sign);
  return pixmap;
}

}  // namespace

QColor severityColour(Severity severity, const QPalette& palette) {
  const bool dark = isDark(palette);
  switch (severity) {
    case Severity::Error:
      return dark ? QColor(0xff, 0x8a, 0x80) : QColor(0xb3, 0x1b, 0x1b);
    case Severity::Warning:
      return dark ? QColor(0xff, 0xc1, 0x4d) : QColor(0x8a, 0x53, 0x00);
    case Severity::None:
      break;
  }
  return palette.color(QPalette::WindowText);
}

QString liveMarkHtml(const QPalette& palette) {
  return QStringLiteral("&nbsp;<span style=\"color:%1\">%2</span>")
      .arg(palette.color(QPalette::Highlight).name(), kLiveMark);
}

QColor dimmed(const QPalette& palette) {
  return mix(palette.color(QPalette::WindowText), palette.color(QPalette::Window), 0.62);
}

void setTextColour(QWidget* widget, const QColor& colour) {
  QPalette palette = widget->palette();
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Active, role, colour);
    palette.setColor(QPalette::Inactive, role, colour);
  }
  widget->setPalette(palette);
}

void setDimmed(QWidget* label) {
  setTextColour(
      label, dimmed(label->parentWidget() ? label->parentWidget()->palette() : label->palette()));
}

void setFontScale(QWidget* widget, double scale, bool bold) {
  QFont font = widget->font();
  if (font.pointSizeF() > 0) {
    font.setPointSizeF(font.pointSizeF() * scale);
  } else {
    font.setPixelSize(static_cast<int>(font.pixelSize() * scale));
  }
  font.setBold(bold);
  widget->setFont(font);
}

QIcon discIcon(const QColor& colour) {
  return QIcon(markPixmap(colour, {}));
}

QIcon severityIcon(Severity severity, const QPalette& palette) {
  if (severity == Severity::None) return {};
  return QIcon(markPixmap(severityColour(severity, palette), QStringLiteral("!")));
}

Frame::Frame(QWidget* target) : QWidget(target) {
  setObjectName(QStringLiteral("frame"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  target->installEventFilter(this);
  hide();
}

void Frame::setTarget(QWidget* target) {
  if (target == parentWidget()) return;
  parentWidget()->removeEventFilter(this);
  setParent(target);
  target->installEventFilter(this);
}

void Frame::setSeverity(Severity severity) {
  severity_ = severity;
  setGeometry(parentWidget()->rect());
  setVisible(severity != Severity::None);
  raise();
  update();
}

void Frame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(severityColour(severity_, palette()), 1.6));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.8, 0.8, -0.8, -0.8), 2, 2);
}

bool Frame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

void WheelGuard::install(QWidget* widget) {
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(new WheelGuard(widget));
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel) return QObject::eventFilter(watched, event);
  if (static_cast<QWidget*>(watched)->hasFocus()) return QObject::eventFilter(watched, event);
  event->ignore();
  return true;
}

}  // namespace rotorbench::form_style
