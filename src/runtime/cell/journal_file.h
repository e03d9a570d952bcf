// The journal of a supervisor on a disk: what was written is there after a loss of power (cell.md, M30).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/cell/supervision/journal.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

/// One process has it at a time.
class JournalFile {
 public:
  /// Makes the file where there is none; a last record that was not written wholly is cut off. A fault is a
  /// sentence: it cannot be opened, another process has it, or it is damaged.
  [[nodiscard]] static Result<std::unique_ptr<JournalFile>, std::string> open(const std::string& name);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// As they were when it was opened. There may be very many: none are kept.
  [[nodiscard]] std::vector<cell::journal::Record> takeRecords() { return std::move(records_); }
  /// False: it could not be written, or not be brought to the disk; nothing of it counts, and from then on
  /// nothing is written any more.
  [[nodiscard]] bool append(const std::string& line);
  /// The line takes the place of all that was written, which is kept beside it, as NAME.before, until the
  /// next time. False: it could not; then all is as it was, or nothing is written any more.
  [[nodiscard]] bool replace(const std::string& line);

 private:
  explicit JournalFile(std::string name) : name_(std::move(name)) {}
  std::string name_;
  int file_ = -1;
  std::vector<cell::journal::Record> records_;
  bool is_broken_ = false;
};

}  // namespace cobot_command::runtime
