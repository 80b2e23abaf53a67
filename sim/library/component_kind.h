// How one line makes a kind of component: the struct of a whole component file with its
// description, and its reading and writing through the documents of sim/io. For component.cpp;
// everyone else includes component.h.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/io/json_document.h"
#include "sim/library/component.h"

namespace rotorbench {

inline DocumentFormat componentFormat() {
  return {.key = "rotorbench-component", .oldest = 1, .newest = 1};
}

/// The whole file of a component of one kind.
template <class T>
struct ComponentFile : ComponentInfo {
  std::string kind;
  T value;
};

/// The members of ComponentInfo, for itself and for structs that begin with it.
template <class F>
void addInfoFields(schema::Builder<F>& b) {
  b.text("name", &F::name, "Name").help("Two components of one kind have different names.");
  b.text("summary", &F::summary, "Summary").role(schema::TextRole::Paragraph);
  b.text("source", &F::source, "Source")
      .role(schema::TextRole::Paragraph)
      .help("Where the numbers are from, and how they were got from there.");
  b.text("warning", &F::warning, "Warning")
      .role(schema::TextRole::Paragraph)
      .help("What must be known before use; empty if nothing.");
  b.check([](const F& f, std::vector<Problem>& problems) {
    if (f.name.find_first_not_of(" \t\n") == std::string::npos)
      problems.push_back({"name", "the component has no name", "any text"});
  });
}

template <class T>
struct Describe<ComponentFile<T>> {
  static void fields(schema::Builder<ComponentFile<T>>& b) {
    using F = ComponentFile<T>;
    b.title("component", "Component", "A component of the library.");
    b.text("kind", &F::kind, "Kind");
    addInfoFields(b);
    b.group("value", &F::value, "Values");
  }
};

template <class T>
ComponentKind makeKind(const std::string& key, std::string label, std::string folder,
                       std::vector<std::string> keyFigures) {
  ComponentKind kind{
      key, std::move(label), std::move(folder), &schema::typeOf<T>(), std::move(keyFigures), {},
      {}};
  kind.write = [key](const Component& component) {
    ComponentFile<T> file{component.info, key, *component.as<T>()};
    return writeDocument(schema::ref(std::as_const(file)), componentFormat());
  };
  kind.read = [](std::string_view text, const std::string& source) {
    ComponentFile<T> file;
    readDocument(schema::ref(file), text, source, componentFormat());
    ComponentInfo info = file;
    return makeComponent<T>(std::move(info), std::move(file.value));
  };
  return kind;
}

}  // namespace rotorbench
