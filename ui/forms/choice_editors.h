// Editors that pick: a check box for Boolean, combo boxes for Choice and for the alternative of a
// variant (whose fields the form shows below), and the link to a part that has a section of its
// own.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

#include "ui/forms/field_editor.h"

namespace rotorbench {

/// A combo box with one item per option, its help as tool tip; the wheel changes it only with the
/// focus.
QComboBox* makeOptionBox(const schema::Field& field, QWidget* parent);

class BooleanEditor : public FieldEditor {
  Q_OBJECT

 public:
  BooleanEditor(const FormContext& context, const schema::Field& field, const QString& path,
                QWidget* parent);
  void refresh() override;
  void labelClicked() override;
  [[nodiscard]] QWidget* inputWidget() override { return box_; }

 private:
  QCheckBox* box_;
};

class ChoiceEditor : public FieldEditor {
  Q_OBJECT

 public:
  ChoiceEditor(const FormContext& context, const schema::Field& field, const QString& path,
               QWidget* parent);
  void refresh() override;
  [[nodiscard]] QWidget* inputWidget() override { return box_; }

 private:
  QComboBox* box_;
};

/// Chooses the alternative of a variant.
class VariantEditor : public FieldEditor {
  Q_OBJECT

 public:
  VariantEditor(const FormContext& context, const schema::Field& field, const QString& path,
                QWidget* parent);
  void refresh() override;
  [[nodiscard]] QWidget* inputWidget() override { return box_; }

 private:
  QComboBox* box_;
};

/// Says in few words what is there ("4 items", the chosen alternative) and opens it.
class LinkEditor : public FieldEditor {
  Q_OBJECT

 public:
  LinkEditor(const FormContext& context, const schema::Field& field, const QString& path,
             QWidget* parent);
  void refresh() override;
  [[nodiscard]] QWidget* inputWidget() override { return button_; }

 private:
  QPushButton* button_;
};

}  // namespace rotorbench
