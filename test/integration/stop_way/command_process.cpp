#include "command_process.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iterator>
#include <utility>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cobot_command::testing {
namespace {

pid_t run(std::vector<std::string> arguments, const std::optional<int>& output) {
  arguments.insert(arguments.begin(), COBOT_COMMAND_NODE);
  std::vector<char*> words;
  std::transform(arguments.begin(), arguments.end(), std::back_inserter(words),
                 [](std::string& word) { return word.data(); });
  words.push_back(nullptr);
  const pid_t process = ::fork();
  if (process == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      if (output) ::dup2(*output, stream);
    }
    ::setenv("LD_PRELOAD", COBOT_SLOW_FSYNC, 1);
    ::execv(words.front(), words.data());
    ::_exit(127);
  }
  return process;
}

}  // namespace

CommandProcess::CommandProcess(std::vector<std::string> arguments, std::optional<int> output)
    : process_(run(std::move(arguments), output)) {}

CommandProcess::~CommandProcess() {
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

}  // namespace cobot_command::testing
