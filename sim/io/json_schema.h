// JSON Schema (draft 2020-12) of a described struct, for editors and independent validators.
#pragma once

#include <string>

#include "sim/core/schema.h"
#include "sim/io/json_document.h"

namespace rotorbench {

/// The schema of the files writeDocument() makes and readDocument() takes: units and help in
/// "description", ranges, choices, variants as "oneOf" with a constant "type", no unknown keys.
/// Quantities are numbers in SI or strings of one number and a unit (readDocument also computes
/// "1/2 in"; rules over several members are not expressed). Pretty-printed, newline at the end.
std::string jsonSchema(const schema::Type& type, const DocumentFormat& format = {});

}  // namespace rotorbench
