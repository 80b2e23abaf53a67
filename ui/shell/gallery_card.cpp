#include "ui/shell/gallery_card.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>

namespace rotorbench {

namespace {

constexpr int kMargin = 10;
constexpr int kSummaryLines = 3;
constexpr qreal kRounding = 6;

/// Wrapped text, at most kSummaryLines lines, the last one elided.
void drawWrapped(QPainter& painter, const QRectF& area, const QString& text) {
  QTextLayout layout(text, painter.font());
  layout.beginLayout();
  qreal y = area.top();
  for (int line = 0; line < kSummaryLines; ++line) {
    QTextLine piece = layout.createLine();
    if (!piece.isValid()) break;
    piece.setLineWidth(area.width());
    const QString rest = text.mid(piece.textStart());
    const bool last = line == kSummaryLines - 1;
    const QString shown = last ? painter.fontMetrics().elidedText(rest, Qt::ElideRight,
                                                                  static_cast<int>(area.width()))
                               : text.mid(piece.textStart(), piece.textLength());
    painter.drawText(QPointF(area.left(), y + painter.fontMetrics().ascent()), shown);
    y += painter.fontMetrics().lineSpacing();
  }
  layout.endLayout();
}

}  // namespace

GalleryCard::GalleryCard(const QString& title, const QString& summary, QWidget* parent)
    : QAbstractButton(parent), summary_(summary) {
  setText(title);
  setAccessibleName(title);
  setAccessibleDescription(summary);
  setToolTip(summary);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
}

void GalleryCard::setPicture(const QImage& picture) {
  picture_ = picture;
  update();
}

QSize GalleryCard::sizeHint() const {
  const int text = fontMetrics().lineSpacing() * (kSummaryLines + 1);
  return {kPictureSize.width(), kPictureSize.height() + text + 3 * kMargin};
}

void GalleryCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  QPainterPath shape;
  shape.addRoundedRect(frame, kRounding, kRounding);
  painter.fillPath(shape, palette().color(QPalette::Base));
  painter.save();
  painter.setClipPath(shape);
  if (!picture_.isNull()) painter.drawImage(QPointF(0, 0), picture_);
  painter.restore();

  const QRectF text = frame.adjusted(kMargin, kPictureSize.height() + kMargin, -kMargin, -kMargin);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(text, Qt::AlignLeft | Qt::AlignTop,
                   painter.fontMetrics().elidedText(QAbstractButton::text(), Qt::ElideRight,
                                                    static_cast<int>(text.width())));
  painter.setFont(font());
  QColor dim = palette().color(QPalette::Text);
  dim.setAlphaF(0.7F);
  painter.setPen(dim);
  drawWrapped(painter, text.adjusted(0, fontMetrics().lineSpacing() + 3, 0, 0), summary_);

  const bool active = hasFocus() || underMouse();
  QColor border = palette().color(active ? QPalette::Highlight : QPalette::Mid);
  painter.setPen(QPen(border, hasFocus() ? 2 : 1));
  painter.drawPath(shape);
}

void GalleryCard::enterEvent(QEnterEvent* event) {
  QAbstractButton::enterEvent(event);
  update();
}

void GalleryCard::leaveEvent(QEvent* event) {
  QAbstractButton::leaveEvent(event);
  update();
}

}  // namespace rotorbench
