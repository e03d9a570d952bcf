// Lines on standard output that must not end the program when nobody reads them any more.
#pragma once

#include <mutex>
#include <string>
#include <utility>

namespace cobot_command::tools {

/// Thread-safe. Whoever reads a pipe sees each line at once. Precondition: SIGPIPE is ignored.
class LinePrinter {
 public:
  /// `program` is named when lines get lost.
  explicit LinePrinter(std::string program) : program_(std::move(program)) {}

  /// Without its end. The first line that cannot be written is told on standard error; those behind it are
  /// dropped in silence.
  void print(const std::string& line);

 private:
  std::mutex mutex_;
  const std::string program_;
  bool lost_ = false;
};

}  // namespace cobot_command::tools
