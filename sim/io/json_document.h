// Described structs as JSON files. Values are SI numbers or, on reading, strings with a unit ("9.45
// in"); variants are objects with "type"; missing keys take their defaults.
#pragma once

#include <string>
#include <string_view>

#include "sim/core/schema.h"

namespace rotorbench {

/// The root key that names the kind of file; its value is the version of the format.
struct DocumentFormat {
  std::string key = "rotorbench";
  int oldest = 1;  ///< versions this program reads
  int newest = 1;  ///< version it writes
};

/// The whole document, all members in order of their description, numbers in shortest exact form,
/// with a newline at the end. Throws InputError if it holds a number that is not finite (JSON
/// cannot).
std::string writeDocument(schema::ConstRef root, const DocumentFormat& format = {});

/// Replaces `target` by what `text` says. Throws InputError with every violation; the target is
/// then as it was. `source` names the file in messages.
void readDocument(schema::Ref target, std::string_view text, const std::string& source,
                  const DocumentFormat& format = {});

}  // namespace rotorbench
