// The one document the forms edit: any described struct, owned behind an erased pointer, changed
// only through one undo stack of small commands. Widgets hold no truth; they read here and listen.
// Values are SI; paths are those of sim/core/schema.h. Text that was typed but is no value is kept
// beside the document: the document keeps its last valid value and the text counts as a problem
// until it is put right.
#pragma once

#include <QMap>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim/core/schema_tree.h"
#include "ui/forms/snapshot.h"

namespace rotorbench {

/// A described object with its C++ type forgotten.
struct Document {
  std::shared_ptr<void> object;
  const schema::Type* type = nullptr;
  std::function<std::shared_ptr<void>(const void*)> copy;
};

template <class T>
Document makeDocument(T value) {
  return {
      std::make_shared<T>(std::move(value)), &schema::typeOf<T>(), [](const void* object) {
        return std::static_pointer_cast<void>(std::make_shared<T>(*static_cast<const T*>(object)));
      }};
}

/// Text typed into a field that is no valid value of it, with the sentence that says why.
struct InvalidText {
  QString text;
  QString sentence;
};

class DocumentModel : public QObject {
  Q_OBJECT

 public:
  using Validator = std::function<std::vector<Problem>(schema::ConstRef)>;
  using ValueText = std::function<QString(const schema::Field&, const schema::Value&)>;

  /// Repeated edits of one field (arrow keys, wheel, typing a paragraph) become one undo step.
  enum class Edit { Single, Repeated };

  explicit DocumentModel(Document document, QObject* parent = nullptr);
  ~DocumentModel() override;

  /// Loads another document: the undo stack starts anew and clean, typed leftovers are dropped.
  void replaceDocument(Document document);

  [[nodiscard]] schema::ConstRef root() const;
  /// The document as what it is; T must be the type it was made from.
  template <class T>
  [[nodiscard]] const T& as() const {
    Q_ASSERT(document_.type == &schema::typeOf<T>());
    return *static_cast<const T*>(document_.object.get());
  }
  /// An independent copy of the document, as given to a run or to autosave.
  [[nodiscard]] Document copy() const;
  /// A default-made document of the same type, which "changed" and "reset" refer to.
  [[nodiscard]] schema::ConstRef defaults() const;

  /// The field (or list element) at `path`; empty if the document has no such place now.
  [[nodiscard]] std::optional<schema::Location> find(const QString& path) const;
  /// The struct at `path`: the document itself (""), a group, the chosen alternative or a list
  /// element.
  [[nodiscard]] std::optional<schema::ConstRef> object(const QString& path) const;
  /// The value of the leaf at `path`, which must exist.
  [[nodiscard]] schema::Value get(const QString& path) const;

  /// Sets a leaf. Returns the problem, with the document unchanged, if the value is not allowed.
  std::optional<Problem> set(const QString& path, const schema::Value& value,
                             Edit edit = Edit::Single);
  /// Chooses another alternative of the variant at `path`; undo brings back the old one with its
  /// values.
  void choose(const QString& path, std::size_t option);

  void insertElement(const QString& list, std::size_t before);
  void duplicateElement(const QString& list, std::size_t index);
  void removeElement(const QString& list, std::size_t index);
  /// Moves one element so that it ends at index `to`.
  void moveElement(const QString& list, std::size_t from, std::size_t to);
  /// Replaces all elements of a list by `rows` as one step named `text`.
  void replaceRows(const QString& list, const FieldSnapshot& rows, const QString& text);
  /// Gives the struct at `path` the values of another of its type (a component from the library).
  void replaceObject(const QString& path, const Snapshot& values, const QString& text);

  void setInvalidText(const QString& path, const QString& text, const QString& sentence);
  void clearInvalidText(const QString& path);
  [[nodiscard]] std::optional<InvalidText> invalidText(const QString& path) const;

  /// Rules beyond the schema (a build of the simulation, a component that is not in the library).
  void setExtraValidator(Validator validator);
  /// Asks all rules again: the extra ones know something new.
  void recheck() { checkProblems(); }
  /// Everything wrong now: invalid texts first, then the schema's and the extra rules.
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  /// True if a problem that is more than a warning blocks a run.
  [[nodiscard]] bool hasErrors() const;

  /// How values are written in undo texts; an empty function stands for schema::toText.
  void setValueText(ValueText text);

  [[nodiscard]] QUndoStack* undoStack() { return &stack_; }
  [[nodiscard]] bool isClean() const { return stack_.isClean(); }
  void setClean() { stack_.setClean(); }

  /// Asks every editor to commit what is being typed; call before saving and before a run.
  void commitPendingEdits();

 signals:
  void valueChanged(const QString& path);
  /// Fields below `path` (a variant, a list or a group) may have come or gone.
  void structureChanged(const QString& path);
  void problemsChanged();
  void documentReplaced();
  void cleanChanged(bool clean);
  void commitRequested();

 private:
  friend class EditCommand;

  [[nodiscard]] schema::Ref mutableRoot() const;
  [[nodiscard]] QString elementLabel(const QString& list) const;
  void announceValue(const QString& path);
  void announceStructure(const QString& path);
  void dropInvalidBelow(const QString& path);
  void checkProblems();

  Document document_;
  std::shared_ptr<void> defaults_;
  QMap<QString, InvalidText> invalid_;
  Validator extraValidator_;
  ValueText valueText_;
  std::vector<Problem> problems_;
  QUndoStack stack_;
};

/// True if `path` is `prefix` itself or lies below it ("a.b[1].c" below "a.b" and below "").
bool isAtOrBelow(const QString& path, const QString& prefix);
/// "a" + "b" is "a.b"; "" + "b" is "b".
QString joinPath(const QString& parent, const QString& key);
QString elementPath(const QString& list, std::size_t index);

}  // namespace rotorbench
