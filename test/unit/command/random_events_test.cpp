// A hundred thousand random events: whatever happens in whatever order, the rules hold.
//
// The rules of every step (exclusive outputs, one end for each goal, no end before its acceptance) are
// checked by the rig; here: no Done without the report of its tag after it was sent, nor while the status
// stream shows the robot in motion, everything ends, and the layer works afterwards. A failure prints its
// seed; COBOT_TEST_SEED and COBOT_TEST_EVENTS choose others.

#include <map>
#include <memory>
#include <random>
#include <regex>
#include <set>

#include "block_goals.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "motion_ledger.h"
#include "random_goals.h"
#include "status_frames.h"
#include "thorough.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using protocol::TagState;

class Chaos {
 public:
  /// Planning::Beside: with a model, and what is planned is answered sooner or later.
  Chaos(unsigned seed, Planning planning)
      : plans_(planning == Planning::Beside),
        random_(seed),
        rig_(plans_ ? std::optional(*arm::ArmModel::named("tm5-900")) : std::nullopt, link::LinkSettings{},
             planning) {
    rig_.answers_lifesigns = false;
  }

  void step() {
    static const std::vector<void (Chaos::*)()> kEvents = {&Chaos::submitConnect,  &Chaos::submitMove,
                                                           &Chaos::submitMove,     &Chaos::submitMove,
                                                           &Chaos::submitStop,     &Chaos::submitControl,
                                                           &Chaos::submitBase,     &Chaos::submitCycle,
                                                           &Chaos::cancelAny,      &Chaos::openAny,
                                                           &Chaos::openAny,        &Chaos::failAny,
                                                           &Chaos::closeAny,       &Chaos::answerNode,
                                                           &Chaos::answerNode,     &Chaos::answerNode,
                                                           &Chaos::replyToScript,  &Chaos::replyToScript,
                                                           &Chaos::replyToScript,  &Chaos::strangeReply,
                                                           &Chaos::reportTag,      &Chaos::reportTag,
                                                           &Chaos::reportTag,      &Chaos::enterNode,
                                                           &Chaos::complain,       &Chaos::noise,
                                                           &Chaos::statusFrame,    &Chaos::statusFrame,
                                                           &Chaos::statusFrame,    &Chaos::shortTime,
                                                           &Chaos::shortTime,      &Chaos::longTime,
                                                           &Chaos::reportEarly,    &Chaos::reportEarly,
                                                           &Chaos::submitPath,     &Chaos::submitPath,
                                                           &Chaos::submitPath,     &Chaos::setFeedrate,
                                                           &Chaos::track,          &Chaos::finishAny,
                                                           &Chaos::setOverride,    &Chaos::submitExchange,
                                                           &Chaos::updateExchange, &Chaos::interrupt,
                                                           &Chaos::goOn,           &Chaos::goOn};
    (this->*kEvents[pick(kEvents.size())])();
    answerPlans(pick(3));
    collect();
    checkDone();
  }

  /// Whatever is open can be brought to an end, and a new motion works.
  void finish() {
    rig_.answers_lifesigns = true;
    rig_.listening = true;
    for (GoalId id = 1; id <= last_; ++id) rig_.cancel(id);
    for (int i = 0; i < 20; ++i) rig_.pass(500ms);
    answerPlans();
    collect();
    for (GoalId id = 1; id <= last_; ++id) EXPECT_NE(rig_.outcome(id), nullptr) << "goal " << id;
    for (const auto& [what, replies] : requests_) EXPECT_EQ(*replies, 1) << what << " is answered once";
    rig_.discardSent();
    rig_.connect();
    rig_.status(StatusFrames());
    rig_.core.setSpeedOverride(
        100, [](const OverrideAnswer&) {}, rig_.now);
    rig_.discardSent();
    const GoalId goal = rig_.submit(moveTo(0));
    answerPlans();
    const auto script = rig_.takeScript();
    rig_.reply(script.id);
    rig_.tag(tagOf(script.script));
    rig_.status(StatusFrames());
    ASSERT_NE(rig_.outcome(goal), nullptr);
    EXPECT_EQ(rig_.outcome(goal)->ending, Ending::Done);
  }

