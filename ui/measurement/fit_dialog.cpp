#include "ui/measurement/fit_dialog.h"

#include <QComboBox>
#include <QDate>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QtConcurrentRun>
#include <algorithm>
#include <cmath>

#include "sim/core/units.h"
#include "sim/fitting/doubt.h"
#include "sim/fitting/provenance.h"
#include "sim/run/simulation.h"
#include "ui/charts/chart_pane.h"
#include "ui/forms/field_text.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/plain_locale.h"
#include "ui/library/save_component.h"
#include "ui/measurement/table_cell.h"
#include "ui/runs/run_colors.h"

namespace rotorbench {

namespace {

constexpr int kClockMilliseconds = 100;

const char* modelName(const FitRequest& request) {
  constexpr const char* kNames[]{"motor", "propeller by blade elements", "lumped rotor"};
  return kNames[request.what.index()];
}

/// The points of one output in the order of x, measured or predicted.
std::shared_ptr<const Recording> seriesOf(const FitProblem& problem, std::size_t output,
                                          const std::vector<double>* predicted) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const FitPoint& p = problem.points[i];
    if (p.output == output)
      points.emplace_back(p.x, predicted != nullptr ? (*predicted)[i] : p.measured);
  }
  std::ranges::sort(points);
  const FitOutput& what = problem.outputs[output];
  // In the units a person reads: nothing but this chart sees the recording.
  const double xFactor = unitFactor(problem.abscissaUnit, problem.abscissaShown);
  const double yFactor = unitFactor(what.unit, what.shown);
  MeasuredTable table;
  table.channels = {{problem.abscissa, problem.abscissaShown, ""}, {what.label, what.shown, ""}};
  table.columns.resize(2);
  for (const auto& [x, y] : points) {
    table.columns[0].push_back(x / xFactor);
    table.columns[1].push_back(y / yFactor);
  }
  return recordingOf(table);
}

}  // namespace

FitDialog::FitDialog(DocumentModel& experiment, const RunList& runs, QWidget* parent)
    : QDialog(parent),
      experiment_(experiment),
      target_(experiment),
      request_(makeDocument(FitRequest{})),
      units_(nullptr),
      context_{&request_, &units_, plainLocale()},
      form_(new ParameterForm(context_)),
      set_(new QComboBox),
      output_(new QComboBox),
      rows_(new QLabel),
      verdict_(new QLabel),
      message_(new QLabel),
      table_(new QTableWidget(0, 4)),
      chart_(new ChartPane(&chartRuns_, &link_)),
      bar_(new QProgressBar) {
  setObjectName("fitDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Fit to measurement"));
  resize(1040, 700);
  for (const RunRecord& record : runs.records()) {
    if (!record.measured) continue;
    for (const RunOutput& output : record.status.outputs)
      measured_.push_back({record.name, output.recording});
  }
  new QVBoxLayout(this);
  buildPanes();
  buildButtons();
  clock_.setInterval(kClockMilliseconds);
  connect(&clock_, &QTimer::timeout, this,
          [this] { bar_->setFormat(tr("Step %1").arg(progress_->iteration.load())); });
  connect(&watcher_, &QFutureWatcherBase::finished, this, &FitDialog::finish);
  for (const auto signal : {&DocumentModel::valueChanged, &DocumentModel::structureChanged})
    connect(&request_, signal, this, &FitDialog::check);
  connect(set_, &QComboBox::currentIndexChanged, this, &FitDialog::check);
  connect(&experiment_, &DocumentModel::documentReplaced, this, &QDialog::close);
  check();
}

// The fit must not outlive the data it reads, the form its context, the chart its runs.
FitDialog::~FitDialog() {
  progress_->cancel = true;
  watcher_.disconnect();
  watcher_.waitForFinished();
  form_->hide();
  form_->setParent(nullptr);
  delete form_;
  delete chart_;
}

void FitDialog::buildPanes() {
  set_->setObjectName("fitMeasured");
  set_->setAccessibleName(tr("Measured data"));
  for (const Measured& m : measured_) set_->addItem(m.name);
  auto* sets = new QFormLayout;
  sets->addRow(tr("&Measured data:"), set_);
  qobject_cast<QVBoxLayout*>(layout())->addLayout(sets);
  form_->setMinimumWidth(300);
  form_->showSection({});
  auto* panes = new QSplitter(Qt::Horizontal);
  panes->addWidget(form_);
  panes->addWidget(buildResults());
  panes->setChildrenCollapsible(false);
  panes->setSizes({340, 700});
  qobject_cast<QVBoxLayout*>(layout())->addWidget(panes, 1);
}

