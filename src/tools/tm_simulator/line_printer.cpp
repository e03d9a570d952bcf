#include "line_printer.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace cobot_command::tools {

void LinePrinter::print(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (lost_) return;
  const std::string whole = line + '\n';
  const bool written = std::fwrite(whole.data(), 1, whole.size(), stdout) == whole.size();
  lost_ = !written || std::fflush(stdout) != 0;
  if (!lost_) return;
  std::fprintf(stderr,
               "%s: standard output cannot be written (%s): its output is lost, the program continues\n",
               program_.c_str(), std::strerror(errno));
}

}  // namespace cobot_command::tools
