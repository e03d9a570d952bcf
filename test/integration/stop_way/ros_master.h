// A ROS master for one test program, which can be made to hang.
#pragma once

#include <sys/types.h>

namespace cobot_command::testing {

/// Started with the first test of a program that links it; ROS is initialized then, for a node named after
/// the program.
class RosMaster {
 public:
  [[nodiscard]] static RosMaster& instance();

  void start();
  void stop();
  /// It takes connections, and answers nothing, until goOn().
  void hang();
  void goOn();

 private:
  RosMaster() = default;

  pid_t process_ = 0;
};

}  // namespace cobot_command::testing
