// A disk whose fsync() takes as long as a test wants: it stands in for that of the system in the program that
// links it.
#pragma once

#include <chrono>

namespace cobot_command::testing {

class SlowDisk {
 public:
  [[nodiscard]] static SlowDisk& instance();

  /// From now on whoever waits for the disk waits until goOn().
  void hang();
  void goOn();
  /// Until somebody waits for it. False: nobody came in a minute.
  [[nodiscard]] bool isWaitedFor();

  /// Of fsync().
  void sync();

 private:
  SlowDisk() = default;
};

}  // namespace cobot_command::testing
