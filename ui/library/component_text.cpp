#include "ui/library/component_text.h"

#include <QTreeWidget>

#include "sim/core/schema_tree.h"
#include "sim/core/units.h"
#include "ui/forms/field_text.h"

namespace rotorbench {

using schema::Field;
using schema::Kind;

namespace {

QString shortNumber(const Field& field, double si, const UnitPreferences& units,
                    const QLocale& locale) {
  const QString unit = units.shownUnit(field);
  const double shown = fromSi(si, unitFactor(field.unit, unit.toStdString()));
  constexpr int kDigits = 4, kNoExponentBelow = 10;
  const double rounded = QString::number(shown, 'g', kDigits).toDouble();
  QLocale plain = locale;
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  return withUnit(plain.toString(rounded, 'g', kNoExponentBelow), unit);
}

/// Empty where there is nothing to say: a switch that is off.
QString figureText(const Field& field, const schema::Value& value, const UnitPreferences& units,
                   const QLocale& locale) {
  if (const auto* on = std::get_if<bool>(&value)) {
    return *on ? toQString(field.label).toLower() : QString();
  }
  if (const auto* text = std::get_if<std::string>(&value)) return toQString(*text);
  const auto* number = std::get_if<double>(&value);
  const QString shown = number != nullptr ? shortNumber(field, *number, units, locale)
                                          : valueText(field, value, units.shownUnit(field), locale);
  const QString symbol = toQString(field.symbol).remove(QLatin1Char('_'));
  return symbol.isEmpty() ? shown : symbol + QLatin1Char(' ') + shown;
}

void addFields(QTreeWidgetItem* parent, schema::ConstRef object, const UnitPreferences& units,
               const QLocale& locale) {
  for (const Field& field : object.type->fields) {
    const QString label = toQString(field.label);
    QString value;
    if (field.isLeaf()) {
      value = valueText(field, field.read(object.object), units.shownUnit(field), locale);
    } else if (field.kind == Kind::List) {
      const auto count = field.count(object.object);
      value = count == 1 ? QTreeWidget::tr("1 row") : QTreeWidget::tr("%1 rows").arg(count);
    } else if (field.kind == Kind::Variant) {
      value = toQString(field.options[field.chosen(object.object)].label);
    }
    auto* item = new QTreeWidgetItem(parent, {label, value});
    item->setToolTip(0, toQString(field.help));
    item->setToolTip(1, value);
    if (field.isLeaf() || field.kind == Kind::List) continue;
    addFields(item, {&field.childType(object.object, 0), field.constChild(object.object, 0)}, units,
              locale);
  }
}

}  // namespace

QString keyFiguresText(const Component& component, const UnitPreferences& units,
                       const QLocale& locale) {
  const ComponentKind* kind = kindOf(*component.type);
  QStringList figures;
  for (const std::string& path : kind->keyFigures) {
    try {
      const auto at = schema::locate({component.type, component.value.get()}, path);
      const QString text = figureText(*at.field, at.field->read(at.owner), units, locale);
      if (!text.isEmpty()) figures << text;
    } catch (const InputError&) {
      continue;  // of an alternative that is not chosen
    }
  }
  // A comma may be the decimal separator.
  return figures.join(locale.decimalPoint() == QLatin1String(",") ? QStringLiteral("; ")
                                                                  : QStringLiteral(", "));
}

void fillParameterTree(QTreeWidget& tree, schema::ConstRef object, const UnitPreferences& units,
                       const QLocale& locale) {
  tree.clear();
  addFields(tree.invisibleRootItem(), object, units, locale);
  bool groups = false;
  for (int i = 0; i < tree.topLevelItemCount(); ++i) {
    groups = groups || tree.topLevelItem(i)->childCount() > 0;
  }
  tree.setRootIsDecorated(groups);
  tree.expandAll();
  tree.resizeColumnToContents(1);
}

}  // namespace rotorbench
