// list: the shipped experiments, or the components of the library, with their files.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "app/rotorbench-cli/commands.h"
#include "sim/core/schema_tree.h"
#include "sim/document/resources.h"
#include "sim/library/component_library.h"

namespace rotorbench::cli {

namespace {

struct ListOptions {
  std::string what = "experiments", kind;
};

/// Where the window keeps the user's components: the XDG Base Directory Specification's data home.
std::filesystem::path ownLibraryDirectory() {
  const char* data = std::getenv("XDG_DATA_HOME");
  const char* home = std::getenv("HOME");
  const std::filesystem::path base = data != nullptr && *data != '\0' ? std::filesystem::path(data)
                                     : home != nullptr
                                         ? std::filesystem::path(home) / ".local" / "share"
                                         : std::filesystem::path();
  return base.empty() ? base : base / "Rotorbench" / "Rotorbench" / "library";
}

void listExperiments() {
  std::vector<InputError> faults;
  for (const auto& e : shippedExperiments(&faults)) {
    std::cout << e.name << "\n    " << e.title << ": " << e.summary << "\n    " << e.file.string()
              << '\n';
  }
  for (const auto& fault : faults) std::cerr << fault.what() << '\n';
}

const ComponentKind* kindAskedFor(const std::string& key) {
  if (key.empty()) return nullptr;
  if (const ComponentKind* kind = kindOf(key)) return kind;
  std::vector<schema::Option> options;
  for (const auto& kind : componentKinds()) options.push_back({kind.key, kind.label, {}});
  throw InputError("--kind",
                   {{{}, "there is no kind " + key, schema::allowedOptions(options, key)}});
}

void listComponents(const ComponentKind* only) {
  const ComponentLibrary library(shippedLibraryDirectory(), ownLibraryDirectory());
  for (const auto& entry : library.entries()) {
    const ComponentKind& kind = *kindOf(*entry.component.type);
    if (only != nullptr && only != &kind) continue;
    const ComponentInfo& info = entry.component.info;
    std::cout << kind.key << ": " << info.name << (entry.own ? " (yours)" : "") << "\n    "
              << info.summary << '\n';
    if (!info.warning.empty()) std::cout << "    Note: " << info.warning << '\n';
    std::cout << "    " << entry.file.string() << '\n';
  }
  for (const auto& fault : library.faults()) {
    std::cerr << fault.file.string() << ": " << fault.sentence << '\n';
  }
}

}  // namespace

void addListCommand(CLI::App& app, int& code) {
  auto options = std::make_shared<ListOptions>();
  auto* list =
      app.add_subcommand("list", "List the shipped experiments or the library's components");
  list->add_option("WHAT", options->what, "experiments (default) or components")
      ->check(CLI::IsMember({"experiments", "components"}));
  list->add_option("--kind", options->kind, "Only components of this kind, for example motor");
  list->callback([options, &code] {
    const ComponentKind* kind = kindAskedFor(options->kind);
    if (options->what == "components" || kind != nullptr) {
      listComponents(kind);
    } else {
      listExperiments();
    }
    code = kOk;
  });
}

}  // namespace rotorbench::cli
