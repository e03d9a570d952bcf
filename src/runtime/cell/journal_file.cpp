#include "cell/journal_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::runtime {
namespace {

std::string because(const std::string& name, const char* what) {
  return fmt::format("the journal {} {}: {}", foreignText(name), what, std::strerror(errno));
}

/// So that what was made, or renamed, is still there after a loss of power. False: that is not sure; a file
/// system that cannot be asked for it does it by itself.
bool syncFolder(const std::string& name) {
  const auto folder = std::filesystem::path(name).parent_path();
  const int opened = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return false;
  const bool is_done = ::fsync(opened) == 0 || errno == EINVAL;
  ::close(opened);
  return is_done;
}

/// It is the one of that name still: who had it may have made it anew since it was opened.
bool isNamed(int file, const std::string& name) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(file, &opened) == 0 && ::stat(name.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

bool isLocked(int file) {
  return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

bool writeWhole(int file, const std::string& line) {
  const ssize_t written = ::write(file, line.data(), line.size());
  return written >= 0 && static_cast<std::size_t>(written) == line.size() && ::fdatasync(file) == 0;
}

/// -1: it could not be made.
int madeWith(const std::string& line, const std::string& name) {
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return -1;
  // Nobody else is to have it at the moment in which it gets its name.
  if (isLocked(file) && writeWhole(file, line)) return file;
  ::close(file);
  return -1;
}

/// For people alone: where that cannot be, it goes on without.
void keepBeside(const std::string& name, const std::string& other) {
  ::unlink(other.c_str());
  static_cast<void>(::link(name.c_str(), other.c_str()));
}

}  // namespace

Result<std::unique_ptr<JournalFile>, std::string> JournalFile::open(const std::string& name) {
  auto journal = std::unique_ptr<JournalFile>(new JournalFile(name));
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return refuse(because(name, "cannot be opened"));
  journal->file_ = file;
  if (!isLocked(file) || !isNamed(file, name)) {
    return refuse(fmt::format(
        "the journal {} is in use by another supervisor; stop that supervisor, or use another journal",
        foreignText(name)));
  }
  const auto bytes = readFile(name);
  if (!bytes) return refuse(bytes.error());
  auto contents = cell::journal::read(*bytes);
  if (!contents) {
    return refuse(fmt::format(
        "the journal {} is damaged at line {}: {}; bring all robots home, and start a new journal",
        foreignText(name), contents.error().line, contents.error().message));
  }
  const auto whole = static_cast<off_t>(bytes->size() - contents->torn);
  if (contents->torn > 0 && ::ftruncate(file, whole) != 0) return refuse(because(name, "cannot be repaired"));
  static_cast<void>(syncFolder(name));
  journal->records_ = std::move(contents->records);
  return journal;
}

JournalFile::~JournalFile() {
  if (file_ >= 0) ::close(file_);
}

bool JournalFile::append(const std::string& line) {
  if (is_broken_) return false;
  is_broken_ = !writeWhole(file_, line);
  return !is_broken_;
}

bool JournalFile::replace(const std::string& line) {
  // Behind the renaming it has to be possible, too.
  if (is_broken_ || !syncFolder(name_)) return false;
  const std::string anew = name_ + ".new";
  const int file = madeWith(line, anew);
  if (file >= 0) keepBeside(name_, name_ + ".before");
  if (file < 0 || ::rename(anew.c_str(), name_.c_str()) != 0) {
    if (file >= 0) ::close(file);
    ::unlink(anew.c_str());
    return false;
  }
  ::close(std::exchange(file_, file));
  // Else a loss of power could bring back the old one, without what is appended from now on.
  is_broken_ = !syncFolder(name_);
  return !is_broken_;
}

}  // namespace cobot_command::runtime
