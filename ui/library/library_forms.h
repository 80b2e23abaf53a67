// Brings the component library into the forms: a button beside each part that has components.
#pragma once

namespace rotorbench {

class DocumentModel;
class ExperimentPanel;

/// The panel must show `model`; both must outlive the dialogs, which are children of the panel's window.
void connectLibrary(ExperimentPanel& panel, DocumentModel& model);

}  // namespace rotorbench
