#include "ui/library/component_place.h"

#include <algorithm>

#include "ui/forms/field_text.h"

namespace rotorbench {

using schema::Field;
using schema::Kind;

namespace {

/// Members of an unmade alternative can be looked at by their types alone.
const schema::Type& groupType(const Field& group) {
  return group.childType(nullptr, 0);
}

std::size_t indexOf(const schema::Type& type, const Field& field) {
  return static_cast<std::size_t>(&field - type.fields.data());
}

}  // namespace

ComponentPlace::ComponentPlace(DocumentModel& model, QString path)
    : model_(model), path_(std::move(path)) {
  findWays();
}

void ComponentPlace::findWays() {
  const auto at = model_.find(path_);
  if (at && at->field->kind == Kind::Variant) {
    // The alternatives of the document itself are kinds of experiment: no component stands for one.
    const bool members = path_.contains(QLatin1Char('.'));
    for (std::size_t i = 0; i < at->field->options.size(); ++i) {
      addWays(at->field->alternativeType(i), i, members);
    }
  } else if (const auto object = model_.object(path_)) {
    addWays(*object->type, std::nullopt, false);
  }
}

void ComponentPlace::addWays(const schema::Type& type, std::optional<std::size_t> option,
                             bool members) {
  if (const ComponentKind* kind = kindOf(type)) {
    ways_.push_back({kind, option, nullptr});
    return;
  }
  if (!members) return;
  for (const Field& field : type.fields) {
    if (field.kind != Kind::Group) continue;
    if (const ComponentKind* kind = kindOf(groupType(field))) {
      ways_.push_back({kind, option, &field});
    }
  }
}

std::vector<const ComponentKind*> ComponentPlace::kinds() const {
  std::vector<const ComponentKind*> found;
  for (const Way& way : ways_) {
    if (std::ranges::find(found, way.kind) == found.end()) found.push_back(way.kind);
  }
  return found;
}

std::optional<schema::ConstRef> ComponentPlace::current() const {
  const auto object = model_.object(path_);
  const auto at = model_.find(path_);
  if (!object) return std::nullopt;
  for (const Way& way : ways_) {
    if (way.option && at->field->chosen(at->owner) != *way.option) continue;
    if (way.member == nullptr) return object;
    return schema::ConstRef(&way.member->childType(object->object, 0),
                            way.member->constChild(object->object, 0));
  }
  return std::nullopt;
}

QString ComponentPlace::label() const {
  const auto at = model_.find(path_);
  if (at && !at->element) return toQString(at->field->label);
  const auto object = model_.object(path_);
  return object ? toQString(object->type->label) : QString();
}

bool ComponentPlace::use(const Component& component) {
  // The place may have gone since it was asked for.
  ways_.clear();
  findWays();
  const auto fits = [&](const Way& w) { return w.kind->type == component.type; };
  // Where several alternatives take it, the chosen one is meant.
  const auto at = model_.find(path_);
  const auto chosen = [&](const Way& w) {
    return fits(w) && w.option && at->field->chosen(at->owner) == *w.option;
  };
  auto way = std::ranges::find_if(ways_, chosen);
  if (way == ways_.end()) way = std::ranges::find_if(ways_, fits);
  if (way == ways_.end()) return false;
  const QString text = DocumentModel::tr("Use %1").arg(toQString(component.info.name));
  if (way->option) {
    fillVariant(*way, component, text);
  } else {
    model_.replaceObject(path_, capture(component.ref()), text);
  }
  return true;
}

void ComponentPlace::fillVariant(const Way& way, const Component& component, const QString& text) {
  const auto at = model_.find(path_);
  const QString owner = path_.left(std::max<qsizetype>(0, path_.lastIndexOf(QLatin1Char('.'))));
  const auto object = model_.object(owner);
  if (!at || !object) return;
  Snapshot values = capture(*object);
  FieldSnapshot& variant = values.fields[indexOf(*object->type, *at->field)];
  const schema::Type& type = at->field->alternativeType(*way.option);
  Snapshot part = capture(component.ref());
  if (way.member != nullptr) {
    // What else the alternative holds stays as it is, or as it is made if it is chosen only now.
    const bool chosen = variant.number == *way.option;
    const auto fresh = chosen ? nullptr : type.make();
    Snapshot whole = chosen ? variant.children.front() : capture({&type, fresh.get()});
    whole.fields[indexOf(type, *way.member)].children = {std::move(part)};
    part = std::move(whole);
  }
  variant.number = *way.option;
  variant.children = {std::move(part)};
  model_.replaceObject(owner, values, text);
}

}  // namespace rotorbench
