#include "ui/runs/run_delegate.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/runs/run_list.h"

namespace rotorbench {

namespace {

constexpr int kSpacing = 6;
constexpr int kSwatch = 10;

const QStyle& styleOf(const QStyleOptionViewItem& option) {
  return option.widget != nullptr ? *option.widget->style() : *QApplication::style();
}

QRect nameRect(const QStyleOptionViewItem& option) {
  const QRect check = RunDelegate::checkRect(option);
  const int left = check.right() + 2 * kSpacing + kSwatch;
  return {left, option.rect.top() + kSpacing / 2, option.rect.right() - left - kSpacing / 2,
          option.fontMetrics.height()};
}

}  // namespace

QRect RunDelegate::checkRect(const QStyleOptionViewItem& option) {
  const QStyle& style = styleOf(option);
  const int width = style.pixelMetric(QStyle::PM_IndicatorWidth, &option, option.widget);
  const int height = style.pixelMetric(QStyle::PM_IndicatorHeight, &option, option.widget);
  const int top = option.rect.top() + kSpacing / 2 + (option.fontMetrics.height() - height) / 2;
  return {option.rect.left() + kSpacing, top, width, height};
}

void RunDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  const QStyle& style = styleOf(option);
  painter->save();
  style.drawPrimitive(QStyle::PE_PanelItemViewItem, &option, painter, option.widget);

  QStyleOptionButton box;
  box.rect = checkRect(option);
  box.palette = option.palette;
  box.state = QStyle::State_Enabled;
  box.state |=
      index.data(Qt::CheckStateRole).toInt() == Qt::Checked ? QStyle::State_On : QStyle::State_Off;
  style.drawPrimitive(QStyle::PE_IndicatorCheckBox, &box, painter, option.widget);

  const QRect swatch(box.rect.right() + kSpacing, box.rect.center().y() - kSwatch / 2 + 1, kSwatch,
                     kSwatch);
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  // The ring keeps a blue swatch apart from a blue selection.
  if (selected)
    painter->fillRect(swatch.adjusted(-2, -2, 2, 2), option.palette.color(QPalette::Base));
  painter->fillRect(swatch, index.data(RunList::ColorRole).value<QColor>());
  QColor text = option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text);
  painter->setPen(text);
  const QRect name = nameRect(option);
  painter->drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                    option.fontMetrics.elidedText(index.data(Qt::DisplayRole).toString(),
                                                  Qt::ElideRight, name.width()));
  text.setAlphaF(0.65F);
  painter->setPen(text);
  const QRect detail = name.translated(0, option.fontMetrics.lineSpacing());
  painter->drawText(detail, Qt::AlignLeft | Qt::AlignVCenter,
                    option.fontMetrics.elidedText(index.data(RunList::DetailRole).toString(),
                                                  Qt::ElideRight, detail.width()));
  painter->restore();
}

QSize RunDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return {160, 2 * option.fontMetrics.lineSpacing() + kSpacing};
}

void RunDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                       const QModelIndex&) const {
  editor->setGeometry(nameRect(option).adjusted(-3, -2, 0, 2));
}

bool RunDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                              const QStyleOptionViewItem& option, const QModelIndex& index) {
  bool toggle = false;
  if (event->type() == QEvent::MouseButtonRelease) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    toggle = mouse->button() == Qt::LeftButton &&
             checkRect(option).adjusted(-3, -3, 3, 3).contains(mouse->position().toPoint());
  } else if (event->type() == QEvent::KeyPress) {
    toggle = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space;
  }
  if (!toggle) return false;
  const bool shown = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
  return model->setData(index, shown ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

}  // namespace rotorbench
