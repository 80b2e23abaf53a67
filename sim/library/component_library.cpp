#include "sim/library/component_library.h"

#include <algorithm>
#include <tuple>

#include "sim/document/resources.h"
#include "sim/io/file.h"
#include "sim/library/component_file.h"

namespace rotorbench {

namespace fs = std::filesystem;

namespace {

/// A file name of small letters, digits and dashes that reads like the name.
std::string fileStem(std::string_view name) {
  std::string stem;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    const bool capital = c >= 'A' && c <= 'Z';
    if (letter || capital) {
      stem += static_cast<char>(capital ? c - 'A' + 'a' : c);
    } else if (!stem.empty() && stem.back() != '-') {
      stem += '-';
    }
  }
  while (!stem.empty() && stem.back() == '-') stem.pop_back();
  constexpr std::size_t kLongest = 80;
  return stem.empty() ? "component" : stem.substr(0, kLongest);
}

fs::path freeFile(const fs::path& folder, const std::string& stem) {
  std::error_code error;
  fs::path file = folder / (stem + std::string(kComponentSuffix));
  for (int number = 2; fs::exists(file, error); ++number) {
    file = folder / (stem + "-" + std::to_string(number) + std::string(kComponentSuffix));
  }
  return file;
}

/// The first problem, without the path of the file, which is told beside it.
std::string sentenceOf(const InputError& error) {
  return error.problems().empty() ? error.what() : error.problems().front().message();
}

const ComponentKind& kindOrThrow(const Component& component) {
  const ComponentKind* kind = component.type == nullptr ? nullptr : kindOf(*component.type);
  if (kind == nullptr) {
    throw InputError(component.info.name, {{{}, "this is no kind of component", {}}});
  }
  return *kind;
}

}  // namespace

fs::path shippedLibraryDirectory() {
  return resourceDirectory() / "library";
}

ComponentLibrary::ComponentLibrary(fs::path shippedFolder, fs::path ownFolder)
    : shipped_(std::move(shippedFolder)), own_(std::move(ownFolder)) {
  reload();
}

void ComponentLibrary::reload() {
  entries_.clear();
  faults_.clear();
  for (const ComponentKind& kind : componentKinds()) {
    const auto first = static_cast<std::ptrdiff_t>(entries_.size());
    readFolder(kind, own_, true);
    readFolder(kind, shipped_, false);
    std::sort(entries_.begin() + first, entries_.end(), [](const auto& a, const auto& b) {
      return std::tie(b.own, a.component.info.name) < std::tie(a.own, b.component.info.name);
    });
  }
}

void ComponentLibrary::readFolder(const ComponentKind& kind, const fs::path& root, bool own) {
  std::error_code error;
  for (const auto& file : fs::directory_iterator(root / kind.folder, error)) {
    if (file.path().extension() != kComponentSuffix) continue;
    try {
      Component component = loadComponent(file.path());
      if (component.type != kind.type) {
        faults_.push_back({file.path(), "a " + kindOf(*component.type)->key +
                                            " does not belong into the folder " + kind.folder});
        continue;
      }
      entries_.push_back({std::move(component), file.path(), own});
    } catch (const InputError& fault) {
      faults_.push_back({file.path(), sentenceOf(fault)});
    }
  }
}

std::vector<const LibraryEntry*> ComponentLibrary::list(const ComponentKind& kind) const {
  std::vector<const LibraryEntry*> found;
  for (const auto& entry : entries_) {
    if (entry.component.type == kind.type) found.push_back(&entry);
  }
  return found;
}

const LibraryEntry* ComponentLibrary::find(const ComponentKind& kind, std::string_view name) const {
  const auto found = std::ranges::find_if(entries_, [&](const LibraryEntry& entry) {
    return entry.component.type == kind.type && entry.component.info.name == name;
  });
  return found == entries_.end() ? nullptr : &*found;
}

std::string ComponentLibrary::freeName(const ComponentKind& kind, std::string_view wanted) const {
  std::string name(wanted);
  for (int number = 2; find(kind, name) != nullptr; ++number) {
    name = std::string(wanted) + " " + std::to_string(number);
  }
  return name;
}

const LibraryEntry& ComponentLibrary::save(const Component& component) {
  const ComponentKind& kind = kindOrThrow(component);
  const std::string& name = component.info.name;
  if (find(kind, name) != nullptr) {
    throw InputError(name, {{"name", "the library already has a component of this name",
                             "another name, for example " + freeName(kind, name)}});
  }
  return write(component, freeFile(own_ / kind.folder, fileStem(name)));
}

const LibraryEntry& ComponentLibrary::replace(const LibraryEntry& entry,
                                              const Component& component) {
  const std::string& name = component.info.name;
  if (!entry.own || entry.component.type != component.type) {
    throw InputError(name, {{{}, "this component cannot be replaced", "an own one of its kind"}});
  }
  const LibraryEntry* named = find(kindOrThrow(component), name);
  if (named != nullptr && named != &entry) {
    throw InputError(
        name, {{"name", "the library already has a component of this name", "another name"}});
  }
  return write(component, fs::path(entry.file));
}

const LibraryEntry& ComponentLibrary::write(const Component& component, const fs::path& file) {
  const std::string text = writeComponent(component);
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  writeFileAtomically(file, text);
  reload();
  const auto found = std::ranges::find(entries_, file, &LibraryEntry::file);
  if (found == entries_.end()) {
    throw InputError(file.string(), {{{}, "the file cannot be read back", {}}});
  }
  return *found;
}

void ComponentLibrary::remove(const LibraryEntry& entry) {
  const fs::path file = entry.file;
  std::error_code error;
  if (!entry.own) {
    throw InputError(file.string(), {{{}, "shipped components cannot be deleted", "an own one"}});
  }
  if (!fs::remove(file, error) && error) {
    throw InputError(file.string(), {{{}, "the file cannot be deleted: " + error.message(), {}}});
  }
  reload();
}

}  // namespace rotorbench
