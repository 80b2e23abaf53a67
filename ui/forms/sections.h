// Which parts of a document get a section of their own (a tree item with a form) and which are
// small enough to stand inside their owner's form. Follows from the schema and the values alone.
#pragma once

#include <QString>
#include <functional>

#include "sim/core/schema_tree.h"

namespace rotorbench {

/// Number of fields below `object` as a form shows them at first, so without what stands behind
/// "More"; of chosen alternatives only.
std::size_t countLeaves(schema::ConstRef object);

/// True if the field is shown inside its owner's form: leaves, tables, and groups and variants that
/// are small and hold no list.
bool isInline(const schema::Field& field, const void* owner);

/// The path of the section whose form shows the place `path`; the root section is "".
QString sectionOf(schema::ConstRef root, const QString& path);

/// The sections directly below the section at `path` (an object or a list).
void forEachSubsection(schema::ConstRef root, const QString& path,
                       const std::function<void(const QString& path, const QString& title)>& visit);

}  // namespace rotorbench
