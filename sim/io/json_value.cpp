#include "sim/io/json_value.h"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "sim/core/error.h"
#include "sim/core/number_text.h"
#include "sim/core/schema_tree.h"

namespace rotorbench {

namespace {

/// "line 3, column 7" of a byte; columns count characters.
std::string placeOf(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::string_view line =
      newline == std::string_view::npos ? before : before.substr(newline + 1);
  const auto column = std::count_if(line.begin(), line.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  });
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(column + 1);
}

/// True if the word around `byte` is one of those other languages take for numbers.
bool isNotANumberWord(std::string_view text, std::size_t byte) {
  std::size_t start = std::min(byte, text.size());
  const auto isLetter = [&](std::size_t i) {
    return (text[i] >= 'a' && text[i] <= 'z') || (text[i] >= 'A' && text[i] <= 'Z');
  };
  while (start > 0 && isLetter(start - 1)) --start;
  std::size_t end = start;
  while (end < text.size() && isLetter(end)) ++end;
  const std::string_view word = text.substr(start, end - start);
  const auto words = {"NaN", "nan", "NAN", "Infinity", "inf", "Inf", "INF", "infinity"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Builds the tree from the events of nlohmann's parser (which itself does not recurse).
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, std::vector<Problem>& problems)
      : text_(text), problems_(problems) {}

  bool null() override { return add({}); }
  bool boolean(bool v) override { return add({v}); }
  bool number_integer(number_integer_t v) override { return add({std::int64_t{v}}); }
  bool number_unsigned(number_unsigned_t v) override {
    constexpr auto kLargest = static_cast<number_unsigned_t>(INT64_MAX);
    if (v <= kLargest) return add({static_cast<std::int64_t>(v)});
    return add({static_cast<double>(v)});
  }
  bool number_float(number_float_t v, const string_t& digits) override {
    const std::string_view mantissa =
        std::string_view(digits).substr(0, digits.find_first_of("eE"));
    if (v == 0 && mantissa.find_first_of("123456789") != std::string_view::npos) {
      problems_.push_back({path(), excerpt(digits) + " is too small for a number", {}});
    }
    return add({v});
  }
  bool string(string_t& v) override { return add({std::move(v)}); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open({JsonValue::Object()}); }
  bool start_array(std::size_t) override { return open({JsonValue::Array()}); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& v) override {
    Level& level = open_.back();
    level.key = std::move(v);
    level.doubled = !level.keys.insert(level.key).second;
    if (level.doubled && problems_.size() < kMostDoubled) {
      problems_.push_back({path(), "this key is given twice", "must be given once"});
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    const std::size_t byte = position == 0 ? 0 : position - 1;
    std::string detail = error.what();
    if (isNotANumberWord(text_, byte)) {
      detail = "NaN and Infinity are not numbers in JSON";
    } else if (const auto cut = detail.find(": "); cut != std::string::npos) {
      detail = detail.substr(cut + 2);
    } else if (error.id == 406) {
      detail = "the number is too large";
    }
    fault_ = "this is not valid JSON at " + placeOf(text_, byte) + ": " + excerpt(detail, 200);
    return false;
  }

  [[nodiscard]] const std::string& fault() const { return fault_; }
  JsonValue& root() { return root_; }

 private:
  static constexpr std::size_t kMostDoubled = 1000;

  struct Level {
    JsonValue* container;
    std::string key;
    std::unordered_set<std::string> keys;
    bool doubled = false;
  };

  bool add(JsonValue v) { return place(std::move(v)) != nullptr; }

  bool open(JsonValue v) {
    if (open_.size() == static_cast<std::size_t>(kMaxJsonDepth)) {
      fault_ = "the file is nested more than " + std::to_string(kMaxJsonDepth) + " levels deep";
      return false;
    }
    JsonValue* placed = place(std::move(v));
    if (placed == nullptr) return false;
    open_.push_back({placed, {}, {}, false});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  /// Where the value came to rest; containers grow only at their end while it is open, so it stays.
  JsonValue* place(JsonValue v) {
    if (++count_ > kMaxJsonValues) {
      fault_ = "the file holds more than " + std::to_string(kMaxJsonValues) + " values";
      return nullptr;
    }
    if (open_.empty()) {
      root_ = std::move(v);
      return &root_;
    }
    Level& level = open_.back();
    if (auto* array = std::get_if<JsonValue::Array>(&level.container->value)) {
      return &array->emplace_back(std::move(v));
    }
    if (level.doubled) {
      dropped_.push_back(std::make_unique<JsonValue>(std::move(v)));
      return dropped_.back().get();
    }
    auto& object = std::get<JsonValue::Object>(level.container->value);
    return &object.emplace_back(JsonMember{level.key, std::move(v)}).value;
  }

  [[nodiscard]] std::string path() const {
    std::string path;
    for (const Level& level : open_) {
      if (const auto* array = std::get_if<JsonValue::Array>(&level.container->value)) {
        const bool innermost = &level == &open_.back();
        path.append("[").append(std::to_string(array->size() - (innermost ? 0 : 1))).append("]");
      } else {
        path = schema::joinPath(path, excerpt(level.key));
      }
    }
    return path;
  }

  std::string_view text_;
  std::vector<Problem>& problems_;
  JsonValue root_;
  std::vector<Level> open_;
  std::vector<std::unique_ptr<JsonValue>> dropped_;
  std::size_t count_ = 0;
  std::string fault_;
};

}  // namespace

std::string JsonValue::shown() const {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return numberText(*number);
  if (const auto* string = text()) return inQuotes(*string);
  return array() != nullptr ? "a list" : object() != nullptr ? "an object" : "null";
}

JsonValue parseJson(std::string_view text, const std::string& source,
                    std::vector<Problem>& problems) {
  if (text.size() > kMaxJsonBytes) {
    refuse(source, "the file is too large",
           "must be at most " + std::to_string(kMaxJsonBytes >> 20) + " MiB");
  }
  if (const auto byte = findInvalidUtf8(text)) {
    refuse(source, "this is not text in UTF-8: see " + placeOf(text, *byte));
  }
  // nlohmann takes a zero byte for the end of the input and would not see what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    refuse(source, "this is not text: there is a zero byte at " + placeOf(text, zero));
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    refuse(source, "the file is empty");
  TreeBuilder builder(text, problems);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder))
    refuse(source, builder.fault());
  return std::move(builder.root());
}

}  // namespace rotorbench
