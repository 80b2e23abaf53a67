#include "ui/sizing/data_sheet_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "sim/core/schema_tree.h"
#include "sim/document/experiment.h"
#include "sim/sizing/apply_data_sheet.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/plain_locale.h"
#include "ui/library/library_forms.h"
#include "ui/library/save_component.h"
#include "ui/sizing/figure_table.h"
#include "ui/sizing/throttle_chart.h"

namespace rotorbench {

namespace {

/// The struct at `path`, whose last step is a group.
Snapshot partOf(Experiment& experiment, const std::string& path) {
  const schema::Location at = schema::locate(schema::ref(experiment), path);
  return capture({&at.field->childType(at.owner, 0), at.field->child(at.owner, 0)});
}

}  // namespace

DataSheetDialog::DataSheetDialog(DocumentModel& experiment, QWidget* parent)
    : QDialog(parent),
      experiment_(experiment),
      sheet_(makeDocument(dataSheetOf(experiment.as<Experiment>()).value_or(DataSheet{}))),
      units_(&unitSettings_),
      context_{&sheet_,
               &units_,
               plainLocale(),
               {},
               componentHooks(sheet_, *this).has,
               componentHooks(sheet_, *this).pick},
      form_(new ParameterForm(context_)),
      table_(new FigureTable(FigureTable::Detail::Formula)),
      chart_(new ThrottleChart),
      target_(new QLabel),
      result_([this] { return prepare(); }, [this](const Result& result) { showResult(result); }) {
  setObjectName("dataSheetDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Motor from a data sheet"));
  resize(1080, 720);
  buildPanes();
  buildButtons();
  for (const auto signal : {&DocumentModel::valueChanged, &DocumentModel::structureChanged}) {
    connect(&sheet_, signal, this, [this] { result_.ask(); });
    connect(&experiment_, signal, this, &DataSheetDialog::updateTarget);
  }
  connect(&sheet_, &DocumentModel::problemsChanged, this, [this] { result_.ask(); });
  connect(&experiment_, &DocumentModel::documentReplaced, this, &DataSheetDialog::updateTarget);
  updateTarget();
  result_.ask();
}

// The form reads the document to its end. It leaves the dialog first: a button that gets the focus
// while its neighbours are deleted would make the dialog look for its default button among them.
DataSheetDialog::~DataSheetDialog() {
  form_->hide();
  form_->setParent(nullptr);
  delete form_;
}

void DataSheetDialog::buildPanes() {
  auto* results = new QSplitter(Qt::Vertical);
  results->setObjectName("dataSheetResults");
  results->addWidget(table_);
  results->addWidget(chart_);
  results->setStretchFactor(0, 3);
  results->setStretchFactor(1, 2);
  results->setChildrenCollapsible(false);
  auto* panes = new QSplitter(Qt::Horizontal);
  panes->setObjectName("dataSheetPanes");
  panes->addWidget(form_);
  panes->addWidget(results);
  panes->setStretchFactor(0, 0);
  panes->setStretchFactor(1, 1);
  panes->setChildrenCollapsible(false);
  panes->setSizes({340, 740});
  form_->setMinimumWidth(270);
  form_->showSection({});
  connect(form_, &ParameterForm::sectionRequested, form_, &ParameterForm::showSection);
  target_->setObjectName("dataSheetTarget");
  target_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->addWidget(panes, 1);
  column->addWidget(target_);
}

void DataSheetDialog::buildButtons() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  apply_ = buttons->addButton(tr("&Use in the experiment"), QDialogButtonBox::ActionRole);
  apply_->setObjectName("useDataSheet");
  read_ = buttons->addButton(tr("&Read from the experiment"), QDialogButtonBox::ActionRole);
  read_->setObjectName("readDataSheet");
  auto* save = buttons->addButton(tr("&Save motor to library…"), QDialogButtonBox::ActionRole);
  save->setObjectName("saveMotor");
  connect(save, &QPushButton::clicked, this, &DataSheetDialog::saveMotor);
  auto* copy = buttons->addButton(tr("Copy as &text"), QDialogButtonBox::ActionRole);
  copy->setObjectName("copyDataSheet");
  // Enter in a field commits the field and presses no button.
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(apply_, &QPushButton::clicked, this, &DataSheetDialog::apply);
  connect(read_, &QPushButton::clicked, this, &DataSheetDialog::readExperiment);
  connect(copy, &QPushButton::clicked, table_, &FigureTable::copyText);
  connect(table_, &FigureTable::filled, copy, &QPushButton::setEnabled);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout()->addWidget(buttons);
}

void DataSheetDialog::updateTarget() {
  const std::string target = dataSheetTarget(experiment_.as<Experiment>());
  const bool errors = sheet_.hasErrors();
  apply_->setEnabled(!target.empty() && !errors);
  read_->setEnabled(!target.empty());
  if (target.empty()) {
    target_->setText(
        tr("The open experiment has no motor, so the drive cannot be used in it. Open "
           "one with a vehicle or a stand."));
  } else if (errors) {
    target_->setText(tr("Put the data sheet right before it is used in the experiment."));
  } else if (target == "setup.vehicle") {
    target_->setText(
        tr("Used in the experiment, all rotors of the vehicle become this drive; the "
           "vehicle's mass stays as it is there."));
  } else {
    target_->setText(tr("Used in the experiment, the stand gets this drive."));
  }
}

void DataSheetDialog::readExperiment() {
  const auto found = dataSheetOf(experiment_.as<Experiment>());
  if (!found) return;
  DataSheet sheet = *found;
  sheet_.replaceObject({}, capture(schema::ref(sheet)), tr("Read from the experiment"));
}

void DataSheetDialog::saveMotor() {
  sheet_.commitPendingEdits();
  if (sheet_.hasErrors()) return updateTarget();
  askToSaveComponent(makeComponent<MotorParameters>({}, sheet_.as<DataSheet>().motor), this,
                     [this](const QString& sentence) {
                       target_->setText(sentence);
                       emit applied(sentence);
                     });
}

void DataSheetDialog::apply() {
  sheet_.commitPendingEdits();
  experiment_.commitPendingEdits();
  Experiment changed = experiment_.as<Experiment>();
  const std::string target = dataSheetTarget(changed);
  if (target.empty() || sheet_.hasErrors()) return updateTarget();
  applyDataSheet(sheet_.as<DataSheet>(), changed);
  experiment_.replaceObject(QString::fromStdString(target), partOf(changed, target),
                            tr("Drive from a data sheet"));
  const QString sentence =
      tr("The drive of the data sheet is in the experiment; Undo takes it out again.");
  target_->setText(sentence);
  emit applied(sentence);
}

LatestResult<DataSheetDialog::Result>::Job DataSheetDialog::prepare() const {
  for (const Problem& problem : sheet_.problems()) {
    if (problem.warning) continue;
    const QString sentence = QString::fromStdString(problem.message());
    return [sentence] { return Result{{}, {}, sentence}; };
  }
  return [sheet = sheet_.as<DataSheet>()] {
    return Result{figuresOf(sheet), throttleCurve(sheet), {}};
  };
}

void DataSheetDialog::showResult(const Result& result) {
  updateTarget();
  if (!result.problem.isEmpty()) {
    table_->setProblem(result.problem);
    return;
  }
  table_->setSheet(result.figures);
  chart_->setCurve(result.curve);
}

}  // namespace rotorbench
