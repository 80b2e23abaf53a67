// The library: the components shipped with the program and those the user saved, one file each, in
// folders named after their kind. A file that cannot be read is reported and hides no other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/library/component.h"

namespace rotorbench {

struct LibraryEntry {
  Component component;
  std::filesystem::path file;
  bool own = false;  ///< saved by the user; shipped ones are never changed
};

/// A file of the library that could not be read, with the sentence that says why.
struct LibraryFault {
  std::filesystem::path file;
  std::string sentence;
};

/// The folder of the shipped components: "library" in resourceDirectory().
std::filesystem::path shippedLibraryDirectory();

class ComponentLibrary {
 public:
  /// Reads all components. A folder that does not exist holds none; the own one is made on the
  /// first save.
  ComponentLibrary(std::filesystem::path shippedFolder, std::filesystem::path ownFolder);

  /// Reads the files again; entries got before are no longer valid.
  void reload();

  /// All components: kinds in their order, own ones first, by name.
  [[nodiscard]] const std::vector<LibraryEntry>& entries() const { return entries_; }
  [[nodiscard]] std::vector<const LibraryEntry*> list(const ComponentKind& kind) const;
  /// By name; the own one if a shipped one is called the same. Null if there is none.
  [[nodiscard]] const LibraryEntry* find(const ComponentKind& kind, std::string_view name) const;
  [[nodiscard]] const std::vector<LibraryFault>& faults() const { return faults_; }
  [[nodiscard]] const std::filesystem::path& ownFolder() const { return own_; }

  /// `wanted`, or "wanted 2", "wanted 3" ... if a component of this kind has that name.
  [[nodiscard]] std::string freeName(const ComponentKind& kind, std::string_view wanted) const;

  /// Saves to the user's folder and returns the new entry. Throws InputError, with nothing changed,
  /// if a component of the kind has this name already, the component is not valid, or the file
  /// cannot be written. Entries got before are no longer valid.
  const LibraryEntry& save(const Component& component);
  /// Puts a component of the same kind in place of an own one, perhaps under another name. Throws
  /// as save().
  const LibraryEntry& replace(const LibraryEntry& entry, const Component& component);
  /// Deletes the file of an own component. Throws InputError for a shipped one or if the file
  /// cannot be deleted.
  void remove(const LibraryEntry& entry);

 private:
  void readFolder(const ComponentKind& kind, const std::filesystem::path& root, bool own);
  const LibraryEntry& write(const Component& component, const std::filesystem::path& file);

  std::filesystem::path shipped_, own_;
  std::vector<LibraryEntry> entries_;
  std::vector<LibraryFault> faults_;
};

}  // namespace rotorbench
