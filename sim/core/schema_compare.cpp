#include <algorithm>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"

namespace rotorbench::schema {

namespace {

using Visitor = std::function<void(const std::string&, const Field&, const void*)>;

void walkFrom(ConstRef node, const std::string& parent, const Visitor& visit) {
  for (const Field& field : node.type->fields) {
    const std::string path = joinPath(parent, field.key);
    visit(path, field, node.object);
    if (field.isLeaf()) continue;
    if (field.kind == Kind::List) {
      for (std::size_t i = 0; i < field.count(node.object); ++i) {
        walkFrom({&field.childType(node.object, i), field.constChild(node.object, i)},
                 path + "[" + std::to_string(i) + "]", visit);
      }
    } else {
      walkFrom({&field.childType(node.object, 0), field.constChild(node.object, 0)}, path, visit);
    }
  }
}

constexpr const char* kNothing = "—";

class Comparison {
 public:
  void compare(ConstRef left, ConstRef right, const std::string& parent) {
    for (const Field& field : left.type->fields) {
      compareField(field, left.object, right.object, joinPath(parent, field.key));
    }
  }

  std::vector<Difference> differences;

 private:
  static ConstRef child(const Field& field, const void* owner, std::size_t index) {
    return {&field.childType(owner, index), field.constChild(owner, index)};
  }

  void compareField(const Field& field, const void* left, const void* right,
                    const std::string& path) {
    if (field.isLeaf()) {
      compareLeaf(field, left, right, path);
    } else if (field.kind == Kind::List) {
      compareList(field, left, right, path);
    } else if (field.kind == Kind::Variant && field.chosen(left) != field.chosen(right)) {
      differences.push_back({path + ".type", field.options[field.chosen(left)].label,
                             field.options[field.chosen(right)].label});
      onlyOn(true, child(field, left, 0), path);
      onlyOn(false, child(field, right, 0), path);
    } else {
      compare(child(field, left, 0), child(field, right, 0), path);
    }
  }

  void compareLeaf(const Field& field, const void* left, const void* right,
                   const std::string& path) {
    const Value a = field.read(left);
    const Value b = field.read(right);
    if (a == b) return;
    std::string textA = toText(field, a);
    std::string textB = toText(field, b);
    if (textA == textB && std::holds_alternative<double>(a)) {  // apart by less than the unit shows
      textA = numberText(std::get<double>(a)) + " " + field.unit;
      textB = numberText(std::get<double>(b)) + " " + field.unit;
    }
    differences.push_back({path, textA, textB});
  }

  void compareList(const Field& field, const void* left, const void* right,
                   const std::string& path) {
    const std::size_t countL = field.count(left);
    const std::size_t countR = field.count(right);
    for (std::size_t i = 0; i < std::max(countL, countR); ++i) {
      const std::string element = path + "[" + std::to_string(i) + "]";
      if (i >= countR) {
        onlyOn(true, child(field, left, i), element);
      } else if (i >= countL) {
        onlyOn(false, child(field, right, i), element);
      } else {
        compare(child(field, left, i), child(field, right, i), element);
      }
    }
  }

  void onlyOn(bool leftSide, ConstRef node, const std::string& parent) {
    walkFrom(node, parent, [&](const std::string& path, const Field& field, const void* owner) {
      if (!field.isLeaf()) return;
      const std::string text = toText(field, field.read(owner));
      differences.push_back({path, leftSide ? text : kNothing, leftSide ? kNothing : text});
    });
  }
};

}  // namespace

void copy(ConstRef from, Ref to) {
  for (const Field& field : from.type->fields) {
    std::size_t count = 1;
    if (field.isLeaf()) {
      field.write(to.object, field.read(from.object));
      continue;
    }
    if (field.kind == Kind::Variant) field.choose(to.object, field.chosen(from.object));
    if (field.kind == Kind::List) {
      count = field.count(from.object);
      field.resize(to.object, count);
    }
    for (std::size_t i = 0; i < count; ++i) {
      copy({&field.childType(from.object, i), field.constChild(from.object, i)},
           {&field.childType(to.object, i), field.child(to.object, i)});
    }
  }
}

void walk(ConstRef root, const Visitor& visit) {
  walkFrom(root, {}, visit);
}

std::vector<Difference> compare(ConstRef left, ConstRef right) {
  Comparison comparison;
  comparison.compare(left, right, {});
  return std::move(comparison.differences);
}

}  // namespace rotorbench::schema
