// Brings the component library into the forms: a button beside each part that has components.
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace rotorbench {

class DocumentModel;
class ExperimentPanel;

/// What a form asks of the library (FormContext); `model` and `owner` outlive the form, dialogs are
/// children of the owner's window.
struct ComponentHooks {
  std::function<bool(const QString& path)> has;
  std::function<void(const QString& path)> pick;
};
ComponentHooks componentHooks(DocumentModel& model, QWidget& owner);

/// The panel must show `model`; both must outlive the dialogs, which are children of the panel's
/// window.
void connectLibrary(ExperimentPanel& panel, DocumentModel& model);

}  // namespace rotorbench