  std::map<int, int> endings;  ///< by error id, or minus the ending: what the run has seen

 private:
  std::size_t pick(std::size_t count) { return random_() % count; }
  [[nodiscard]] bool open(link::Channel channel) const { return rig_.connectionOpen(channel); }
  link::Channel anyChannel() { return pick(3) == 0 ? link::Channel::Status : link::Channel::Script; }

  static int tagOf(const std::string& script) {
    std::smatch match;
    return std::regex_search(script, match, std::regex("QueueTag\\((\\d+),0\\)")) ? std::stoi(match[1]) : 0;
  }

  void answerPlans(std::size_t most = 1000) {
    for (std::size_t i = 0; i < most && rig_.isPlanning(); ++i) rig_.finishPlan();
  }

  /// With a model it has to be one that can be made, and that the stream shows to be reached.
  [[nodiscard]] MoveAbsoluteGoal moveTo(int target) const {
    MoveAbsoluteGoal goal = CoreRig::move();
    if (plans_) {
      goal = moveJoints({0, 0, 90, 0, 90, target / 1e6});
    } else {
      goal.target[0] = target;
    }
    return goal;
  }
  [[nodiscard]] std::string textOf(int target) const {
    return plans_ ? fmt::format("PTP(\"JPP\",0,0,90,0,90,{},", target / 1e6)
                  : fmt::format("PTP(\"CPP\",{},", target);
  }

