#include "ui/shell/tools.h"

#include "ui/library/library_dialog.h"

namespace rotorbench {

namespace {

void openLibrary(const ToolContext& context) {
  (new LibraryDialog(browseRequest(), context.window))->open();
}

}  // namespace

const std::vector<Tool>& tools() {
  static const std::vector<Tool> kTools{
      {"toolLibrary", "Component &library…", "folder-open",
       "Motors, propellers, batteries, airframes: shipped ones and yours", openLibrary},
  };
  return kTools;
}

}  // namespace rotorbench
