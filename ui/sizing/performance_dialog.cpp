#include "ui/sizing/performance_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment.h"
#include "sim/document/flight.h"
#include "sim/sizing/performance.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/plain_locale.h"
#include "ui/sizing/figure_table.h"

namespace rotorbench {

namespace {

/// The first fault of a part of the experiment, or empty.
QString faultOf(schema::ConstRef part, const char* name) {
  for (const Problem& problem : schema::validate(part)) {
    if (problem.warning) continue;
    return QString::fromStdString(schema::joinPath(name, problem.message()));
  }
  return {};
}

/// The sheet, or the sentence that says why there is none; never throws.
QString tryFiguresOf(const Flight& flight, const PerformanceSettings& settings,
                     FigureSheet& figures) {
  try {
    figures = performanceSheet(flight.vehicle, flight.environment, settings);
    return {};
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

}  // namespace

PerformanceDialog::PerformanceDialog(DocumentModel& experiment, QWidget* parent)
    : QDialog(parent),
      experiment_(experiment),
      settings_(makeDocument(PerformanceSettings{})),
      units_(&unitSettings_),
      context_{&settings_, &units_, plainLocale(), {}},
      form_(new ParameterForm(context_)),
      table_(new FigureTable(FigureTable::Detail::Note)),
      title_(new QLabel),
      result_([this] { return prepare(); }, [this](const Result& result) { showResult(result); }) {
  setObjectName("performanceDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Performance of the vehicle"));
  resize(1000, 700);
  build();
  const auto follow = [this](const DocumentModel& model) {
    for (const auto signal : {&DocumentModel::valueChanged, &DocumentModel::structureChanged}) {
      connect(&model, signal, this, [this] { result_.ask(); });
    }
    connect(&model, &DocumentModel::problemsChanged, this, [this] { result_.ask(); });
    connect(&model, &DocumentModel::documentReplaced, this, [this] { result_.ask(); });
  };
  follow(experiment_);
  follow(settings_);
  result_.ask();
}

// The form reads the settings to its end. It leaves the dialog first: a button that gets the focus
// while its neighbours are deleted would make the dialog look for its default button among them.
PerformanceDialog::~PerformanceDialog() {
  form_->hide();
  form_->setParent(nullptr);
  delete form_;
}

void PerformanceDialog::build() {
  title_->setObjectName("performanceTitle");
  title_->setTextFormat(Qt::PlainText);
  title_->setWordWrap(true);
  title_->setText(tr("Working out the sheet…"));  // a map of a propeller takes a second or two
  form_->showSection({});
  form_->setMinimumWidth(250);
  auto* panes = new QSplitter(Qt::Horizontal);
  panes->setObjectName("performancePanes");
  panes->addWidget(form_);
  panes->addWidget(table_);
  panes->setStretchFactor(0, 0);
  panes->setStretchFactor(1, 1);
  panes->setChildrenCollapsible(false);
  panes->setSizes({290, 710});
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* text = buttons->addButton(tr("Copy as &text"), QDialogButtonBox::ActionRole);
  auto* csv = buttons->addButton(tr("Copy as &CSV"), QDialogButtonBox::ActionRole);
  text->setObjectName("copyPerformanceText");
  csv->setObjectName("copyPerformanceCsv");
  // Enter in a field commits the field and presses no button.
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(text, &QPushButton::clicked, table_, &FigureTable::copyText);
  connect(csv, &QPushButton::clicked, table_, &FigureTable::copyCsv);
  for (auto* copy : {text, csv}) {
    connect(table_, &FigureTable::filled, copy, &QPushButton::setEnabled);
  }
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(title_);
  column->addWidget(panes, 1);
  column->addWidget(buttons);
}

LatestResult<PerformanceDialog::Result>::Job PerformanceDialog::prepare() const {
  const auto fail = [](const QString& sentence) {
    return [sentence] { return Result{{}, sentence}; };
  };
  const auto* flight = alternativeIf<Flight>(experiment_.as<Experiment>().setup);
  if (flight == nullptr) {
    return fail(
        tr("The open experiment has no vehicle. Open one that flies, and its figures appear "
           "here."));
  }
  QString fault = faultOf(schema::ref(flight->vehicle), "vehicle");
  if (fault.isEmpty()) fault = faultOf(schema::ref(flight->environment), "environment");
  if (fault.isEmpty()) fault = faultOf(schema::ref(settings_.as<PerformanceSettings>()), "");
  if (!fault.isEmpty()) return fail(fault);
  return [flight = *flight, settings = settings_.as<PerformanceSettings>()] {
    Result result;
    result.problem = tryFiguresOf(flight, settings, result.figures);
    return result;
  };
}

void PerformanceDialog::showResult(const Result& result) {
  title_->setText(QString::fromStdString(experiment_.as<Experiment>().title));
  if (result.problem.isEmpty()) {
    table_->setSheet(result.figures);
  } else {
    table_->setProblem(result.problem);
  }
}

}  // namespace rotorbench
