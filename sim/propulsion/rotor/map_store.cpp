#include "sim/propulsion/rotor/map_store.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <vector>

#include "sim/core/schema_tree.h"

namespace rotorbench {

namespace fs = std::filesystem;

namespace {

/// Of the form of the files and of how a table is laid out and refined: goes up with either.
constexpr const char* kForm = "rotorbench map 2\n";
constexpr const char* kSuffix = ".map";

/// FNV-1a over 64 bits (Fowler, Noll, Vo).
class Digest {
 public:
  explicit Digest(std::uint64_t start = 14695981039346656037ULL) : value_(start) {}
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
  }
  void add(const std::string& text) {
    const std::uint64_t size = text.size();
    add(&size, sizeof size);
    add(text.data(), text.size());
  }
  void add(double number) { add(&number, sizeof number); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

struct AddValue {
  Digest& digest;
  void operator()(bool v) const { digest.add(v ? "true" : "false"); }
  void operator()(std::int64_t v) const { digest.add(std::to_string(v)); }
  void operator()(double v) const { digest.add(v); }
  void operator()(const std::string& v) const { digest.add(v); }
  void operator()(const std::vector<double>& v) const {
    for (const double x : v) digest.add(x);
  }
};

void addParameters(const MapPropeller& propeller, Digest& digest) {
  schema::walk(schema::ref(propeller),
               [&](const std::string& path, const schema::Field& field, const void* owner) {
                 digest.add(path);
                 if (field.isLeaf()) std::visit(AddValue{digest}, field.read(owner));
                 if (field.kind == schema::Kind::Variant)
                   digest.add(field.options[field.chosen(owner)].key);
               });
}

/// What another version of the blade elements would give other bits of.
void addLoads(const BladeElementRotor& rotor, Digest& digest) {
  const double tip = 60 / rotor.radius();
  const AirState air;
  for (const double axial : {-20.0, -6.0, 0.0, 9.0, 30.0}) {
    const AxialLoad a = rotor.axial(tip, axial, air);
    digest.add(a.thrust);
    digest.add(a.torque);
    const ObliqueLoad o = rotor.oblique(tip, axial, 15, air);
    for (const double load : {o.thrust, o.torque, o.drag, o.rollMoment}) digest.add(load);
  }
}

std::string hexadecimal(std::uint64_t value) {
  std::ostringstream text;
  text << std::hex;
  text.width(16);
  text.fill('0');
  text << value;
  return text.str();
}

std::uint64_t checksum(const std::string& bytes) {
  Digest digest;
  digest.add(bytes.data(), bytes.size());
  return digest.value();
}

}  // namespace

fs::path MapStore::userFolder() {
  if (const char* own = std::getenv("ROTORBENCH_CACHE")) return own;
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && *cache == '/') return fs::path(cache) / "rotorbench" / "maps";
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home != '/') return {};
  return fs::path(home) / ".cache" / "rotorbench" / "maps";
}

std::string MapStore::fileName(const MapPropeller& propeller, const BladeElementRotor& rotor) {
  // Two digests from different starts: what both take for equal is equal.
  std::string name;
  for (const std::uint64_t start : {14695981039346656037ULL, 0x9E3779B97F4A7C15ULL}) {
    Digest digest(start);
    digest.add(kForm);
    addParameters(propeller, digest);
    addLoads(rotor, digest);
    name += hexadecimal(digest.value());
  }
  return name + kSuffix;
}

std::optional<PropellerMap> MapStore::find(const MapPropeller& propeller,
                                           const BladeElementRotor& rotor) const {
  if (folder_.empty()) return {};
  const fs::path file = folder_ / fileName(propeller, rotor);
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};
  std::string form(std::strlen(kForm), '\0'), bytes;
  std::uint64_t sum = 0;
  in.read(form.data(), static_cast<std::streamsize>(form.size()));
  in.read(reinterpret_cast<char*>(&sum), sizeof sum);
  if (!in || form != kForm) return {};
  bytes.assign(std::istreambuf_iterator<char>(in), {});
  if (checksum(bytes) != sum) return {};
  std::istringstream data(bytes);
  auto map = PropellerMap::read(data, rotor, propeller.map);
  std::error_code ignored;
  if (map) fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
  return map;
}

void MapStore::keep(const MapPropeller& propeller, const BladeElementRotor& rotor,
                    const PropellerMap& map) const {
  if (folder_.empty()) return;
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (failed) return;
  std::ostringstream data;
  map.write(data);
  const std::string bytes = data.str();
  const std::uint64_t sum = checksum(bytes);
  const fs::path file = folder_ / fileName(propeller, rotor);
  // Nobody else writes under this name.
  fs::path part = file;
  part += "." + std::to_string(getpid()) + "." + std::to_string(std::random_device{}()) + ".part";
  {
    std::ofstream out(part, std::ios::binary);
    out << kForm;
    out.write(reinterpret_cast<const char*>(&sum), sizeof sum);
    out << bytes;
    out.flush();
    if (!out) failed = std::make_error_code(std::errc::io_error);
  }
  if (!failed) fs::rename(part, file, failed);
  std::error_code ignored;
  if (failed) fs::remove(part, ignored);
  makeRoom();
}

void MapStore::makeRoom() const {
  struct Kept {
    fs::path path;
    fs::file_time_type used;
    std::uintmax_t size;
  };
  std::vector<Kept> kept;
  std::uintmax_t all = 0;
  std::error_code failed;
  for (fs::directory_iterator i(folder_, failed), end; !failed && i != end; i.increment(failed)) {
    std::error_code gone;  // another program may have made room too
    const fs::path path = i->path();
    if (path.extension() != kSuffix && path.extension() != ".part") continue;
    Kept one{path, fs::last_write_time(path, gone), 0};
    one.size = fs::file_size(path, gone);
    // What a program left that was killed while it wrote.
    constexpr auto kAbandoned = std::chrono::hours(1);
    if (!gone && path.extension() == ".part") {
      if (fs::file_time_type::clock::now() - one.used > kAbandoned) fs::remove(path, gone);
      continue;
    }
    if (gone) continue;
    all += one.size;
    kept.push_back(std::move(one));
  }
  std::ranges::sort(kept, {}, &Kept::used);
  for (const Kept& oldest : kept) {
    if (all <= most_) return;
    std::error_code gone;
    fs::remove(oldest.path, gone);
    all -= oldest.size;
  }
}

}  // namespace rotorbench
