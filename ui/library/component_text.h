// How components are written for people: the few figures that tell them apart, and the table of all
// their values.
#pragma once

#include <QLocale>
#include <QString>

#include "sim/library/component.h"
#include "ui/forms/unit_preferences.h"

class QTreeWidget;

namespace rotorbench {

/// "Kv 960 rpm/V, R 0.117 Ω, I₀ 0.45 A", four digits each.
QString keyFiguresText(const Component& component, const UnitPreferences& units,
                       const QLocale& locale);

/// Parameters and values in two columns, groups as branches, lists as the number of their rows.
void fillParameterTree(QTreeWidget& tree, schema::ConstRef object, const UnitPreferences& units,
                       const QLocale& locale);

}  // namespace rotorbench
