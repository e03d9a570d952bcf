// Loaded before the system's libraries (LD_PRELOAD): a disk that takes 0.45 s.
#include <chrono>
#include <thread>

#include <sys/syscall.h>
#include <unistd.h>

extern "C" int fsync(int file) {
  std::this_thread::sleep_for(std::chrono::milliseconds(450));
  return static_cast<int>(::syscall(SYS_fsync, file));
}
