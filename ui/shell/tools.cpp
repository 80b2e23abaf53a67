#include "ui/shell/tools.h"

#include <QCoreApplication>
#include <QObject>

#include "ui/library/library_dialog.h"
#include "ui/measurement/fit_dialog.h"
#include "ui/measurement/import_dialog.h"
#include "ui/measurement/residuals_dialog.h"
#include "ui/propeller/propeller_editor.h"
#include "ui/shell/document_controller.h"
#include "ui/sizing/data_sheet_dialog.h"
#include "ui/sizing/performance_dialog.h"

namespace rotorbench {

namespace {

void openLibrary(const ToolContext& context) {
  (new LibraryDialog(browseRequest(), context.window))->open();
}

/// The propeller of the open experiment, or one of its own where there is none.
void openPropellerEditor(const ToolContext& context) {
  DocumentModel* model = &context.documents.model();
  DocumentModel* own = nullptr;
  if (propellersOf(model->root()).isEmpty()) {
    model = own = new DocumentModel(makeDocument(PropellerGeometry{}));
    context.say(QCoreApplication::translate(
        "Tools", "The open experiment has no propeller with a geometry; this one is by itself."));
  }
  auto* editor = new PropellerEditor(*model, context.window);
  if (own != nullptr) QObject::connect(editor, &QObject::destroyed, own, &QObject::deleteLater);
  editor->show();
}

void openDataSheet(const ToolContext& context) {
  auto* dialog = new DataSheetDialog(context.documents.model(), context.window);
  QObject::connect(dialog, &DataSheetDialog::applied, context.window, context.say);
  dialog->show();
}

void openPerformance(const ToolContext& context) {
  (new PerformanceDialog(context.documents.model(), context.window))->show();
}

void openImport(const ToolContext& context) {
  auto* dialog = new ImportDialog(context.runs, context.window);
  QObject::connect(dialog, &ImportDialog::imported, context.window, context.say);
  dialog->open();
}

void openFit(const ToolContext& context) {
  auto* dialog = new FitDialog(context.documents.model(), context.runs, context.window);
  QObject::connect(dialog, &FitDialog::reported, context.window, context.say);
  dialog->show();
}

void openResiduals(const ToolContext& context) {
  (new ResidualsDialog(context.runs, context.window))->open();
}

}  // namespace

const std::vector<Tool>& tools() {
  static const std::vector<Tool> kTools{
      {"toolLibrary", "Component &library…", "folder-open",
       "Motors, propellers, batteries, airframes: shipped ones and yours", "library", openLibrary},
      {"toolPropellerEditor", "&Propeller editor…", "draw-bezier-curves",
       "Chord, twist and sections of a blade on a chart, with its coefficients live",
       "propeller-editor", openPropellerEditor},
      {"toolDataSheet", "Motor from a &data sheet…", "accessories-calculator",
       "What follows from the data sheets of a motor, a propeller and a battery", "data-sheet",
       openDataSheet},
      {"toolPerformance", "&Performance of the vehicle…", "view-statistics",
       "What the vehicle lifts, how long and how fast it flies, and what limits it", "performance",
       openPerformance},
      {"toolImport", "&Import measured data…", "document-import",
       "Adds the log of a stand or a tunnel to the charts", "measured-data", openImport},
      {"toolFit", "&Fit to measurement…", "office-chart-line",
       "Finds motor, propeller or rotor constants from measured data, with intervals",
       "measured-data", openFit},
      {"toolResiduals", "Compare with &measurement…", "view-statistics",
       "Shows how far a run is from measured data", "measured-data", openResiduals},
  };
  return kTools;
}

}  // namespace rotorbench
