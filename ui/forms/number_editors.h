// Editors of numbers: one line for Number and Integer, one line per component for Vector.
#pragma once

#include <vector>

#include "ui/forms/field_editor.h"
#include "ui/forms/quantity_edit.h"
#include "ui/forms/unit_button.h"

namespace rotorbench {

class NumberEditor : public FieldEditor {
  Q_OBJECT

 public:
  NumberEditor(const FormContext& context, const schema::Field& field, const QString& path,
               QWidget* parent);
  void refresh() override;
  void commit() override { edit_->commit(); }
  void unitsChanged() override;
  [[nodiscard]] QWidget* unitWidget() override { return unit_; }
  [[nodiscard]] QWidget* inputWidget() override { return edit_; }

 private:
  QuantityEdit* edit_;
  UnitButton* unit_ = nullptr;
};

class VectorEditor : public FieldEditor {
  Q_OBJECT

 public:
  VectorEditor(const FormContext& context, const schema::Field& field, const QString& path,
               QWidget* parent);
  void refresh() override;
  void commit() override;
  void unitsChanged() override;
  [[nodiscard]] bool isWide() const override { return true; }
  [[nodiscard]] QWidget* unitWidget() override { return unit_; }
  [[nodiscard]] QWidget* inputWidget() override { return edits_.front(); }
  [[nodiscard]] QWidget* inputFor(const QString& place) override;

 private:
  void addComponent(std::size_t index);
  void store(std::size_t index, double value, bool repeated);
  [[nodiscard]] QString componentPath(std::size_t index) const;

  std::vector<QuantityEdit*> edits_;
  UnitButton* unit_;
};

}  // namespace rotorbench
