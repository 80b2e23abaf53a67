#include "ui/forms/unit_button.h"

#include <QActionGroup>
#include <QEvent>
#include <QMenu>

#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

QMenu* makeUnitMenu(const FormContext& context, const schema::Field& field, QWidget* parent) {
  const QStringList choices = UnitPreferences::choices(field);
  if (choices.size() < 2) return nullptr;
  auto* menu = new QMenu(parent);
  menu->setObjectName(QStringLiteral("unitMenu"));
  auto* group = new QActionGroup(menu);
  UnitPreferences* units = context.units;
  for (const QString& symbol : choices) {
    const QString pretty = prettyUnit(symbol);
    QAction* action = menu->addAction(pretty.isEmpty() ? QStringLiteral("1") : pretty);
    action->setData(symbol);
    action->setCheckable(true);
    action->setChecked(symbol == units->shownUnit(field));
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, units,
                     [units, &field, symbol] { units->setShownUnit(field, symbol); });
  }
  return menu;
}

UnitButton::UnitButton(const FormContext& context, const schema::Field& field, QWidget* parent)
    : QToolButton(parent), context_(context), field_(field) {
  setAutoRaise(true);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setFixedWidth(form_style::kUnitWidth);
  setObjectName(QStringLiteral("unit"));
  if (UnitPreferences::choices(field).size() < 2) {
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents);
  } else {
    setFocusPolicy(Qt::TabFocus);
    setToolTip(tr("Click to choose another unit"));
    connect(this, &QToolButton::clicked, this, &UnitButton::showMenu);
  }
  form_style::setDimmed(this);
  refresh();
}

void UnitButton::refresh() {
  const QString unit = prettyUnit(context_.units->shownUnit(field_));
  setText(unit);
  setAccessibleName(tr("Unit of %1: %2").arg(toQString(field_.label), unit));
}

void UnitButton::showMenu() {
  QMenu* menu = makeUnitMenu(context_, field_, this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->popup(mapToGlobal(rect().bottomLeft()));
}

void UnitButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::StyleChange) form_style::setDimmed(this);
  QToolButton::changeEvent(event);
}

}  // namespace rotorbench
