// A disk whose fsync() and fdatasync() take as long as a test wants: they replace those of the system in the
// program that links it.
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

  /// Of fsync() and fdatasync().
  void sync();

 private:
  SlowDisk() = default;
};

}  // namespace cobot_command::testing
