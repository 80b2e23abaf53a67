#include "ui/shell/tools.h"

#include "ui/propeller/propeller_editor.h"
#include "ui/shell/document_controller.h"

namespace rotorbench {

namespace {

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

}  // namespace

const std::vector<Tool>& tools() {
  static const std::vector<Tool> kTools{
      {"toolPropellerEditor", "&Propeller editor…", "draw-bezier-curves",
       "Chord, twist and sections of a blade on a chart, with its coefficients live",
       openPropellerEditor},
  };
  return kTools;
}

}  // namespace rotorbench
