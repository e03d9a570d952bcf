#include "peer_stage.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>
#include <malloc.h>

namespace cobot_command::testing {
namespace {

using testing::MisbehavingPeer;

std::size_t heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace

PeerStage::PeerStage(link::LinkSettings settings)
    : core_(*arm::ArmModel::named("tm5-900"), std::move(settings)), memory_at_start_(heapInUse()) {}

void PeerStage::put(const MisbehavingPeer& peer) {
  peers_[peer.port] = peer;
}

blocks::GoalId PeerStage::submit(const blocks::Goal& goal) {
  core_.submit(++last_goal_, goal, now_);
  pump();
  return last_goal_;
}

void PeerStage::cancel(blocks::GoalId goal) {
  core_.cancel(goal, now_);
  pump();
}

void PeerStage::shutDown() {
  core_.shutDown(now_);
  pump();
}

void PeerStage::step() {
  const Instant end = now_ + testing::kPeerTick;
  for (auto due = core_.nextDeadline(); due && *due <= end; due = core_.nextDeadline()) {
    now_ = std::max(now_, *due);
    core_.advance(now_);
    pump();
  }
  now_ = end;
  core_.advance(now_);
  for (auto& [channel, connection] : connections_) {
    if (!std::exchange(connection.open, true)) {
      sayings_.push_back({connection.id, connection.peer.greets()});
      core_.opened(connection.id, now_);
    } else {
      sayings_.push_back({connection.id, connection.peer.talks(++connection.ticks)});
    }
  }
  pump();
}

/// Until nobody has anything more to say.
void PeerStage::pump() {
  carryOut();
  while (!sayings_.empty()) {
    const Saying saying = std::move(sayings_.front());
    sayings_.pop_front();
    say(saying);
    measure();
    carryOut();
  }
}

void PeerStage::carryOut() {
  for (const command::Action& action : core_.takeActions()) {
    std::visit([this](const auto& what) { take(what); }, action);
  }
}

PeerStage::Connection* PeerStage::find(link::ConnectionId id) {
  const auto found = std::find_if(connections_.begin(), connections_.end(),
                                  [&](const auto& entry) { return entry.second.id == id; });
  return found == connections_.end() ? nullptr : &found->second;
}

void PeerStage::say(const Saying& saying) {
  if (find(saying.to) == nullptr) return;  // closed meanwhile
  if (!saying.talk.bytes.empty()) core_.received(saying.to, saying.talk.bytes, now_);
  if (!saying.talk.closes) return;
  for (auto it = connections_.begin(); it != connections_.end(); ++it) {
    if (it->second.id != saying.to) continue;
    connections_.erase(it);
    core_.closed(saying.to, "closed by the peer", now_);
    return;
  }
}

void PeerStage::hear(Connection& connection, std::string_view bytes) {
  connection.decoder.feed(bytes);
  while (const auto event = connection.decoder.next()) {
    const auto* const frame = std::get_if<protocol::Frame>(&*event);
    ASSERT_NE(frame, nullptr) << "the layer sent what is no frame";
    if (frame->header == protocol::header::kItems) continue;  // asks who the controller is: nobody tells
    const auto message = protocol::parseClientMessage(*frame);
    ASSERT_TRUE(message.has_value()) << "the layer sent what means nothing: " << frame->data;
    sayings_.push_back({connection.id, connection.peer.answers(*message)});
  }
}

void PeerStage::take(const command::OpenConnection& open) {
  const auto strange = peers_.find(open.channel);
  Connection connection;
  connection.id = open.id;
  connection.peer = strange != peers_.end()                 ? strange->second
                    : open.channel == link::Channel::Script ? testing::goodController()
                                                            : testing::goodStream();
  connections_[open.channel] = std::move(connection);
}

void PeerStage::take(const command::CloseConnection& close) {
  for (auto it = connections_.begin(); it != connections_.end();) {
    it = it->second.id == close.id ? connections_.erase(it) : std::next(it);
  }
}

void PeerStage::take(const command::SendBytes& send) {
  if (Connection* const connection = find(send.id)) hear(*connection, send.bytes);
}

void PeerStage::take(const command::GoalProgressed& progressed) {
  EXPECT_FALSE(ended(progressed.goal)) << "progress after the end";
  expectBounded(progressed.progress.text);
  if (progressed.progress.phase == blocks::Phase::Connected) connected_[progressed.goal] = true;
}

void PeerStage::take(const command::StatusChanged& changed) {
  status_ = changed.status;
  for (const auto& text : {status_.diagnosis, status_.listen_node, status_.status_diagnosis}) {
    expectBounded(text);
  }
  for (const auto& block : status_.blocks) expectBounded(block.error_description);
}

void PeerStage::expectBounded(const std::string& text) {
  constexpr std::size_t kMostText = 4096;
  EXPECT_LE(text.size(), kMostText) << text.substr(0, 200);
}

void PeerStage::take(const command::GoalEnded& ended) {
  expectBounded(ended.outcome.error_description);
  ends_[ended.goal].push_back(ended.outcome);
  EXPECT_EQ(ends_[ended.goal].size(), 1u) << "goal " << ended.goal << " has ended twice";
}

void PeerStage::measure() {
  const std::size_t in_use = heapInUse();
  if (in_use > memory_at_start_) most_memory_ = std::max(most_memory_, in_use - memory_at_start_);
}

}  // namespace cobot_command::testing
