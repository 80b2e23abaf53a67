// Import settings kept for the next file with the same columns.
#pragma once

#include <optional>

#include "sim/logs/import_settings.h"

namespace rotorbench {

/// What was last chosen for a table with these columns, if anything that can still be read.
std::optional<ImportSettings> rememberedSettings(const CsvPreview& preview);
void rememberSettings(const CsvPreview& preview, const ImportSettings& settings);

}  // namespace rotorbench
