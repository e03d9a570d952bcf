// The journal of a supervisor on a disk: what was written is there after a loss of power (cell.md, M30).
#pragma once

#include <memory>
#include <string>
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

  /// As they were when it was opened.
  [[nodiscard]] const std::vector<cell::journal::Record>& records() const { return records_; }
  /// False: it could not be written, or not be brought to the disk; nothing of it counts, and from then on
  /// nothing is written any more.
  [[nodiscard]] bool append(const std::string& line);

 private:
  JournalFile(int file, std::vector<cell::journal::Record> records);

  int file_;
  std::vector<cell::journal::Record> records_;
  bool is_broken_ = false;
};

}  // namespace cobot_command::runtime
