#include "slow_disk.h"

#include <condition_variable>
#include <mutex>

#include "event_log.h"
#include <sys/syscall.h>
#include <unistd.h>

namespace cobot_command::testing {
namespace {

std::mutex mutex;
std::condition_variable changed;
bool hangs = false;
int waiting = 0;

}  // namespace

SlowDisk& SlowDisk::instance() {
  static SlowDisk disk;
  return disk;
}

void SlowDisk::hang() {
  const std::lock_guard<std::mutex> lock(mutex);
  hangs = true;
}

void SlowDisk::goOn() {
  const std::lock_guard<std::mutex> lock(mutex);
  hangs = false;
  changed.notify_all();
}

bool SlowDisk::isWaitedFor() {
  std::unique_lock<std::mutex> lock(mutex);
  return changed.wait_for(lock, kDeadline, [] { return waiting > 0; });
}

void SlowDisk::sync() {
  std::unique_lock<std::mutex> lock(mutex);
  ++waiting;
  changed.notify_all();
  changed.wait(lock, [] { return !hangs; });
  --waiting;
}

}  // namespace cobot_command::testing

extern "C" int fsync(int file) {
  cobot_command::testing::SlowDisk::instance().sync();
  return static_cast<int>(::syscall(SYS_fsync, file));
}

extern "C" int fdatasync(int file) {
  cobot_command::testing::SlowDisk::instance().sync();
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}
