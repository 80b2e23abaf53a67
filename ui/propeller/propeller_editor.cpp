#include "ui/propeller/propeller_editor.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "sim/scene/propeller_scene.h"
#include "ui/forms/field_text.h"
#include "ui/forms/form_style.h"
#include "ui/forms/parameter_form.h"
#include "ui/forms/plain_locale.h"
#include "ui/library/library_forms.h"
#include "ui/propeller/blade_curves.h"
#include "ui/propeller/lumped_dialog.h"
#include "ui/propeller/polar_import.h"
#include "ui/propeller/propeller_figures.h"
#include "ui/scene/scene_view.h"

namespace rotorbench {

namespace {

constexpr int kRefreshMilliseconds = 30;
constexpr double kCloser = 0.62;  // there is nothing round a propeller to be seen

/// A button of the row below for an undo or redo action of the document.
QToolButton* actionButton(QAction* action, const char* name) {
  auto* button = new QToolButton;
  button->setObjectName(name);
  button->setDefaultAction(action);
  button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  return button;
}

}  // namespace

QStringList propellersOf(schema::ConstRef root) {
  QStringList paths;
  schema::walk(root, [&](const std::string& path, const schema::Field& field, const void* owner) {
    if (field.isLeaf() || field.kind == schema::Kind::List) return;
    if (&field.childType(owner, 0) == &schema::typeOf<PropellerGeometry>())
      paths << toQString(path);
  });
  return paths;
}

PropellerEditor::PropellerEditor(DocumentModel& model, QWidget* parent)
    : QDialog(parent),
      model_(model),
      units_(nullptr),
      context_{&model,
               &units_,
               plainLocale(),
               {},
               componentHooks(model, *this).has,
               componentHooks(model, *this).pick},
      picker_(new QComboBox),
      form_(new ParameterForm(context_)),
      curves_(new BladeCurves),
      view_(createSceneView(nullptr)),
      figures_(new PropellerFigures),
      message_(new QLabel) {
  setObjectName("propellerEditor");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Propeller editor"));
  resize(1180, 760);
  new QVBoxLayout(this);
  buildPicker();
  buildPages();
  buildButtons();
  refresh_.setSingleShot(true);
  refresh_.setInterval(kRefreshMilliseconds);
  connect(&refresh_, &QTimer::timeout, this, &PropellerEditor::refresh);
  connect(&model_, &DocumentModel::valueChanged, this, &PropellerEditor::follow);
  connect(&model_, &DocumentModel::structureChanged, this, &PropellerEditor::follow);
  connect(&model_, &DocumentModel::documentReplaced, this, &QDialog::close);
  connect(form_, &ParameterForm::sectionRequested, this, &PropellerEditor::followForm);
  connect(curves_, &BladeCurves::chordChosen, this, [this](int station, double chord) {
    model_.set(stationPath(station, "chord"), chord, DocumentModel::Edit::Repeated);
  });
  connect(curves_, &BladeCurves::twistChosen, this, [this](int station, double twist) {
    model_.set(stationPath(station, "twist"), twist, DocumentModel::Edit::Repeated);
  });
  connect(curves_, &BladeCurves::insertAsked, this, &PropellerEditor::insertStation);
  connect(curves_, &BladeCurves::removeAsked, this, &PropellerEditor::removeStation);
  fillPicker();
}

// The form reads the context to the end.
PropellerEditor::~PropellerEditor() {
  disconnect(&model_, nullptr, this, nullptr);
  delete form_;
}

void PropellerEditor::buildPicker() {
  picker_->setObjectName("propellerPicker");
  picker_->setAccessibleName(tr("Propeller"));
  picker_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  layout()->addWidget(picker_);
  connect(picker_, &QComboBox::activated, this,
          [this](int row) { showPropeller(picker_->itemData(row).toString()); });
}

void PropellerEditor::buildPages() {
  view_->setAccessibleName(tr("The propeller in 3D"));
  view_->setObjectName("propellerScene");
  view_->setOptions({.trail = false,
                     .thrust = false,
                     .grid = false,
                     .axes = false,
                     .setPoint = false,
                     .writing = false});
  auto* upper = new QSplitter(Qt::Horizontal);
  upper->addWidget(curves_);
  upper->addWidget(view_);
  upper->setSizes({480, 320});
  auto* right = new QSplitter(Qt::Vertical);
  right->addWidget(upper);
  right->addWidget(figures_);
  right->setSizes({360, 340});
  auto* pages = new QSplitter(Qt::Horizontal);
  form_->setMinimumWidth(320);
  pages->addWidget(form_);
  pages->addWidget(right);
  pages->setStretchFactor(0, 0);
  pages->setStretchFactor(1, 1);
  pages->setSizes({380, 800});
  pages->setChildrenCollapsible(false);
  qobject_cast<QVBoxLayout*>(layout())->addWidget(pages, 1);
}

void PropellerEditor::buildButtons() {
  message_->setObjectName("propellerMessage");
  message_->setWordWrap(true);
  message_->hide();
  layout()->addWidget(message_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  auto* polars = buttons->addButton(tr("Import &polars…"), QDialogButtonBox::ActionRole);
  polars->setObjectName("importPolars");
  polars->setAutoDefault(false);
  polars->setToolTip(tr("A section from the polar files XFOIL and XFLR5 write"));
  connect(polars, &QPushButton::clicked, this, &PropellerEditor::askForPolars);
  lump_ = buttons->addButton(tr("&Lumped coefficients…"), QDialogButtonBox::ActionRole);
  lump_->setObjectName("lumpPropeller");
  lump_->setAutoDefault(false);
  lump_->setToolTip(tr("Coefficients that stand for this propeller about one speed"));
  connect(lump_, &QPushButton::clicked, this, &PropellerEditor::openLumped);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  QUndoStack* stack = model_.undoStack();
  auto* row = new QHBoxLayout;
  row->addWidget(actionButton(stack->createUndoAction(this, tr("Undo")), "propellerUndo"));
  row->addWidget(actionButton(stack->createRedoAction(this, tr("Redo")), "propellerRedo"));
  row->addWidget(buttons, 1);
  qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void PropellerEditor::fillPicker() {
  const QStringList paths = propellersOf(model_.root());
  picker_->clear();
  for (const QString& path : paths) {
    picker_->addItem(path.isEmpty() ? tr("Propeller") : placeText(model_.root(), path), path);
  }
  picker_->setVisible(paths.size() > 1);
  const bool own = model_.root().type == &schema::typeOf<PropellerGeometry>();
  if (paths.isEmpty() && !own) {
    close();
    return;
  }
  const qsizetype row = std::max<qsizetype>(0, paths.indexOf(path_));
  picker_->setCurrentIndex(static_cast<int>(row));
  showPropeller(own ? QString() : paths[row]);
}

void PropellerEditor::showPropeller(const QString& path) {
  path_ = path;
  lump_->setEnabled(lumpable().has_value());
  form_->showSection(path);
  refresh();
}

/// Links of the form lead round inside the propeller; those to sections above it stay here.
void PropellerEditor::followForm(const QString& section) {
  form_->showSection(isAtOrBelow(section, path_) ? section : path_);
}

void PropellerEditor::follow(const QString& changed) {
  if (isAtOrBelow(changed, path_) || isAtOrBelow(path_, changed)) refresh_.start();
}

const PropellerGeometry& PropellerEditor::geometry() const {
  return *static_cast<const PropellerGeometry*>(model_.object(path_)->object);
}

void PropellerEditor::refresh() {
  const auto object = model_.object(path_);
  if (!object || object->type != &schema::typeOf<PropellerGeometry>()) return fillPicker();
  curves_->setStations(geometry().stations);
  const auto problems = schema::validate(*object);
  const auto fault = std::ranges::find(problems, false, &Problem::warning);
  if (fault != problems.end()) {
    figures_->setMessage(QString::fromStdString(fault->message()));
    return;
  }
  const bool first = !view_->stage().model();
  view_->setModel(propellerScene(geometry()));
  if (first) view_->zoom(kCloser);
  figures_->setPropeller(geometry());
}

QString PropellerEditor::stationPath(int station, const char* key) const {
  const QString list = joinPath(path_, QStringLiteral("stations"));
  return joinPath(elementPath(list, static_cast<std::size_t>(station)), QString::fromLatin1(key));
}

void PropellerEditor::replaceStations(const std::vector<BladeStation>& stations,
                                      const QString& text) {
  PropellerGeometry changed = geometry();
  changed.stations = stations;
  const schema::Field* field = schema::typeOf<PropellerGeometry>().field("stations");
  model_.replaceRows(joinPath(path_, QStringLiteral("stations")), capture(*field, &changed), text);
}

void PropellerEditor::insertStation(double radius) {
  PropellerGeometry plain = geometry();
  plain.twistOffset = 0;
  const BladeShape shape = bladeShape(plain, radius, 0);
  auto stations = geometry().stations;
  const auto at = std::ranges::lower_bound(stations, radius, {}, &BladeStation::radius);
  if (at != stations.end() && at->radius == radius) return;
  stations.insert(at, {radius, shape.chord, shape.twist});
  replaceStations(stations, tr("Add station"));
}

void PropellerEditor::removeStation(int station) {
  auto stations = geometry().stations;
  if (stations.size() < 2) return;
  stations.erase(stations.begin() + station);
  replaceStations(stations, tr("Remove station"));
}

std::optional<RotorModelAt> PropellerEditor::lumpable() const {
  for (RotorModelAt& one : rotorModelsIn(model_.root()))
    if (path_.startsWith(toQString(one.path) + QLatin1Char('.'))) return std::move(one);
  return std::nullopt;
}

void PropellerEditor::openLumped() {
  const auto rotor = lumpable();
  const auto faulty = [](const Problem& problem) { return !problem.warning; };
  if (!rotor || std::ranges::any_of(schema::validate(*model_.object(path_)), faulty)) return;
  (new LumpedDialog(model_, *rotor, this))->show();
}

void PropellerEditor::askForPolars() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Import polars"), {}, tr("Polars (*.txt *.pol *.dat);;All files (*)"));
  if (files.isEmpty()) return;
  bool accepted = false;
  const double first = geometry().sections.front().radius;
  const double radius = QInputDialog::getDouble(
      this, tr("Import polars"), tr("The section begins at r/R"), first, 0, 1, 3, &accepted);
  if (accepted) importPolars(files, radius);
}

bool PropellerEditor::importPolars(const QStringList& files, double radius) {
  try {
    const auto changed = withSection(geometry(), radius, sectionFromFiles(files));
    model_.replaceObject(path_, capture(schema::ref(changed)), tr("Import polars"));
    message_->hide();
    return true;
  } catch (const InputError& error) {
    message_->setText(
        QString::fromStdString(error.source() + ": " + error.problems().front().message()));
    message_->show();
    return false;
  }
}

}  // namespace rotorbench
