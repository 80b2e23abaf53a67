// The undo commands behind DocumentModel: each keeps the few values it changes, never the whole
// document.
#pragma once

#include <QUndoCommand>

#include "ui/forms/document_model.h"

namespace rotorbench {

class EditCommand : public QUndoCommand {
 protected:
  EditCommand(DocumentModel& model, QString path, const QString& text);

  [[nodiscard]] schema::Location location() const;
  void announceValue() { model_.announceValue(path_); }
  void announceStructure() { model_.announceStructure(path_); }
  [[nodiscard]] schema::Ref elementOf(const schema::Location& list, std::size_t index) const;
  [[nodiscard]] schema::Ref rootRef() const { return model_.mutableRoot(); }
  [[nodiscard]] const QString& path() const { return path_; }

 private:
  DocumentModel& model_;
  QString path_;
};

class SetValue : public EditCommand {
 public:
  SetValue(DocumentModel& model, QString path, schema::Value before, schema::Value after,
           const QString& text, DocumentModel::Edit edit);
  void undo() override;
  void redo() override;
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
  void undo() override;
  void redo() override;

 private:
  std::size_t option_;
  FieldSnapshot before_;
};

class InsertElement : public EditCommand {
 public:
  /// Without `values` the element is default-made.
  InsertElement(DocumentModel& model, QString list, std::size_t index,
                std::optional<Snapshot> values, const QString& text);
  void undo() override;
  void redo() override;

 private:
  std::size_t index_;
  std::optional<Snapshot> values_;
};

class RemoveElement : public EditCommand {
 public:
  RemoveElement(DocumentModel& model, QString list, std::size_t index, const QString& text);
  void undo() override;
  void redo() override;

 private:
  std::size_t index_;
  Snapshot values_;
};

class MoveElement : public EditCommand {
 public:
  MoveElement(DocumentModel& model, QString list, std::size_t from, std::size_t to,
              const QString& text);
  void undo() override { move(to_, from_); }
  void redo() override { move(from_, to_); }

 private:
  void move(std::size_t from, std::size_t to);

  std::size_t from_, to_;
};

class ReplaceRows : public EditCommand {
 public:
  ReplaceRows(DocumentModel& model, QString list, FieldSnapshot rows, const QString& text);
  void undo() override { write(before_); }
  void redo() override { write(after_); }

 private:
  void write(const FieldSnapshot& rows);

  FieldSnapshot before_, after_;
};

class ReplaceObject : public EditCommand {
 public:
  ReplaceObject(DocumentModel& model, QString path, Snapshot values, const QString& text);
  void undo() override { write(before_); }
  void redo() override { write(after_); }

 private:
  [[nodiscard]] schema::Ref target() const;
  void write(const Snapshot& values);

  Snapshot before_, after_;
};

}  // namespace rotorbench