QWidget* FitDialog::buildResults() {
  table_->setObjectName("fitTable");
  table_->setAccessibleName(tr("Fitted values"));
  table_->setHorizontalHeaderLabels({tr("Quantity"), tr("Before"), tr("Fitted"), tr("Remark")});
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);  // remarks wrap
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(true);
  verdict_->setObjectName("fitVerdict");
  verdict_->setAccessibleName(tr("How the fit ended"));
  verdict_->setWordWrap(true);
  verdict_->setTextFormat(Qt::PlainText);
  verdict_->hide();  // before the first fit
  output_->setObjectName("fitOutput");
  output_->setAccessibleName(tr("Quantity on the chart"));
  connect(output_, &QComboBox::currentIndexChanged, this, &FitDialog::showOutput);
  chart_->setObjectName("fitChart");
  pictures_ = new QWidget;
  pictures_->hide();  // nothing to show before the first fit
  auto* column = new QVBoxLayout(pictures_);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(output_, 0, Qt::AlignLeft);
  column->addWidget(chart_, 1);
  auto* results = new QSplitter(Qt::Vertical);
  results->addWidget(table_);
  results->addWidget(pictures_);
  results->setChildrenCollapsible(false);
  results->setSizes({240, 360});
  auto* side = new QWidget;
  auto* lines = new QVBoxLayout(side);
  lines->setContentsMargins(0, 0, 0, 0);
  lines->addWidget(verdict_);
  lines->addWidget(results, 1);
  return side;
}

void FitDialog::buildButtons() {
  rows_->setObjectName("fitRows");
  rows_->setAccessibleName(tr("What is made of the rows"));
  rows_->setWordWrap(true);
  message_->setObjectName("fitMessage");
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  message_->setMinimumHeight(2 * message_->fontMetrics().lineSpacing());
  message_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  bar_->setObjectName("fitProgress");
  bar_->setAccessibleName(tr("Progress of the fit"));
  bar_->setRange(0, 0);
  bar_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  const auto add = [&](const char* name, const QString& text, void (FitDialog::*slot)()) {
    auto* button = buttons->addButton(text, QDialogButtonBox::ActionRole);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this, slot);
    return button;
  };
  run_ = add("fitRun", tr("&Fit"), &FitDialog::run);
  cancel_ = buttons->addButton(tr("&Cancel the fit"), QDialogButtonBox::ActionRole);
  cancel_->setObjectName("fitCancel");
  connect(cancel_, &QPushButton::clicked, this, [this] { progress_->cancel = true; });
  use_ = add("fitUse", tr("&Use in the experiment"), &FitDialog::use);
  save_ = add("fitSave", tr("&Save to library…"), &FitDialog::save);
  for (auto* button : buttons->findChildren<QPushButton*>()) button->setAutoDefault(false);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout()->addWidget(rows_);
  layout()->addWidget(message_);
  layout()->addWidget(bar_);
  layout()->addWidget(buttons);
}

MeasuredTable FitDialog::table() const {
  const Measured& chosen = measured_[static_cast<std::size_t>(set_->currentIndex())];
  return tableOf(*chosen.recording, chosen.name.toStdString());
}

void FitDialog::check() {
  const bool running = watcher_.isRunning();
  QStringList lines;
  if (measured_.empty()) {
    lines << tr("There are no measured data yet: import them first.");
  } else if (!request_.hasErrors()) {
    const MeasuredTable measured = table();
    const FitStart start = target_.start();
    for (const std::string& line : missingFor(request_.as<FitRequest>(), measured, start))
      lines << toQString(line);
    QStringList rows;
    for (const std::string& line : {dutyText(request_.as<FitRequest>(), measured, start),
                                    limitedRowsText(request_.as<FitRequest>(), measured, start)}) {
      if (!line.empty()) rows << toQString(line);
    }
    rows_->setText(rows.join('\n'));
  }
  rows_->setVisible(!rows_->text().isEmpty());
  run_->setEnabled(!running && lines.isEmpty() && !request_.hasErrors());
  cancel_->setEnabled(running);
  use_->setEnabled(!running && component_ && !target_.place(asked_).isEmpty());
  save_->setEnabled(!running && component_.has_value());
  if (!running && !lines.isEmpty()) message_->setText(lines.join('\n'));
  if (!running && lines.isEmpty() && !outcome_) message_->clear();
}

void FitDialog::run() {
  request_.commitPendingEdits();
  if (request_.hasErrors()) return check();
  asked_ = request_.as<FitRequest>();
  start_ = target_.start();
  file_ = set_->currentText();
  component_.reset();
  outcome_.reset();
  progress_->cancel = false;
  progress_->iteration = 0;
  const auto job = [request = asked_, start = start_, data = table(), progress = progress_] {
    Outcome outcome;
    try {
      outcome.problem = problemOf(request, data, start);
      FitOptions options;
      options.robust = request.robust;
      options.progress = [&](const FitProgress& at) {
        progress->iteration = at.iteration;
        return !progress->cancel;
      };
      outcome.result = solveLeastSquares(outcome.problem, options);
    } catch (const InputError& error) {
      outcome.result.sentence = error.problems().front().message();
    }
    return outcome;
  };
  watcher_.setFuture(QtConcurrent::run(job));
  verdict_->hide();
  message_->setText(tr("Fitting…"));
  bar_->show();
  clock_.start();
  check();
}

