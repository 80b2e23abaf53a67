#include "ui/library/library_forms.h"

#include <memory>

#include "ui/forms/experiment_panel.h"
#include "ui/library/component_place.h"
#include "ui/library/library_dialog.h"

namespace rotorbench {

ComponentHooks componentHooks(DocumentModel& model, QWidget& owner) {
  return {[&model](const QString& path) { return !ComponentPlace(model, path).kinds().empty(); },
          [&model, &owner](const QString& path) {
            model.commitPendingEdits();
            const auto place = std::make_shared<ComponentPlace>(model, path);
            LibraryRequest request;
            request.title = place->label();
            request.kinds = place->kinds();
            request.current = [place] { return place->current(); };
            request.use = [place](const Component& component) { place->use(component); };
            (new LibraryDialog(std::move(request), owner.window()))->open();
          }};
}

void connectLibrary(ExperimentPanel& panel, DocumentModel& model) {
  ComponentHooks hooks = componentHooks(model, panel);
  panel.setComponents(std::move(hooks.has), std::move(hooks.pick));
}

}  // namespace rotorbench
