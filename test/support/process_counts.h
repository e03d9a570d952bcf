// What this process holds of the system at the moment: to see that nothing is left behind.
#pragma once

#include <memory>
#include <string>

#include <dirent.h>

namespace cobot_command::testing {

inline int entriesIn(const std::string& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> directory(opendir(folder.c_str()), closedir);
  int count = 0;
  while (readdir(directory.get()) != nullptr) {
    ++count;
  }
  return count;
}

inline int openDescriptors() {
  return entriesIn("/proc/self/fd");
}

inline int runningThreads() {
  return entriesIn("/proc/self/task");
}

}  // namespace cobot_command::testing
