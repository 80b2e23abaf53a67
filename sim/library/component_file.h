// Component files: JSON with the key "rotorbench-component", the kind, what a person reads, and the
// value as in an experiment file. Read with every violation reported at once.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/library/component.h"

namespace rotorbench {

/// Ending of component files, with the dot.
inline constexpr std::string_view kComponentSuffix = ".json";

/// The text of a component file; reads back equal. Throws InputError if the component has no name,
/// its value breaks its schema, or its type is no kind of component.
std::string writeComponent(const Component& component);

/// `source` names the file in messages. Throws InputError with every problem, its place and what is
/// allowed.
Component readComponent(std::string_view text, const std::string& source);

/// Throws InputError.
Component loadComponent(const std::filesystem::path& file);

}  // namespace rotorbench
