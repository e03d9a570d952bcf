#include "line_reader.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <poll.h>
#include <unistd.h>

namespace cobot_command::tools {

namespace {

/// A longer one is no command; it is cut there.
constexpr std::size_t kLongestLine = 4096;

}  // namespace

LineReader::LineReader(int descriptor, Use use) : descriptor_(descriptor), use_(std::move(use)) {
  if (::pipe(end_.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  thread_ = std::thread([this] { run(); });
}

LineReader::~LineReader() {
  ::close(end_[1]);
  thread_.join();
  ::close(end_[0]);
}

void LineReader::run() {
  std::array<char, 1024> bytes{};
  while (waitForInput()) {
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    take(bytes.data(), static_cast<std::size_t>(count));
  }
  if (!line_.empty()) use_(std::exchange(line_, {}));
}

bool LineReader::waitForInput() const {
  std::array<pollfd, 2> watched{{{descriptor_, POLLIN, 0}, {end_[0], POLLIN, 0}}};
  while (::poll(watched.data(), watched.size(), -1) < 0) {
    if (errno != EINTR) return false;
  }
  return watched[1].revents == 0;
}

void LineReader::take(const char* bytes, std::size_t count) {
  std::for_each(bytes, bytes + count, [this](char byte) {
    if (byte != '\n') line_ += byte;
    if (byte == '\n' || line_.size() >= kLongestLine) use_(std::exchange(line_, {}));
  });
}

}  // namespace cobot_command::tools
