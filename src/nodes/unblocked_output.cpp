#include "unblocked_output.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cobot_command::nodes {
namespace {

constexpr int kPipeSize = 1 << 20;  // [bytes]: some ten thousand lines
constexpr int kLastWordsMs = 200;

/// What is on its way of one stream. For a signal handler: atomic, and there until the process has ended.
struct OnTheWay {
  std::atomic<int> pipe{-1};
  std::atomic<bool> is_passing{false};

  [[nodiscard]] bool isNothing() const {
    int bytes = 0;
    const int from = pipe;
    // In this order: a thread that has emptied the pipe meanwhile is passing on what was in it.
    return from < 0 || (::ioctl(from, FIONREAD, &bytes) == 0 && bytes == 0 && !is_passing);
  }
};
std::array<OnTheWay, 3> on_the_way;  // by file descriptor

/// Calls nothing but what a signal handler may.
void awaitLastWords() {
  const timespec millisecond{0, 1'000'000};
  for (int i = 0; i < kLastWordsMs; ++i) {
    if (on_the_way[STDOUT_FILENO].isNothing() && on_the_way[STDERR_FILENO].isNothing()) return;
    ::nanosleep(&millisecond, nullptr);
  }
}

/// The signal's own action is in force again by then.
extern "C" void crashWithLastWords(int signal) {
  awaitLastWords();
  ::raise(signal);
}

void awaitLastWordsOfCrashes() {
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    struct sigaction before = {};
    const bool is_known = ::sigaction(signal, nullptr, &before) == 0;
    if (!is_known || before.sa_handler != SIG_DFL) continue;  // a sanitizer's
    struct sigaction action = {};
    action.sa_handler = crashWithLastWords;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
}

bool isRegularFile(int file) {
  struct stat kind = {};
  return ::fstat(file, &kind) != 0 || S_ISREG(kind.st_mode);
}

/// False: nobody will ever read it.
bool passOn(const char* bytes, std::size_t size, int to) {
  while (size > 0) {
    const ssize_t written = ::write(to, bytes, size);
    if (written < 0 && errno == EAGAIN) {  // somebody else has made it so
      pollfd room{to, POLLOUT, 0};
      ::poll(&room, 1, -1);
    } else if (written <= 0 && errno != EINTR) {
      return false;
    } else if (written > 0) {
      bytes += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  return true;
}

/// Until the last writer has closed the pipe. What nobody will read is dropped.
void passOnAll(int from, int to, std::size_t file) {
  OnTheWay& on_its_way = on_the_way[file];
  std::array<char, std::size_t{16} * 1024> bytes{};
  bool is_read = true;
  pollfd more{from, POLLIN, 0};
  while (::poll(&more, 1, -1) >= 0 || errno == EINTR) {
    on_its_way.is_passing = true;
    const ssize_t size = ::read(from, bytes.data(), bytes.size());
    if (size > 0) is_read = is_read && passOn(bytes.data(), static_cast<std::size_t>(size), to);
    on_its_way.is_passing = false;
    if (size == 0 || (size < 0 && errno != EINTR && errno != EAGAIN)) return;
  }
}

}  // namespace

class UnblockedOutput::Stream {
 public:
  /// `file`: its descriptor, which is the pipe's from here on.
  Stream(std::FILE* stream, int file) : stream_(stream) {
    std::array<int, 2> ends{};
    if (isRegularFile(file) || ::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    const int original = ::fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    ::fcntl(ends[1], F_SETPIPE_SZ, kPipeSize);  // as much as the system allows
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    std::fflush(stream);
    ::dup2(ends[1], file);
    ::close(ends[1]);
    if (stream == stdout) std::setvbuf(stream, nullptr, _IOLBF, BUFSIZ);  // as for a terminal
    is_unblocked_ = true;
    const auto number = static_cast<std::size_t>(file);
    on_the_way[number].pipe = ends[0];
    // Not joined: it may stand before a terminal that is stopped.
    std::thread(passOnAll, ends[0], original, number).detach();
  }
  ~Stream() {
    if (!is_unblocked_) return;
    std::fflush(stream_);
    awaitLastWords();
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

 private:
  std::FILE* stream_;
  bool is_unblocked_ = false;
};

UnblockedOutput::UnblockedOutput()
    : output_(std::make_unique<Stream>(stdout, STDOUT_FILENO)),
      errors_(std::make_unique<Stream>(stderr, STDERR_FILENO)) {
  awaitLastWordsOfCrashes();
  std::at_quick_exit(awaitLastWords);
}

UnblockedOutput::~UnblockedOutput() = default;

}  // namespace cobot_command::nodes
