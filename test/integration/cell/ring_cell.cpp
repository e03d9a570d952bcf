// ring_cell N: prints the file of a cell of N robots in a ring, for measurements as nodes.
#include "ring_cell.h"

#include <cstdio>
#include <cstdlib>

int main(int count, char** arguments) {
  const int robots = count == 2 ? std::atoi(arguments[1]) : 0;
  if (robots < 8 || robots > 64) {
    std::fputs("usage: ring_cell ROBOTS, 8 to 64\n", stderr);
    return 2;
  }
  std::fputs(cobot_command::trial::ringCell(robots).c_str(), stdout);
  return 0;
}
