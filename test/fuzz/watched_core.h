// A command core whose actions are held against the rules that always hold, whatever came in: one end for
// each goal, no end without an error that the catalogue knows, texts that are not endless, and never anything
// to do in the past.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "require.h"

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::fuzz {

class WatchedCore {
 public:
  explicit WatchedCore(std::optional<arm::ArmModel> arm = std::nullopt)
      : core_(std::move(arm), link::LinkSettings{}) {}

  void submit(const blocks::Goal& goal) {
    blocks_[++last_goal_] = blocks::blockOf(goal);
    core_.submit(last_goal_, goal, now_);
    collect();
  }
  void cancel(blocks::GoalId id) {
    tell([&] { core_.cancel(id, now_); });
  }

  void finish(blocks::FinishAfter after) {
    tell([&] { core_.finish(after, now_); });
  }

  void opened(link::ConnectionId id) {
    tell([&] { core_.opened(id, now_); });
  }
  void openFailed(link::ConnectionId id, link::OpenFailure::Kind kind) {
    tell([&] { core_.openFailed(id, {kind, "as the system says"}, now_); });
  }
  void received(link::ConnectionId id, std::string_view bytes) {
    tell([&] { core_.received(id, bytes, now_); });
  }
  void closed(link::ConnectionId id) {
    tell([&] { core_.closed(id, "closed by the peer", now_); });
  }

  /// From deadline to deadline.
  void pass(Duration duration) {
    const Instant end = now_ + duration;
    for (auto due = core_.nextDeadline(); due && *due <= end; due = core_.nextDeadline()) {
      REQUIRE(++advances_ < 1000000);  // it would never come to an end
      now_ = std::max(now_, *due);
      tell([&] { core_.advance(now_); });
    }
    now_ = end;
    tell([&] { core_.advance(now_); });
  }

  /// All goals end with it, and nothing is left to do.
  void shutDown() {
    tell([&] { core_.shutDown(now_); });
    REQUIRE(ended_.size() == blocks_.size());
  }

  [[nodiscard]] blocks::GoalId lastGoal() const { return last_goal_; }
  /// Asked for and not yet answered, or open; the newest of the channel.
  [[nodiscard]] link::ConnectionId connection(link::Channel channel) const {
    const auto found = connections_.find(channel);
    return found == connections_.end() ? 0 : found->second;
  }
  /// What was sent since the last call.
  [[nodiscard]] std::string takeSent() { return std::exchange(sent_, {}); }
  [[nodiscard]] bool hasEnded(blocks::GoalId id) const { return ended_.count(id) != 0; }

 private:
  template <class Event>
  void tell(const Event& event) {
    event();
    collect();
  }
  void collect() {
    for (const command::Action& action : core_.takeActions()) {
      std::visit([this](const auto& what) { take(what); }, action);
    }
  }

  void take(const command::OpenConnection& open) {
    REQUIRE(seen_.insert(open.id).second);
    connections_[open.channel] = open.id;
  }
  void take(const command::CloseConnection& /*close*/) {}
  /// Of the script port: who asks the status port who the controller is, is not answered.
  void take(const command::SendBytes& send) {
    if (send.id == connections_[link::Channel::Script]) sent_ += send.bytes;
  }
  void take(const command::GoalAccepted& accepted) {
    REQUIRE(accepted_.insert(accepted.goal).second);
    REQUIRE(ended_.count(accepted.goal) == 0);
  }
  void take(const command::GoalProgressed& progressed) {
    REQUIRE(ended_.count(progressed.goal) == 0);
    requireText(progressed.progress.text);
  }
  void take(const command::GoalEnded& ended) {
    REQUIRE(ended_.insert(ended.goal).second);
    const blocks::Outcome& outcome = ended.outcome;
    const bool error =
        outcome.ending == blocks::Ending::Rejected || outcome.ending == blocks::Ending::Aborted;
    REQUIRE(error == (outcome.error_id != 0));
    requireText(outcome.error_description);
    requireText(outcome.remedy);
    requireTexts(outcome.detail.find<blocks::SequenceReport>());
    requireTexts(outcome.detail.find<blocks::CycleReport>());
    if (!error) return;
    REQUIRE(blocks::findError(blocks_.at(ended.goal), outcome.error_id) != nullptr);
    REQUIRE(!outcome.error_description.empty() && !outcome.remedy.empty());
  }
  void take(const command::StatusChanged& changed) {
    requireText(changed.status.diagnosis);
    requireText(changed.status.status_diagnosis);
    requireText(changed.status.listen_node);
    for (const command::BlockOutputs& o : changed.status.blocks) {
      REQUIRE(o.busy + o.done + o.error + o.command_aborted <= 1);
      REQUIRE(o.active + o.done + o.error + o.command_aborted <= 1);
      requireText(o.error_description);
    }
  }
  void take(const command::LogMessage& message) { requireText(message.text); }
  void take(const command::MessageRaised& raised) {
    requireText(raised.message.text);
    requireText(raised.message.remedy);
  }
  template <class Told>
  void take(const Told& /*told*/) {}

  /// Whatever came in, what is told of it can be read on a screen.
  static void requireText(const std::string& text) {
    REQUIRE(text.size() <= kLongestText);
    REQUIRE(isUtf8(text));
    REQUIRE(escaped(text) == text);
  }
  static void requireTexts(const blocks::SequenceReport* report) {
    if (report == nullptr) return;
    for (const blocks::StepReport& step : report->steps) requireText(step.error_description);
  }
  static constexpr std::size_t kLongestText = 4096;

  command::CommandCore core_;
  Instant now_{std::chrono::seconds(1000)};
  long advances_ = 0;
  blocks::GoalId last_goal_ = 0;
  std::map<blocks::GoalId, blocks::Block> blocks_;
  std::set<blocks::GoalId> accepted_;
  std::set<blocks::GoalId> ended_;
  std::set<link::ConnectionId> seen_;
  std::map<link::Channel, link::ConnectionId> connections_;
  std::string sent_;
};

}  // namespace cobot_command::fuzz
