#include "tables/tables_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "shared/regular_file.h"
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cobot_command::ros_adapter {
namespace {

namespace fs = std::filesystem;

/// A hundred times what all entries with the longest names take.
constexpr std::size_t kMaxFileSize = 1 << 20;
constexpr mode_t kModeOfNewFiles = 0644;

std::string words(int error) {
  return std::system_category().message(error);
}

/// What a link leads to, so that it is that which is replaced.
fs::path realPath(const std::string& path) {
  std::error_code error;
  fs::path real = fs::canonical(path, error);
  return error ? fs::path(path) : real;
}

/// The new file beside the old one, until it takes its place; else it is gone again.
class Successor {
 public:
  explicit Successor(const fs::path& path)
      : path_(path),
        own_(path.string() + ".new"),
        number_(open(own_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, kModeOfNewFiles)),
        error_(number_ < 0 ? errno : 0) {
    struct stat old {};
    if (number_ >= 0 && stat(path_.c_str(), &old) == 0) check(fchmod(number_, old.st_mode & 07777) == 0);
  }
  ~Successor() {
    if (number_ < 0) return;
    close(number_);
    unlink(own_.c_str());
  }
  Successor(const Successor&) = delete;
  Successor& operator=(const Successor&) = delete;

  void fill(const std::string& text) {
    std::size_t done = 0;
    while (error_ == 0 && done < text.size()) {
      const ssize_t count = write(number_, text.data() + done, text.size() - done);
      if (count >= 0) {
        done += static_cast<std::size_t>(count);
      } else {
        check(errno == EINTR);
      }
    }
    if (error_ == 0) check(fsync(number_) == 0);
  }

  void takePlace() {
    if (error_ != 0) return;
    check(close(std::exchange(number_, -1)) == 0);
    if (error_ == 0) check(rename(own_.c_str(), path_.c_str()) == 0);
    if (error_ != 0) unlink(own_.c_str());
  }

  [[nodiscard]] std::optional<std::string> fault() const {
    if (error_ == 0) return std::nullopt;
    return fmt::format("{} cannot be written: {}", own_.string(), words(error_));
  }

 private:
  void check(bool done) {
    if (!done) error_ = errno;
  }

  fs::path path_;
  fs::path own_;
  int number_;
  int error_;
};

}  // namespace

Result<std::optional<std::string>, std::string> readTablesFile(const std::string& path) {
  struct stat found {};
  if (lstat(path.c_str(), &found) != 0 && errno == ENOENT) return std::optional<std::string>();
  auto text = readRegularFile(path, kMaxFileSize);
  if (!text) return refuse(std::move(text.error()));
  return std::optional(*std::move(text));
}

std::optional<std::string> whyNotWritable(const std::string& path) {
  return Successor(realPath(path)).fault();
}

std::optional<std::string> writeTablesFile(const std::string& path, const std::string& text) {
  Successor successor(realPath(path));
  successor.fill(text);
  successor.takePlace();
  return successor.fault();
}

}  // namespace cobot_command::ros_adapter
