// A terminal that somebody has stopped (Ctrl-S), or a reader that reads no more, takes nothing of the log.
#include <array>
#include <string>

#include "node_and_peer.h"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace cobot_command::testing {
namespace {

/// A pipe that is full, and that nobody reads. Whoever writes to it waits.
class FullPipe {
 public:
  FullPipe() {
    EXPECT_EQ(::pipe(ends_.data()), 0);
    ::fcntl(ends_[1], F_SETFL, O_NONBLOCK);
    const std::string line(4096, '.');
    while (::write(ends_[1], line.data(), line.size()) > 0) {
    }
    ::fcntl(ends_[1], F_SETFL, 0);
  }
  ~FullPipe() {
    for (const int end : ends_) ::close(end);
  }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;
  [[nodiscard]] int in() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{};
};

TEST(StoppedTerminal, keepsNoStopWaiting) {
  const FullPipe terminal;
  NodeAndPeer node(terminal.in());
  node.awaitReady();  // it has logged that it is connected
  node.moves.publish(bufferedMoveOf(20));
  ASSERT_TRUE(node.peer.timeOf("PTP", 0).has_value());
  node.stops.publish(cobot_command::StopActionGoal());
  EXPECT_TRUE(node.peer.timeOf(runtime::kStop, 0).has_value());
}

}  // namespace
}  // namespace cobot_command::testing
