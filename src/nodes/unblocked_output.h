// What a node writes to its terminal must not keep it waiting. A terminal that somebody has stopped (Ctrl-S),
// or a reader that no longer reads, takes nothing: whoever writes to it stands still, with a lock of the log
// that all others want as well, and a stop would wait for a key to be pressed.
#pragma once

#include <memory>

namespace cobot_command::nodes {

/// From here on standard output and standard error go by pipes, which threads empty; lines that find a pipe
/// full are lost. What is a regular file stays as it is. To be made before there are other threads, once in a
/// process. At the end, also by a crash or std::quick_exit(), what was written last has 0.2 s to get out.
class UnblockedOutput {
 public:
  UnblockedOutput();
  ~UnblockedOutput();
  UnblockedOutput(const UnblockedOutput&) = delete;
  UnblockedOutput& operator=(const UnblockedOutput&) = delete;

 private:
  class Stream;
  std::unique_ptr<Stream> output_;
  std::unique_ptr<Stream> errors_;
};

}  // namespace cobot_command::nodes
