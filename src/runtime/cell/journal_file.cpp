#include "cell/journal_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::runtime {
namespace {

std::string because(const std::string& name, const char* what) {
  return fmt::format("the journal {} {}: {}", foreignText(name), what, std::strerror(errno));
}

/// So that a file that was just made is still there after a loss of power.
void syncFolder(const std::string& name) {
  const auto folder = std::filesystem::path(name).parent_path();
  const int opened = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  ::fsync(opened);
  ::close(opened);
}

}  // namespace

Result<std::unique_ptr<JournalFile>, std::string> JournalFile::open(const std::string& name) {
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return refuse(because(name, "cannot be opened"));
  auto journal = std::unique_ptr<JournalFile>(new JournalFile(file, {}));
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    return refuse(fmt::format(
        "the journal {} is in use: there is another supervisor with it; stop that, or give this one its own",
        foreignText(name)));
  }
  const auto bytes = readFile(name);
  if (!bytes) return refuse(bytes.error());
  auto contents = cell::journal::read(*bytes);
  if (!contents) {
    return refuse(
        fmt::format("the journal {} is damaged at line {}: {}; bring all robots home, and begin a new one",
                    foreignText(name), contents.error().line, contents.error().message));
  }
  const auto whole = static_cast<off_t>(bytes->size() - contents->torn);
  if (contents->torn > 0 && ::ftruncate(file, whole) != 0) return refuse(because(name, "cannot be mended"));
  syncFolder(name);
  journal->records_ = std::move(contents->records);
  return journal;
}

JournalFile::JournalFile(int file, std::vector<cell::journal::Record> records)
    : file_(file), records_(std::move(records)) {}

JournalFile::~JournalFile() {
  ::close(file_);
}

bool JournalFile::append(const std::string& line) {
  if (is_broken_) return false;
  const ssize_t written = ::write(file_, line.data(), line.size());
  const bool is_whole = written >= 0 && static_cast<std::size_t>(written) == line.size();
  is_broken_ = !is_whole || ::fdatasync(file_) != 0;
  return !is_broken_;
}

}  // namespace cobot_command::runtime
