// The undo commands behind DocumentModel: each keeps the few values it changes, never the whole
// document.
#pragma once

#include <QUndoCommand>

#include "ui/forms/document_model.h"

namespace rotorbench {

/// A change and what follows from it: members whose shape depends on what was changed.
class EditCommand : public QUndoCommand {
 public:
  void redo() final;
  void undo() final;

 protected:
  EditCommand(DocumentModel& model, QString path, const QString& text);
  virtual void apply() = 0;
  virtual void revert() = 0;
  /// Something else changed with it.
  [[nodiscard]] bool hasFollowers() const { return !followed_.empty(); }

  [[nodiscard]] schema::Location location() const;
  void announceValue() { model_.announceValue(path_); }
  void announceStructure() { model_.announceStructure(path_); }
  [[nodiscard]] schema::Ref elementOf(const schema::Location& list, std::size_t index) const;
  [[nodiscard]] schema::Ref rootRef() const { return model_.mutableRoot(); }
  [[nodiscard]] const QString& path() const { return path_; }

 private:
  /// What a member held before it followed.
  struct Followed {
    QString path;
    FieldSnapshot before;
  };

  DocumentModel& model_;
  QString path_;
  std::vector<Followed> followed_;
};

class SetValue : public EditCommand {
 public:
  SetValue(DocumentModel& model, QString path, schema::Value before, schema::Value after,
           const QString& text, DocumentModel::Edit edit);
  void revert() override;
  void apply() override;
  [[nodiscard]] int id() const override;
  /// Joins repeated edits of one field; back at the first value nothing is left to undo.
  bool mergeWith(const QUndoCommand* later) override;

 private:
  void write(const schema::Value& value);

  schema::Value before_, after_;
  DocumentModel::Edit edit_;
};

class ChooseAlternative : public EditCommand {
 public:
  ChooseAlternative(DocumentModel& model, QString path, std::size_t option, const QString& text);
  void revert() override;
  void apply() override;

 private:
  std::size_t option_;
  FieldSnapshot before_;
};

class InsertElement : public EditCommand {
 public:
  /// Without `values` the element is default-made.
  InsertElement(DocumentModel& model, QString list, std::size_t index,
                std::optional<Snapshot> values, const QString& text);
  void revert() override;
  void apply() override;

 private:
  std::size_t index_;
  std::optional<Snapshot> values_;
};

class RemoveElement : public EditCommand {
 public:
  RemoveElement(DocumentModel& model, QString list, std::size_t index, const QString& text);
  void revert() override;
  void apply() override;

 private:
  std::size_t index_;
  Snapshot values_;
};

class MoveElement : public EditCommand {
 public:
  MoveElement(DocumentModel& model, QString list, std::size_t from, std::size_t to,
              const QString& text);
  void revert() override { move(to_, from_); }
  void apply() override { move(from_, to_); }

 private:
  void move(std::size_t from, std::size_t to);

  std::size_t from_, to_;
};

class ReplaceRows : public EditCommand {
 public:
  ReplaceRows(DocumentModel& model, QString list, FieldSnapshot rows, const QString& text);
  void revert() override { write(before_); }
  void apply() override { write(after_); }

 private:
  void write(const FieldSnapshot& rows);

  FieldSnapshot before_, after_;
};

class ReplaceObject : public EditCommand {
 public:
  ReplaceObject(DocumentModel& model, QString path, Snapshot values, const QString& text);
  void revert() override { write(before_); }
  void apply() override { write(after_); }

 private:
  [[nodiscard]] schema::Ref target() const;
  void write(const Snapshot& values);

  Snapshot before_, after_;
};

}  // namespace rotorbench
