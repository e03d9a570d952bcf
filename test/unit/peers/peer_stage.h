// A command core between two peers, in invented time.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "misbehaving_peers.h"

#include "cobot_command/command/command_core.h"
#include "cobot_command/protocol/frame_decoder.h"

namespace cobot_command::testing {

class PeerStage {
 public:
  explicit PeerStage(link::LinkSettings settings);

  /// From the next connection on; without one there is a good controller.
  void put(const testing::MisbehavingPeer& peer);
  void putGoodPeers() { peers_.clear(); }

  blocks::GoalId submit(const blocks::Goal& goal);
  void cancel(blocks::GoalId goal);
  /// Lets time pass until it is true; false when it does not become true in `within`.
  template <class Condition>
  [[nodiscard]] bool runUntil(Duration within, Condition condition) {
    for (Duration passed{}; !condition(); passed += testing::kPeerTick) {
      if (passed >= within) return false;
      step();
    }
    return true;
  }
  void run(Duration duration) {
    (void)runUntil(duration, [] { return false; });
  }
  void shutDown();

  [[nodiscard]] bool connected(blocks::GoalId goal) const { return connected_.count(goal) != 0; }
  [[nodiscard]] bool ended(blocks::GoalId goal) const { return ends_.count(goal) != 0; }
  [[nodiscard]] const blocks::Outcome& endOf(blocks::GoalId goal) const { return ends_.at(goal).front(); }
  /// Of all goals.
  [[nodiscard]] const std::map<blocks::GoalId, std::vector<blocks::Outcome>>& ends() const { return ends_; }
  [[nodiscard]] int goals() const { return static_cast<int>(last_goal_); }
  [[nodiscard]] const command::CommandStatus& status() const { return status_; }
  /// What the heap held at most, above what it held at the beginning [bytes]; 0 where it cannot be asked.
  [[nodiscard]] std::size_t mostMemory() const { return most_memory_; }

 private:
  struct Connection {
    link::ConnectionId id = 0;
    bool open = false;
    int ticks = 0;
    protocol::FrameDecoder decoder;
    testing::MisbehavingPeer peer;
  };
  struct Saying {
    link::ConnectionId to;
    testing::PeerTalk talk;
  };

  void step();
  void pump();
  void carryOut();
  [[nodiscard]] Connection* find(link::ConnectionId id);
  void hear(Connection& connection, std::string_view bytes);
  void say(const Saying& saying);
  void take(const command::OpenConnection& open);
  void take(const command::CloseConnection& close);
  void take(const command::SendBytes& send);
  void take(const command::GoalProgressed& progressed);
  void take(const command::GoalEnded& ended);
  void take(const command::StatusChanged& changed);
  void take(const command::FrameTraced& traced) { expectBounded(traced.meaning); }
  void take(const command::LogMessage& message) { expectBounded(message.text); }
  void take(const command::MessageRaised& raised) { expectBounded(raised.message.text); }
  template <class Told>
  void take(const Told& /*told*/) {}
  /// Whatever a peer says, people are told in a line.
  static void expectBounded(const std::string& text);
  void measure();

  command::CommandCore core_;
  Instant now_{std::chrono::seconds(1000)};
  std::map<link::Channel, testing::MisbehavingPeer> peers_;
  std::map<link::Channel, Connection> connections_;
  std::deque<Saying> sayings_;
  blocks::GoalId last_goal_ = 0;
  std::map<blocks::GoalId, bool> connected_;
  std::map<blocks::GoalId, std::vector<blocks::Outcome>> ends_;
  command::CommandStatus status_;
  std::size_t memory_at_start_ = 0;
  std::size_t most_memory_ = 0;
};

}  // namespace cobot_command::testing