  void submitConnect() { last_ = rig_.submit(CoreRig::robot()); }
  void submitMove() {
    // Known again on the wire by its target, whenever its turn comes.
    MoveAbsoluteGoal goal = moveTo(++targets_);
    goal.blending_enable = pick(5) == 0;
    goal.exit_node = pick(12) == 0;
    goal.command_id = pick(3) == 0 ? static_cast<int>(pick(11)) : 0;
    if (pick(20) == 0) goal.speed = 0;
    goal.buffer_mode = static_cast<int>(pick(4));  // 3 is none
    last_ = rig_.submit(goal);
    const Outcome* outcome = rig_.outcome(last_);
    if (outcome != nullptr && outcome->ending == Ending::Rejected) return;
    motions_.add(last_, {!goal.blending_enable || goal.exit_node, goal.exit_node, textOf(targets_)});
  }
  void submitStop() {
    if (pick(4) == 0) last_ = rig_.submit(StopGoal{});
  }
  void submitControl() { last_ = rig_.submit(ProgramControlGoal{0, static_cast<int>(pick(2))}); }
  void submitBase() { last_ = rig_.submit(goals_.base()); }
  void submitCycle() {
    if (pick(8) == 0) last_ = rig_.submit(goals_.cycle(moveTo(0)));
  }
  void submitPath() { last_ = rig_.submit(goals_.path()); }
  void submitExchange() {
    if (pick(3) == 0) last_ = rig_.submit(goals_.exchange());
  }
  void updateExchange() {
    static_cast<void>(rig_.core.updateExchange(goals_.settings(), rig_.now));
    rig_.pass(0ms);
  }
  std::shared_ptr<int> request(const char* what) {
    return requests_.emplace_back(what, std::make_shared<int>(0)).second;
  }
  void setFeedrate() {
    constexpr double kPercents[] = {0, 50, 80, 100, 125, 200};
    const auto percent = pick(3) == 0 ? std::nullopt : std::optional(kPercents[pick(std::size(kPercents))]);
    const auto replies = request("a feedrate");
    rig_.core.setFeedrate(
        {percent, pick(2) == 0}, [replies](const FeedrateAnswer&) { ++*replies; }, rig_.now);
    rig_.pass(0ms);
  }
  /// Seldom 0, which keeps everything back until the next one.
  void setOverride() {
    constexpr double kPercents[] = {0, 20, 50, 100, 100, 100, 101};
    const auto replies = request("an override");
    rig_.core.setSpeedOverride(
        kPercents[pick(std::size(kPercents))], [replies](const OverrideAnswer&) { ++*replies; }, rig_.now);
    rig_.pass(0ms);
  }
  void interrupt() {
    const auto replies = request("an interruption");
    rig_.core.interrupt([replies](const InterruptAnswer&) { ++*replies; }, rig_.now);
    rig_.pass(0ms);
  }
  void goOn() {
    const auto replies = request("what goes on");
    rig_.core.goOn(
        [this, replies](const InterruptAnswer& answer) {
          ++*replies;
          if (answer.success) motions_.goesOn();
        },
        rig_.now);
    rig_.pass(0ms);
  }
  void track() {
    const TrackingSwitch request{static_cast<int>(pick(3)), pick(6) == 0, pick(2) == 0};
    EXPECT_EQ(rig_.core.switchTracking(request, rig_.now).has_value(), request.object == 2);
    rig_.pass(0ms);
  }
  void finishAny() {
    if (pick(4) != 0) return;
    static_cast<void>(rig_.core.finish(static_cast<FinishAfter>(pick(2)), rig_.now));
    rig_.pass(0ms);
  }
  void cancelAny() {
    if (last_ != 0) rig_.cancel(last_ - pick(std::min<std::size_t>(last_, 4)));
  }
  void openAny() {
    const auto channel = anyChannel();
    if (rig_.pendingOpen(channel)) rig_.open(channel);
  }
  void failAny() {
    const auto channel = anyChannel();
    if (rig_.pendingOpen(channel)) rig_.failOpen(static_cast<link::OpenFailure::Kind>(pick(5)), channel);
  }
  void closeAny() {
    const auto channel = anyChannel();
    if (pick(4) == 0 && open(channel)) rig_.close("closed by chance", channel);
  }
  void answerNode() {
    if (open(link::Channel::Script)) rig_.say(protocol::ListenNodeState{pick(8) != 0, "Listen1"});
  }
  void enterNode() {
    if (open(link::Channel::Script)) rig_.say(protocol::ListenNodeEntered{"Listen2"});
  }
  void replyToScript() {
    if (scripts_.empty() || !open(link::Channel::Script)) return;
    const std::string id = scripts_[scripts_.size() - 1 - pick(std::min<std::size_t>(scripts_.size(), 3))];
    const bool accepted = pick(6) != 0;
    if (accepted) motions_.accepted(id);
    rig_.reply(id, accepted, accepted ? std::vector<int>{} : std::vector<int>{1});
  }
  void strangeReply() {
    if (open(link::Channel::Script)) rig_.reply(std::to_string(pick(100000)));
  }
  void reportTag() {
    if (!open(link::Channel::Script)) return;
    const auto& tags = rig_.latest().open_tags;
    const int tag = !tags.empty() && pick(3) != 0 ? tags[0] : static_cast<int>(pick(17));
    const auto state = pick(6) == 0    ? TagState::Incomplete
                       : pick(12) == 0 ? TagState::Unknown
                                       : TagState::Complete;
    if (state == TagState::Complete) motions_.reported(tag);
    rig_.tag(tag, state);
  }
  /// The tag is back, and the robot goes on for longer than one waits for it. Before the first frame of a
  /// stream the tag is all that is known, and enough: reportTag().
  void reportEarly() {
    const auto tags = rig_.latest().open_tags;
    if (tags.empty() || !open(link::Channel::Script) || !rig_.latest().status_stream) return;
    motions_.reported(tags[0]);
    shows_motion_ = true;
    rig_.tag(tags[0]);
    showFrames(StatusFrames().moving(), 40);
  }
  void complain() {
    constexpr protocol::CommunicationErrorCode kCodes[] = {protocol::CommunicationErrorCode::Checksum,
                                                           protocol::CommunicationErrorCode::NotListening};
    if (pick(3) == 0 && open(link::Channel::Script)) {
      rig_.say(protocol::CommunicationError{kCodes[pick(2)]});
    }
  }
  void noise() {
    const auto channel = anyChannel();
    if (open(channel)) rig_.receive(pick(2) == 0 ? "noise$" : "$TMSTA,3,01,*00\r\n", channel);
  }
  void statusFrame() {
    if (!open(link::Channel::Status)) return;
    StatusFrames frame;
    shows_motion_ = false;
    switch (pick(12)) {
      case 0:
        frame.emergencyStop();
        break;
      case 1:
        frame.error(0x13, "PTP");
        break;
      case 2:
        frame.paused();
        break;
      case 3:
      case 4:
      case 5:
        frame.moving();
        shows_motion_ = true;
        break;
      case 6:
        frame.without("Joint_Speed");
        break;
      default:
        break;
    }
    showFrames(frame, pick(4) == 0 ? 40 : 1 + pick(3));
  }
  void showFrames(const StatusFrames& frame, std::size_t count) {
    for (std::size_t i = 0; i < count && open(link::Channel::Status); ++i) {
      rig_.status(frame);
      rig_.pass(CoreRig::kStreamPeriod);
    }
  }
  void shortTime() { rig_.pass(std::chrono::milliseconds(pick(400))); }
  void longTime() {
    if (pick(10) == 0) rig_.pass(std::chrono::seconds(pick(400)));
  }

