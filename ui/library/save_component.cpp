#include "ui/library/save_component.h"

#include "ui/forms/field_text.h"
#include "ui/library/component_info_dialog.h"
#include "ui/library/library_dialog.h"

namespace rotorbench {

void askToSaveComponent(const Component& component, QWidget* owner,
                        const std::function<void(const QString&)>& done) {
  const ComponentLibrary library(shippedLibraryDirectory(), ownLibraryDirectory());
  const ComponentKind& kind = *kindOf(*component.type);
  ComponentInfo info = component.info;
  if (info.name.empty())
    info.name = LibraryDialog::tr("My %1").arg(toQString(kind.label)).toStdString();
  info.name = library.freeName(kind, info.name);
  const auto save = [component, done](const ComponentInfo& given) -> QString {
    try {
      ComponentLibrary now(shippedLibraryDirectory(), ownLibraryDirectory());
      now.save({given, component.type, component.value});
    } catch (const InputError& error) {
      return QString::fromStdString(error.problems().front().message());
    }
    done(LibraryDialog::tr("“%1” is in the component library.").arg(toQString(given.name)));
    return {};
  };
  (new ComponentInfoDialog(LibraryDialog::tr("Save as component"), info, save, owner))->open();
}

}  // namespace rotorbench
