// The program tm_cell as its caller sees it, and a folder for what it writes.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "source_tree.h"
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace cobot_command::test_support {

struct Outcome {
  std::string output;
  int exit_code = -1;
};

inline Outcome tmCell(const std::string& arguments) {
  const std::string command = std::string(TM_CELL) + " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  Outcome outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.output.append(buffer.data(), size);
  }
  outcome.exit_code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

inline std::string cellFile(const std::string& name) {
  return inSourceTree("config/cells/" + name + ".yaml");
}

inline std::string textIn(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// A folder of its own, which goes with it.
class TmCell : public testing::Test {
 protected:
  TmCell() {
    char name[] = "/tmp/tm_cell_test_XXXXXX";
    if (mkdtemp(name) == nullptr) throw std::runtime_error("no folder for the test");
    folder_ = name;
  }
  ~TmCell() override { (void)std::system(("rm -rf " + folder_).c_str()); }

  [[nodiscard]] std::string in(const std::string& name) const { return folder_ + "/" + name; }
  [[nodiscard]] std::string built(const std::string& cell) const {
    const Outcome outcome = tmCell("build " + cellFile(cell) + " -o " + in(cell));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return in(cell);
  }

 private:
  std::string folder_;
};

}  // namespace cobot_command::test_support