  /// What was sent: scripts and which motion they are of.
  void collect() {
    for (auto& message : rig_.takeAllSent()) {
      const auto* script = std::get_if<protocol::ScriptRequest>(&message);
      if (script == nullptr) continue;
      EXPECT_TRUE(script_ids_.insert(script->id).second) << "script ids are unique";
      scripts_.push_back(script->id);
      motions_.sent(script->id, script->script, tagOf(script->script));
    }
  }
  void checkDone() {
    const bool stands = !shows_motion_ || !rig_.latest().status_stream;
    motions_.check([this](GoalId goal) { return rig_.outcome(goal); }, stands,
                   [this](const Outcome& outcome) {
                     ++endings[outcome.error_id != 0 ? outcome.error_id : -static_cast<int>(outcome.ending)];
                   });
  }

  bool plans_;
  std::mt19937 random_;
  RandomGoals goals_{[this](std::size_t count) { return pick(count); }};
  CoreRig rig_;
  GoalId last_ = 0;
  bool shows_motion_ = false;  ///< the last status frame
  int targets_ = 10000;        ///< above the targets of the cycles
  std::vector<std::string> scripts_;
  std::set<std::string> script_ids_;
  MotionLedger motions_;
  std::vector<std::pair<const char*, std::shared_ptr<int>>> requests_;  ///< how often each was answered
};

/// The ends of all motions, by error id or minus the ending.
std::map<int, int> walk(Planning planning) {
  const unsigned seed = fromEnvironment("COBOT_TEST_SEED", 20240611);
  const unsigned events = fromEnvironment("COBOT_TEST_EVENTS", tenthWhenWatched(150000U));
  constexpr unsigned kRounds = 30;
  std::map<int, int> endings;
  for (unsigned round = 0; round < kRounds; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    Chaos chaos(seed + round, planning);
    for (unsigned i = 0; i < events / kRounds && !::testing::Test::HasFailure(); ++i) {
      chaos.step();
      if (::testing::Test::HasFailure()) ADD_FAILURE() << "at event " << i;
    }
    if (::testing::Test::HasFailure()) break;
    chaos.finish();
    for (const auto& [ending, count] : chaos.endings) endings[ending] += count;
  }
  return endings;
}

/// A walk is worth its time only if it meets the ends that there are.
void expectAllEnds(std::map<int, int> endings) {
  for (const int id : {-static_cast<int>(Ending::Done), -static_cast<int>(Ending::CommandAborted)}) {
    EXPECT_GT(endings[id], 0) << id;
  }
  if (strideWhenWatched() > 1) return;  // too short for all of them
  for (const int id : {motion_error::kReceiveReply, motion_error::kRejected, motion_error::kLinkDropped,
                       motion_error::kMotionFailed, own_error::kNotAtTarget, own_error::kRobotError,
                       own_error::kStopNotConfirmed, own_error::kCommunication, own_error::kNotListening}) {
    EXPECT_GT(endings[id], 0) << id;
  }
}

TEST(RandomEvents, breakNoRule) {
  expectAllEnds(walk(Planning::AtOnce));
}

TEST(RandomEvents, breakNoRuleWhileCommandsArePlannedBesideTheCore) {
  expectAllEnds(walk(Planning::Beside));
}

}  // namespace
}  // namespace cobot_command::testing
