#include "ui/propeller/lumped_dialog.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "sim/core/schema_tree.h"
#include "sim/library/component.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/plain_locale.h"
#include "ui/library/component_place.h"
#include "ui/sizing/figure_table.h"

namespace rotorbench {

namespace {

/// That of the hover, or of some speed where nothing hovers. May take the time a map does.
LumpingRange firstRange(const std::optional<Experiment>& experiment, const RotorModelAt& rotor) {
  if (experiment) {
    if (const auto hover = lumpingRangeOf(*experiment, rotor)) return *hover;
  }
  return lumpingRange(rotor.model, LumpingRange{}.speed, LumpingRange{}.density);
}

}  // namespace

LumpedDialog::LumpedDialog(DocumentModel& model, RotorModelAt rotor, QWidget* parent)
    : QDialog(parent),
      model_(model),
      rotor_(std::move(rotor)),
      settings_(makeDocument(LumpingRange{})),
      units_(&unitSettings_),
      context_{&settings_, &units_, plainLocale(), {}},
      form_(new ParameterForm(context_)),
      table_(new FigureTable(FigureTable::Detail::Formula)),
      result_([this] { return prepare(); }, [this](const Result& result) { showResult(result); }) {
  setObjectName("lumpedDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Lumped coefficients of this propeller"));
  resize(900, 620);
  build();
  form_->setEnabled(false);
  table_->setProblem(tr("Working out the hover…"));
  for (const auto signal : {&DocumentModel::valueChanged, &DocumentModel::structureChanged}) {
    connect(&settings_, signal, this, [this] { result_.ask(); });
    // What is shown must be of the propeller that is there.
    connect(&model_, signal, this, &QDialog::close);
  }
  connect(&settings_, &DocumentModel::problemsChanged, this, [this] { result_.ask(); });
  connect(&model_, &DocumentModel::documentReplaced, this, &QDialog::close);
  result_.ask();
}

// As PerformanceDialog: the form reads the settings to its end, and leaves the dialog first.
LumpedDialog::~LumpedDialog() {
  disconnect(&model_, nullptr, this, nullptr);
  form_->hide();
  form_->setParent(nullptr);
  delete form_;
}

void LumpedDialog::build() {
  form_->showSection({});
  form_->setMinimumWidth(250);
  auto* panes = new QSplitter(Qt::Horizontal);
  panes->addWidget(form_);
  panes->addWidget(table_);
  panes->setStretchFactor(0, 0);
  panes->setStretchFactor(1, 1);
  panes->setChildrenCollapsible(false);
  panes->setSizes({290, 610});
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  use_ = buttons->addButton(tr("&Use in its place"), QDialogButtonBox::ActionRole);
  use_->setObjectName("useLumped");
  use_->setToolTip(tr("The propeller becomes these coefficients; Undo brings it back"));
  use_->setEnabled(false);
  auto* copy = buttons->addButton(tr("Copy as &text"), QDialogButtonBox::ActionRole);
  copy->setObjectName("copyLumped");
  copy->setEnabled(false);
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(use_, &QPushButton::clicked, this, &LumpedDialog::use);
  connect(copy, &QPushButton::clicked, table_, &FigureTable::copyText);
  connect(table_, &FigureTable::filled, copy, &QPushButton::setEnabled);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* column = new QVBoxLayout(this);
  column->addWidget(panes, 1);
  column->addWidget(buttons);
}

const LumpingRange& LumpedDialog::range() const {
  return settings_.as<LumpingRange>();
}

LatestResult<LumpedDialog::Result>::Job LumpedDialog::prepare() const {
  if (!ranged_) {
    std::optional<Experiment> experiment;
    if (model_.root().type == &schema::typeOf<Experiment>()) experiment = model_.as<Experiment>();
    return [experiment, rotor = rotor_] {
      Result result;
      try {
        result.first = firstRange(experiment, rotor);
      } catch (const std::exception& error) {
        result.problem = QString::fromUtf8(error.what());
      }
      return result;
    };
  }
  for (const Problem& problem : schema::validate(settings_.root())) {
    if (problem.warning) continue;
    return [text = QString::fromStdString(problem.message())] { return Result{{}, {}, {}, text}; };
  }
  return [model = rotor_.model, at = range()] {
    try {
      const LumpedEquivalent lumped = lumpedEquivalent(model, at);
      return Result{{}, lumped, lumpingSheet(lumped, at), {}};
    } catch (const std::exception& error) {
      return Result{{}, {}, {}, QString::fromUtf8(error.what())};
    }
  };
}

void LumpedDialog::showResult(const Result& result) {
  if (!ranged_) {
    ranged_ = true;
    form_->setEnabled(true);
    if (result.first) settings_.replaceObject({}, capture(schema::ref(*result.first)), {});
    if (result.problem.isEmpty()) return result_.ask();
  }
  lumped_ = result.lumped;
  use_->setEnabled(lumped_.has_value());
  if (lumped_) {
    table_->setSheet(result.figures);
  } else {
    table_->setProblem(result.problem);
  }
}

void LumpedDialog::use() {
  if (!lumped_) return;
  disconnect(&model_, nullptr, this, nullptr);
  const Component component =
      makeComponent({tr("lumped coefficients").toStdString(), {}, {}, {}}, lumped_->coefficients);
  ComponentPlace(model_, QString::fromStdString(rotor_.path)).use(component);
  close();
}

}  // namespace rotorbench
