#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"
#include "sim/io/json_document.h"

namespace rotorbench {

namespace {

using schema::ConstRef;
using schema::Field;
using schema::Kind;

class DocumentWriter {
 public:
  std::string write(ConstRef root, const DocumentFormat& format) {
    openObject(Layout::Lines);
    key(format.key);
    out_ += std::to_string(format.newest);
    members(root);
    close('}');
    out_ += '\n';
    if (!problems_.empty()) throw InputError({}, std::move(problems_));
    return std::move(out_);
  }

 private:
  enum class Layout { Lines, OneLine };
  struct Level {
    Layout layout;
    bool empty = true;
  };

  void members(ConstRef node) {
    for (const Field& field : node.type->fields) {
      key(field.key);
      const std::size_t length = path_.size();
      path_ = schema::joinPath(path_, field.key);
      member(field, node.object);
      path_.resize(length);
    }
  }

  void member(const Field& field, const void* owner) {
    if (field.isLeaf()) {
      std::visit([this](const auto& v) { value(v); }, field.read(owner));
    } else if (field.kind == Kind::List) {
      list(field, owner);
    } else {
      openObject(levels_.back().layout);
      if (field.kind == Kind::Variant) {
        key("type");
        value(field.options[field.chosen(owner)].key);
      }
      members({&field.childType(owner, 0), field.constChild(owner, 0)});
      close('}');
    }
  }

  void list(const Field& field, const void* owner) {
    open('[', levels_.back().layout);
    const Layout row = field.asTable ? Layout::OneLine : levels_.back().layout;
    for (std::size_t i = 0; i < field.count(owner); ++i) {
      next();
      const std::size_t length = path_.size();
      path_.append("[").append(std::to_string(i)).append("]");
      openObject(row);
      members({&field.childType(owner, i), field.constChild(owner, i)});
      close('}');
      path_.resize(length);
    }
    close(']');
  }

  void value(bool v) { out_ += v ? "true" : "false"; }
  void value(std::int64_t v) { out_ += std::to_string(v); }
  void value(double v) {
    if (!std::isfinite(v)) {
      problems_.push_back({path_, numberText(v) + " cannot be saved", "must be a finite number"});
    } else if (v == 0 && std::signbit(v)) {
      out_ += "-0.0";  // "-0" would read back as the integer 0
    } else {
      out_ += numberText(v);
    }
  }
  void value(const std::string& v) {
    out_ += nlohmann::json(v).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  void value(const std::vector<double>& v) {
    open('[', Layout::OneLine);
    for (const double component : v) {
      next();
      value(component);
    }
    close(']');
  }

  void openObject(Layout layout) { open('{', layout); }
  void open(char bracket, Layout layout) {
    out_ += bracket;
    levels_.push_back({layout});
  }

  /// What stands before the next element.
  void next() {
    Level& level = levels_.back();
    if (!level.empty) out_ += ',';
    if (level.layout == Layout::Lines) {
      newLine();
    } else if (!level.empty) {
      out_ += ' ';
    }
    level.empty = false;
  }

  void key(const std::string& name) {
    next();
    value(name);
    out_ += ": ";
  }

  void close(char bracket) {
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.layout == Layout::Lines && !level.empty) newLine();
    out_ += bracket;
  }

  void newLine() {
    out_ += '\n';
    out_.append(2 * levels_.size(), ' ');
  }

  std::string out_;
  std::string path_;
  std::vector<Level> levels_;
  std::vector<Problem> problems_;
};

}  // namespace

std::string writeDocument(ConstRef root, const DocumentFormat& format) {
  return DocumentWriter().write(root, format);
}

}  // namespace rotorbench
