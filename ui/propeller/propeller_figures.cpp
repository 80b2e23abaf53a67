#include "ui/propeller/propeller_figures.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <array>

#include "sim/core/constants.h"
#include "sim/propulsion/rotor/advance_sweep.h"
#include "ui/charts/chart_pane.h"
#include "ui/forms/form_style.h"

namespace rotorbench {

namespace {

constexpr double kStep = 0.02;                             // of the advance ratio
constexpr double kFirstSpeed = 5000, kMostSpeed = 100000;  // rpm

std::shared_ptr<const Recording> recordingOf(const AdvanceSweep& curves) {
  auto recording = std::make_shared<Recording>(
      std::vector<Channel>{{"J", "1", "Advance ratio V/(n D)"},
                           {"CT", "1", "Thrust coefficient: T = CT rho n^2 D^4"},
                           {"CP", "1", "Power coefficient: P = CP rho n^3 D^5"},
                           {"efficiency", "%", "J CT/CP"}});
  for (const AdvancePoint& p : curves.points) {
    recording->append(
        std::array{p.advanceRatio, p.thrustCoefficient, p.powerCoefficient, 100 * p.efficiency});
  }
  recording->finish();
  return recording;
}

ChartSpec chart() {
  ChartSpec spec;
  spec.title = "Coefficients over the advance ratio";
  spec.kind = ChartKind::XY;
  spec.x = std::string("J");  // g++ 12 sees an overflow in the plain assignment
  spec.channels = "CT, CP, efficiency";
  return spec;
}

}  // namespace

PropellerFigures::PropellerFigures(QWidget* parent)
    : QWidget(parent),
      speed_(new QDoubleSpinBox),
      text_(new QLabel),
      pane_(new ChartPane(&runs_, &link_, this)) {
  setObjectName("propellerFigures");
  speed_->setObjectName("propellerSpeed");
  speed_->setAccessibleName(tr("Rotor speed"));
  speed_->setRange(1, kMostSpeed);
  speed_->setDecimals(0);
  speed_->setSingleStep(500);
  speed_->setValue(kFirstSpeed);
  speed_->setSuffix(tr(" rpm"));
  speed_->setKeyboardTracking(false);
  text_->setObjectName("propellerText");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  pane_->setSpec(chart());
  auto* label = new QLabel(tr("At a rotor &speed of"));
  label->setBuddy(speed_);
  auto* row = new QHBoxLayout;
  row->setSpacing(form_style::kMargin);
  row->addWidget(label, 0, Qt::AlignTop);
  row->addWidget(speed_, 0, Qt::AlignTop);
  row->addWidget(text_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  column->addWidget(pane_, 1);
  connect(speed_, &QDoubleSpinBox::valueChanged, this, &PropellerFigures::compute);
}

// The pane looks at the runs, which are a member and would go first.
PropellerFigures::~PropellerFigures() {
  delete pane_;
}

void PropellerFigures::setPropeller(const PropellerGeometry& geometry) {
  geometry_ = geometry;
  compute();
}

void PropellerFigures::setMessage(const QString& sentence) {
  text_->setText(sentence);
}

QString PropellerFigures::text() const {
  return text_->text();
}

void PropellerFigures::compute() {
  const AdvanceSweep curves =
      advanceSweep(BladeElementRotor(geometry_), speed_->value() * kRpm, AirState{}, kStep);
  const QLocale locale;
  const AdvancePoint& rest = curves.points.front();
  QStringList parts{tr("At rest CT %1, CP %2, figure of merit %3")
                        .arg(locale.toString(rest.thrustCoefficient, 'f', 4),
                             locale.toString(rest.powerCoefficient, 'f', 4),
                             locale.toString(curves.figureOfMerit, 'f', 3))};
  if (curves.best) {
    parts << tr("best efficiency %1 % at J %2")
                 .arg(locale.toString(100 * curves.best->efficiency, 'f', 1),
                      locale.toString(curves.best->advanceRatio, 'f', 2));
  }
  if (curves.zeroThrust)
    parts << tr("no thrust at J %1").arg(locale.toString(*curves.zeroThrust, 'f', 3));
  text_->setText(parts.join("; ") + '.');
  runs_.setRuns({{"curves", tr("Blade elements"), QColor(0, 114, 178), recordingOf(curves), true}});
  pane_->refresh();
}

}  // namespace rotorbench
