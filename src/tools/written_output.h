// What a program says when its answers could not be written: a full disk, a closed pipe.
#pragma once

#include <cstdio>
#include <iostream>

namespace cobot_command::tools {

/// The exit status of a program whose answers did not all reach standard output.
inline constexpr int kOutputLost = 3;

/// `status`, if all that was written to std::cout has left; else kOutputLost, with a line on standard error.
inline int unlessOutputLost(const char* program, int status) {
  if (std::cout.flush()) return status;
  std::fprintf(stderr,
               "%s: the answer cannot be written to standard output: free space, or choose another place\n",
               program);
  return kOutputLost;
}

}  // namespace cobot_command::tools
