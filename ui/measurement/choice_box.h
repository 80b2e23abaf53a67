// Boxes for the described choices of an import: the options in their order, their keys as data.
#pragma once

#include <QComboBox>
#include <string>
#include <string_view>
#include <variant>

#include "sim/core/schema.h"
#include "ui/forms/field_text.h"

namespace rotorbench {

inline QComboBox* choiceBox(const schema::Type& type, std::string_view field, const char* name) {
  auto* box = new QComboBox;
  box->setObjectName(name);
  for (const schema::Option& option : type.field(field)->options) {
    box->addItem(toQString(option.label), toQString(option.key));
  }
  box->setAccessibleName(toQString(type.field(field)->label));
  return box;
}

/// Shows what the owner holds.
template <class Owner>
void showChoice(const Owner& owner, std::string_view field, QComboBox& box) {
  const schema::Value value = schema::typeOf<Owner>().field(field)->read(&owner);
  box.setCurrentIndex(box.findData(toQString(std::get<std::string>(value))));
}

/// Puts what is shown into the owner.
template <class Owner>
void takeChoice(Owner& owner, std::string_view field, const QComboBox& box) {
  schema::typeOf<Owner>().field(field)->write(&owner, box.currentData().toString().toStdString());
}

}  // namespace rotorbench
