// A command node as a process of its own, on a slow disk.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace cobot_command::testing {

class CommandProcess {
 public:
  /// `arguments`: as on its command line. `output`: what it writes its log to; nothing: where this process
  /// does.
  explicit CommandProcess(std::vector<std::string> arguments, std::optional<int> output = std::nullopt);
  ~CommandProcess();
  CommandProcess(const CommandProcess&) = delete;
  CommandProcess& operator=(const CommandProcess&) = delete;

 private:
  pid_t process_;
};

}  // namespace cobot_command::testing
