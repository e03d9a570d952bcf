#include "shared/regular_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cobot_command::ros_adapter {
namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& path)
      : number_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

std::string systemsWords(int error) {
  return "it cannot be read: " + std::system_category().message(error);
}

std::string whyNotThere(const std::filesystem::path& path, int error) {
  struct stat link {};
  if (error == ENOENT && lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode)) {
    return "it is a link to a file that does not exist";
  }
  return error == ENOENT ? "there is no such file" : systemsWords(error);
}

/// Empty: a regular file.
std::string kindOf(const struct stat& found) {
  if (S_ISREG(found.st_mode)) return "";
  if (S_ISDIR(found.st_mode)) return "it is a folder";
  if (S_ISFIFO(found.st_mode)) return "it is a FIFO, not a file";
  if (S_ISSOCK(found.st_mode)) return "it is a socket, not a file";
  return "it is a device, not a file";
}

std::string tooLarge(std::size_t limit) {
  return fmt::format("it is larger than {} bytes", limit);
}

/// Up to `most` bytes: what a file says of its size need not be true.
Result<std::string, std::string> readUpTo(int descriptor, std::size_t most) {
  std::string bytes;
  std::array<char, 16384> piece{};
  while (bytes.size() < most) {
    const ssize_t count = read(descriptor, piece.data(), std::min(piece.size(), most - bytes.size()));
    if (count == 0) break;
    if (count > 0) {
      bytes.append(piece.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      return refuse(systemsWords(errno));
    }
  }
  return bytes;
}

}  // namespace

Result<std::string, std::string> readRegularFile(const std::filesystem::path& path, std::size_t size_limit) {
  struct stat found {};
  if (stat(path.c_str(), &found) != 0) return refuse(whyNotThere(path, errno));
  if (auto kind = kindOf(found); !kind.empty()) return refuse(std::move(kind));
  if (static_cast<std::uintmax_t>(found.st_size) > size_limit) return refuse(tooLarge(size_limit));
  const Descriptor file(path);
  if (file.number() < 0) return refuse(systemsWords(errno));
  // Another one may stand there by now.
  if (fstat(file.number(), &found) != 0) return refuse(systemsWords(errno));
  if (auto kind = kindOf(found); !kind.empty()) return refuse(std::move(kind));
  auto bytes = readUpTo(file.number(), size_limit + 1);
  if (bytes && bytes->size() > size_limit) return refuse(tooLarge(size_limit));
  return bytes;
}

}  // namespace cobot_command::ros_adapter
