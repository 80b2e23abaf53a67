#include "ui/forms/sections.h"

#include <QStringList>

#include "ui/forms/document_model.h"
#include "ui/forms/field_text.h"

namespace rotorbench {

using schema::Kind;

namespace {

/// Larger groups would push their neighbours out of the form.
constexpr std::size_t kLargestInline = 8;

bool holdsList(schema::ConstRef object) {
  for (const auto& field : object.type->fields) {
    if (field.kind == Kind::List) return true;
    if (field.isLeaf()) continue;
    if (holdsList({&field.childType(object.object, 0), field.constChild(object.object, 0)}))
      return true;
  }
  return false;
}

void visitFields(schema::ConstRef object, const QString& path,
                 const std::function<void(const QString&, const QString&)>& visit) {
  for (const auto& field : object.type->fields) {
    if (field.isLeaf()) continue;
    const QString fieldPath = joinPath(path, toQString(field.key));
    if (!isInline(field, object.object)) {
      visit(fieldPath, toQString(field.label));
    } else if (field.kind != Kind::List) {
      visitFields({&field.childType(object.object, 0), field.constChild(object.object, 0)},
                  fieldPath, visit);
    }
  }
}

}  // namespace

std::size_t countLeaves(schema::ConstRef object) {
  std::size_t leaves = 0;
  for (const auto& field : object.type->fields) {
    if (field.isLeaf() || field.kind == Kind::List) {
      leaves += field.advanced ? 0 : 1;
    } else {
      leaves +=
          countLeaves({&field.childType(object.object, 0), field.constChild(object.object, 0)});
    }
  }
  return leaves;
}

bool isInline(const schema::Field& field, const void* owner) {
  if (field.isLeaf()) return true;
  if (field.kind == Kind::List) return field.asTable;
  const schema::ConstRef child(&field.childType(owner, 0), field.constChild(owner, 0));
  return !holdsList(child) && countLeaves(child) <= kLargestInline;
}

QString sectionOf(schema::ConstRef root, const QString& path) {
  QString section, walked;
  schema::ConstRef object = root;
  for (const QString& segment : path.split(QLatin1Char('.'), Qt::SkipEmptyParts)) {
    const qsizetype bracket = segment.indexOf(QLatin1Char('['));
    const QString key = bracket < 0 ? segment : segment.left(bracket);
    const schema::Field* field = object.type->field(key.toStdString());
    if (field == nullptr || field->isLeaf()) return section;
    walked = joinPath(walked, key);
    if (!isInline(*field, object.object)) section = walked;
    std::size_t index = 0;
    if (field->kind == Kind::List) {
      if (bracket < 0 || field->asTable) return section;
      index = segment.mid(bracket + 1, segment.size() - bracket - 2).toULongLong();
      if (index >= field->count(object.object)) return section;
      section = walked = elementPath(walked, index);
    }
    object = {&field->childType(object.object, index), field->constChild(object.object, index)};
  }
  return section;
}

void forEachSubsection(
    schema::ConstRef root, const QString& path,
    const std::function<void(const QString& path, const QString& title)>& visit) {
  if (path.isEmpty()) {
    visitFields(root, path, visit);
    return;
  }
  schema::Location at;
  try {
    at = schema::locate({root.type, const_cast<void*>(root.object)}, path.toStdString());
  } catch (const InputError&) {
    return;
  }
  if (at.field->kind == Kind::List && !at.element) {
    for (std::size_t i = 0; i < at.field->count(at.owner); ++i) {
      visit(elementPath(path, i), elementTitle(*at.field, at.owner, i));
    }
    return;
  }
  const std::size_t index = at.element.value_or(0);
  visitFields({&at.field->childType(at.owner, index), at.field->constChild(at.owner, index)}, path,
              visit);
}

}  // namespace rotorbench
