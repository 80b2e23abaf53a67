#include "sim/io/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <random>
#include <system_error>

#include "sim/core/error.h"
#include "sim/io/output_error.h"

namespace rotorbench {

namespace fs = std::filesystem;

namespace {

std::string reason() {
  return std::generic_category().message(errno);
}

[[noreturn]] void refuseToWrite(const fs::path& file) {
  const std::string what = "the file cannot be written: " + reason();
  if (errno == ENOSPC || errno == EDQUOT || errno == EIO || errno == EFBIG)
    throw OutputError(file.string(), {{{}, what, {}}});
  refuse(file.string(), what);
}

/// Closes, and removes the file unless it was put in place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) {
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
      name_ = target.string() + "." + std::to_string(random()) + ".part";
      const int descriptor = ::open(name_.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
      if (descriptor >= 0) {
        ::close(descriptor);
        return;
      }
      if (errno != EEXIST) break;
    }
    refuseToWrite(target);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!placed_) fs::remove(name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

  void moveTo(const fs::path& target) {
    const int descriptor = ::open(name_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int code = errno;
    if (descriptor >= 0) ::close(descriptor);
    errno = code;
    if (!synced) refuseToWrite(target);
    std::error_code error;
    const fs::file_status replaced = fs::status(target, error);
    if (fs::exists(replaced)) fs::permissions(name_, replaced.permissions(), error);
    fs::rename(name_, target, error);
    if (error) refuse(target.string(), "the file cannot be written: " + error.message());
    placed_ = true;
  }

 private:
  std::string name_;
  bool placed_ = false;
};

void writeInto(const fs::path& opened, const fs::path& shown,
               const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(opened, std::ios::binary | std::ios::trunc);
  if (out) write(out);
  const bool whole = static_cast<bool>(out);
  // Closing what failed may set errno anew.
  const int code = errno;
  out.close();
  if (!whole) errno = code;
  if (!out) refuseToWrite(shown);
}

}  // namespace

std::string readTextFile(const fs::path& path, std::size_t maxBytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse(path.string(), "there is no such file");
  if (fs::is_directory(status)) refuse(path.string(), "this is a folder", "must be a file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(path.string(), "the file cannot be read: " + reason());
  std::string text;
  std::string piece(std::size_t{1} << 16, '\0');
  while (in && text.size() <= maxBytes) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) refuse(path.string(), "the file cannot be read: " + reason());
  if (text.size() > maxBytes) {
    refuse(path.string(), "the file is too large",
           "must be at most " + std::to_string(maxBytes >> 20) + " MiB");
  }
  return text;
}

void writeFileAtomically(const fs::path& path, std::string_view text) {
  const auto write = [text](std::ostream& out) {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  };
  writeFileAtomically(path, std::function<void(std::ostream&)>(write));
}

void writeFileAtomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) refuse(path.string(), "this is a folder", "must be a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) return writeInto(path, path, write);
  // Through a link the file it points to is replaced, not the link.
  fs::path target = fs::exists(status) ? fs::canonical(path, error) : path;
  if (error) target = path;
  TemporaryFile temporary(target);
  writeInto(temporary.name(), target, write);
  temporary.moveTo(target);
}

}  // namespace rotorbench
