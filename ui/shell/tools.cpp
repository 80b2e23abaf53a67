#include "ui/shell/tools.h"

#include "ui/measurement/import_dialog.h"
#include "ui/measurement/residuals_dialog.h"

namespace rotorbench {

namespace {

void openImport(const ToolContext& context) {
  auto* dialog = new ImportDialog(context.runs, context.window);
  QObject::connect(dialog, &ImportDialog::imported, context.window, context.say);
  dialog->open();
}

void openResiduals(const ToolContext& context) {
  (new ResidualsDialog(context.runs, context.window))->open();
}

}  // namespace

const std::vector<Tool>& tools() {
  static const std::vector<Tool> kTools{
      {"toolImport", "&Import measured data…", "document-import",
       "Adds the log of a stand or a tunnel to the charts", openImport},
      {"toolResiduals", "Compare with &measurement…", "view-statistics",
       "Shows how far a run is from measured data", openResiduals},
  };
  return kTools;
}

}  // namespace rotorbench
