// Where the open experiment keeps what a fit starts from and what it finds: the first motor, the
// first propeller by its geometry, the first lumped rotor of the document.
#pragma once

#include <QString>
#include <optional>

#include "sim/fitting/fit_request.h"
#include "sim/library/component.h"
#include "ui/forms/document_model.h"

namespace rotorbench {

class FitTarget {
 public:
  explicit FitTarget(DocumentModel& experiment);

  /// Start values; those of the schema where the experiment has no such part.
  [[nodiscard]] FitStart start() const;
  /// What the fit found, as a component with this text as its source. Empty if the result is of no
  /// use.
  [[nodiscard]] std::optional<Component> component(const FitRequest& request, const FitStart& start,
                                                   const FitResult& result,
                                                   const std::string& source) const;
  /// Where such a component would go in the experiment: "Experiment kind › Drive › Motor"; empty if
  /// nowhere.
  [[nodiscard]] QString place(const FitRequest& request) const;
  /// Puts the component there as one undo step.
  void use(const FitRequest& request, const Component& component);

 private:
  [[nodiscard]] QString pathFor(const FitRequest& request) const;

  DocumentModel& experiment_;
};

}  // namespace rotorbench