void FitDialog::finish() {
  clock_.stop();
  bar_->hide();
  outcome_ = watcher_.result();
  const std::string source =
      provenanceText({file_.toStdString(), QDate::currentDate().toString(Qt::ISODate).toStdString(),
                      modelName(asked_)},
                     outcome_->result);
  component_ = target_.component(asked_, start_, outcome_->result, source);
  showResult();
  check();
}

void FitDialog::showResult() {
  const FitResult& result = outcome_->result;
  const QLocale locale;
  const bool doubtful = !doubtsOf(result).empty();
  verdict_->setText(toQString(verdictOf(result)));
  QFont font = this->font();
  font.setBold(doubtful);
  verdict_->setFont(font);
  verdict_->show();
  message_->clear();
  table_->setRowCount(0);
  const auto add = [&](const QStringList& texts) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (int i = 0; i < texts.size(); ++i)
      table_->setItem(row, i, tableCell(texts[i], i == 1 || i == 2));
  };
  for (const FittedParameter& p : result.parameters) {
    FittedParameter before = p;
    before.value = p.parameter.start;
    before.halfWidth.reset();
    before.determined = true;
    add({toQString(p.parameter.label),
         prettyUnit(toQString(numberIn(before.value, p.parameter.unit, p.parameter.shown))),
         prettyUnit(toQString(valueText(p))), toQString(p.remark)});
  }
  for (const FittedOutput& o : result.outputs) {
    if (o.count == 0) continue;
    const auto shown = [&](double value) {
      return prettyUnit(toQString(numberIn(value, o.output.unit, o.output.shown)));
    };
    add({tr("RMSE of %1").arg(toQString(o.output.label).toLower()), shown(o.rmseBefore),
         shown(o.rmseAfter),
         std::isfinite(o.rSquared)
             ? tr("R² %1 over %2 values").arg(locale.toString(o.rSquared, 'f', 4)).arg(o.count)
             : tr("%1 values").arg(o.count)});
  }
  const QSignalBlocker quiet(output_);
  output_->clear();
  pictures_->setVisible(result.usable());
  for (std::size_t i = 0; result.usable() && i < result.outputs.size(); ++i) {
    const FittedOutput& o = result.outputs[i];
    if (o.count > 0) output_->addItem(toQString(o.output.label), static_cast<int>(i));
  }
  showOutput();
}

void FitDialog::showOutput() {
  if (output_->currentIndex() < 0 || !outcome_) {
    chartRuns_.setRuns({});
    return;
  }
  const auto chosen = static_cast<std::size_t>(output_->currentData().toInt());
  const FitProblem& problem = outcome_->problem;
  ChartSpec spec;
  spec.title = tr("%1 over %2")
                   .arg(output_->currentText(), toQString(problem.abscissa).toLower())
                   .toStdString();
  spec.kind = ChartKind::XY;
  spec.x = problem.abscissa;
  spec.channels = problem.outputs[chosen].label;
  chart_->setSpec(spec);
  chartRuns_.setRuns(
      {{"fitted", tr("Fitted"), runColor(0), seriesOf(problem, chosen, &outcome_->result.predicted),
        true, false},
       {"measured", tr("Measured"), runColor(1), seriesOf(problem, chosen, nullptr), true, true}});
  chart_->refresh();
}

void FitDialog::say(const QString& sentence) {
  message_->setText(sentence);
  emit reported(sentence);
}

void FitDialog::use() {
  if (!component_ || !outcome_) return;
  const std::vector<std::string> doubts = doubtsOf(outcome_->result);
  if (doubts.empty()) return takeIntoExperiment();
  QStringList lines;
  for (const std::string& doubt : doubts) lines << toQString(doubt);
  auto* box =
      new QMessageBox(QMessageBox::Warning, tr("Use a doubtful fit"),
                      tr("The values of this fit are doubtful. Use them in the experiment?"),
                      QMessageBox::Cancel, this);
  box->setObjectName("fitDoubtBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(lines.join('\n'));
  auto* yes = box->addButton(tr("&Use anyway"), QMessageBox::AcceptRole);
  yes->setObjectName("fitUseAnyway");
  box->setDefaultButton(QMessageBox::Cancel);
  connect(yes, &QPushButton::clicked, this, &FitDialog::takeIntoExperiment);
  box->open();
}

void FitDialog::takeIntoExperiment() {
  if (!component_) return;
  const QString place = target_.place(asked_);
  target_.use(asked_, *component_);
  say(tr("The fit is in the experiment, at %1; Undo takes it out again.").arg(place));
}

void FitDialog::save() {
  if (!component_) return;
  askToSaveComponent(*component_, this, [this](const QString& sentence) { say(sentence); });
}

}  // namespace rotorbench
