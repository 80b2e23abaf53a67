#include "ui/measurement/propeller_row.h"

#include <QComboBox>
#include <QDate>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

#include "sim/core/constants.h"
#include "sim/core/error.h"
#include "sim/fitting/coefficient_points.h"
#include "sim/library/component.h"
#include "sim/logs/propeller_blocks.h"
#include "sim/logs/speed_curves.h"
#include "ui/forms/field_text.h"
#include "ui/forms/plain_locale.h"
#include "ui/forms/quantity_edit.h"
#include "ui/library/save_component.h"

namespace rotorbench {

namespace {

const schema::Field& diameterField() {
  return *schema::typeOf<MeasuredPropeller>().field("diameter");
}

QLabel* labelFor(QWidget* widget, const QString& text) {
  auto* label = new QLabel(text);
  label->setBuddy(widget);
  return label;
}

}  // namespace

PropellerRow::PropellerRow(QWidget* parent)
    : QWidget(parent),
      speeds_(new QComboBox),
      component_(new QWidget),
      diameter_(new QuantityEdit(diameterField(), plainLocale())) {
  speeds_->setObjectName("importSpeed");
  speeds_->setAccessibleName(tr("Speed whose curve is imported"));
  diameter_->setObjectName("importDiameter");
  diameter_->setAccessibleName(tr("Diameter of the propeller"));
  auto* save = new QPushButton(QIcon::fromTheme("document-save"), tr("Sa&ve as propeller…"));
  save->setObjectName("importSavePropeller");
  save->setAutoDefault(false);
  save->setToolTip(tr("All speeds, as a component that can be flown with."));
  auto* parts = new QHBoxLayout(component_);
  parts->setContentsMargins(0, 0, 0, 0);
  parts->addWidget(labelFor(diameter_, tr("D&iameter")));
  parts->addWidget(diameter_);
  parts->addWidget(new QLabel(prettyUnit(toQString(diameterField().displayUnit))));
  parts->addWidget(save);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(speeds_);
  row->addWidget(component_);
  row->addStretch(1);
  connect(speeds_, &QComboBox::currentIndexChanged, this, &PropellerRow::speedChosen);
  connect(save, &QPushButton::clicked, this, &PropellerRow::save);
}

void PropellerRow::setNames(const QStringList& names, const QString& file) {
  file_ = file;
  name_.clear();
  diameter_->setInvalidText({});
  for (const QString& name : names) {
    const auto diameter = diameterInName(name.toStdString());
    if (!diameter) continue;
    name_ = name.simplified().section(' ', 0, 0);
    diameter_->setValue(*diameter);
    return;
  }
}

void PropellerRow::show(const MeasuredTable& table) {
  table_ = table;
  const QSignalBlocker quiet(speeds_);
  const QString before = speeds_->currentText();
  speeds_->clear();
  speeds_->addItem(tr("Curves of all speeds"));
  for (const double speed : curveSpeeds(table)) {
    speeds_->addItem(tr("Curve of %1 rpm").arg(std::round(speed / kRpm)), speed);
  }
  speeds_->setCurrentIndex(std::max(speeds_->findText(before), 0));
  speeds_->setVisible(speeds_->count() > 1);
  component_->setVisible(table.rows() > 0 && missingForCoefficients(table).empty());
  setVisible(!speeds_->isHidden() || !component_->isHidden());
}

MeasuredTable PropellerRow::chosen(const MeasuredTable& table) const {
  const QVariant speed = speeds_->currentData();
  return speed.isValid() ? curveAtSpeed(table, speed.toDouble()) : table;
}

void PropellerRow::save() {
  diameter_->commit();
  const TypedValue diameter = diameter_->reading();
  if (!diameter.value) {
    emit said(tr("Give the diameter of the propeller: %1").arg(diameter.sentence));
    return;
  }
  try {
    MeasuredPropeller propeller = propellerOfTable(table_, std::get<double>(*diameter.value));
    const QString summary =
        tr("Propeller of a table, %n point(s)", nullptr, static_cast<int>(propeller.points.size()));
    const QString source =
        tr("Imported from %1 on %2")
            .arg(QFileInfo(file_).fileName(), QDate::currentDate().toString(Qt::ISODate));
    const ComponentInfo info{name_.toStdString(), summary.toStdString(), source.toStdString(), {}};
    askToSaveComponent(makeComponent(info, std::move(propeller)), window(),
                       [this](const QString& sentence) { emit said(sentence); });
  } catch (const InputError& error) {
    emit said(problemSentence(error.problems().front()));
  }
}

}  // namespace rotorbench
