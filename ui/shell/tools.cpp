#include "ui/shell/tools.h"

#include <QObject>

#include "ui/shell/document_controller.h"
#include "ui/sizing/data_sheet_dialog.h"
#include "ui/sizing/performance_dialog.h"

namespace rotorbench {

namespace {

void openDataSheet(const ToolContext& context) {
  auto* dialog = new DataSheetDialog(context.documents.model(), context.window);
  QObject::connect(dialog, &DataSheetDialog::applied, context.window, context.say);
  dialog->show();
}

void openPerformance(const ToolContext& context) {
  (new PerformanceDialog(context.documents.model(), context.window))->show();
}

}  // namespace

const std::vector<Tool>& tools() {
  static const std::vector<Tool> kTools{
      {"toolDataSheet", "Motor from a &data sheet…", "accessories-calculator",
       "What follows from the data sheets of a motor, a propeller and a battery", openDataSheet},
      {"toolPerformance", "&Performance of the vehicle…", "view-statistics",
       "What the vehicle lifts, how long and how fast it flies, and what limits it",
       openPerformance},
  };
  return kTools;
}

}  // namespace rotorbench
