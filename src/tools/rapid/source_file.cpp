#include "source_file.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::tools {

namespace {

std::string lastError() {
  return std::generic_category().message(errno);
}

/// A descriptor that is closed at its end.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
  /// False with errno if what was written may be lost.
  [[nodiscard]] bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

 private:
  int descriptor_;
};

Result<std::string, std::string> readUpTo(int descriptor, std::size_t most) {
  std::string bytes;
  std::string block(std::size_t{1} << 16U, '\0');
  while (bytes.size() < most) {
    const ssize_t size = ::read(descriptor, block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return refuse(lastError());
    if (size == 0) break;
    bytes.append(block, 0, static_cast<std::size_t>(size));
  }
  return bytes;
}

/// False with errno.
bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t size = ::write(descriptor, bytes.data(), bytes.size());
    if (size < 0 && errno != EINTR) return false;
    if (size > 0) bytes.remove_prefix(static_cast<std::size_t>(size));
  }
  return true;
}

/// The file that a name leads to, over links. Empty with errno if there is none.
std::string behindLinks(const std::string& name) {
  char* const found = ::realpath(name.c_str(), nullptr);
  std::string target = found == nullptr ? "" : found;
  std::free(found);  // NOLINT(cppcoreguidelines-no-malloc): realpath() has allocated it
  return target;
}

/// Fills the new file and gives it the mode and, if it is allowed, the owner of the old one. False with
/// errno.
bool fill(OpenFile& file, std::string_view bytes, const struct stat& old) {
  constexpr mode_t kModeBits = 07777;
  if (::fchown(file.descriptor(), old.st_uid, old.st_gid) != 0 && errno != EPERM) return false;
  return ::fchmod(file.descriptor(), old.st_mode & kModeBits) == 0 && writeAll(file.descriptor(), bytes) &&
         ::fsync(file.descriptor()) == 0 && file.close();
}

}  // namespace

Result<std::string, std::string> bytesOf(const std::string& name) {
  constexpr std::size_t kMost = rapid::kMostFileBytes + 1;  // one more shows that it is too long
  if (name == kStandardInput) return readUpTo(STDIN_FILENO, kMost);
  const OpenFile file(::open(name.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.isOpen()) return refuse(lastError());
  return readUpTo(file.descriptor(), kMost);
}

rapid::Source readSourceFile(const std::string& name, const rapid::ReadOptions& options) {
  const auto bytes = bytesOf(name);
  return bytes ? rapid::readSource(*bytes, options) : rapid::Source::unreadable(bytes.error());
}

std::optional<std::string> replaceFile(const std::string& name, std::string_view bytes) {
  const std::string target = behindLinks(name);
  struct stat old {};
  if (target.empty() || ::stat(target.c_str(), &old) != 0) return lastError();
  if (!S_ISREG(old.st_mode)) return "it is no regular file";
  // A file that is protected against writing would be replaced all the same, if its folder is not.
  if (::access(target.c_str(), W_OK) != 0) return lastError();
  std::string part = target + ".XXXXXX";
  OpenFile file(::mkostemp(part.data(), O_CLOEXEC));
  if (!file.isOpen()) return lastError();
  if (fill(file, bytes, old) && ::rename(part.c_str(), target.c_str()) == 0) return std::nullopt;
  std::string why = lastError();
  ::unlink(part.c_str());
  return why;
}

}  // namespace cobot_command::tools
