// A place of a document where components of the library fit: a struct that is a kind of component
// itself, or a variant with alternatives that are one or hold one. Choosing a component fills the
// place as one undo step.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "sim/library/component.h"
#include "ui/forms/document_model.h"

namespace rotorbench {

class ComponentPlace {
 public:
  /// The place at `path` of the document. It fits nothing if there is no such place.
  ComponentPlace(DocumentModel& model, QString path);

  /// The kinds that fit, without repetition; empty if none do.
  [[nodiscard]] std::vector<const ComponentKind*> kinds() const;
  /// The struct at the place now that could be saved as a component.
  [[nodiscard]] std::optional<schema::ConstRef> current() const;
  /// What the place is called: "Motor".
  [[nodiscard]] QString label() const;
  /// Fills the place; true if the component fits.
  bool use(const Component& component);

 private:
  /// One way in: the alternative to choose, and the member of it that is the component itself.
  struct Way {
    const ComponentKind* kind;
    std::optional<std::size_t> option;
    const schema::Field* member = nullptr;  ///< null: the struct itself
  };

  void findWays();
  void addWays(const schema::Type& type, std::optional<std::size_t> option, bool members);
  void fillVariant(const Way& way, const Component& component, const QString& text);

  DocumentModel& model_;
  QString path_;
  std::vector<Way> ways_;
};

}  // namespace rotorbench
