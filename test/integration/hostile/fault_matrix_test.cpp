// Every fault with a goal of every block: no hang, no crash, no success that did not happen, one end for each
// goal, an ErrorID that names the cause, and the next connect works.
//
// The blocks of a row run side by side, each with a robot, a proxy and a command layer of its own. Which of
// the variants of a row a block meets, and what is drawn at random, follows from the seed; COBOT_TEST_SEEDS
// says how many there are (1).
#include <algorithm>
#include <cctype>
#include <regex>
#include <thread>

#include "fault_rows.h"
#include "thorough.h"
#include <gmock/gmock.h>

namespace cobot_command::hostile {
namespace {

using blocks::Block;
using blocks::Ending;
using blocks::GoalId;
using blocks::Outcome;
using blocks::Phase;
using ::testing::Contains;

unsigned seeds() {
  return std::max(1U, testing::fromEnvironment("COBOT_TEST_SEEDS", 1));
}

/// For the stop block, and long enough for anything.
blocks::MoveAbsoluteGoal longMove() {
  return runtime::moveJoints({160, 0, 90, 0, 90, 0}, 1);
}

/// One goal that meets one variant of a fault.
class Trial {
 public:
  Trial(const Variant& variant, BlockCase block, unsigned seed)
      : variant_(variant), block_(std::move(block)), random_(seed), rig_(seed) {}

  void run() {
    link_ = rig_.connect();
    if (block_.block == blocks::kBlock<blocks::StopGoal>) {
      const GoalId move = rig_.layer.submit(longMove());
      ASSERT_TRUE(rig_.layer.reaches(move, Phase::Active));
    }
    variant_.before(rig_, random_);
    const GoalId goal = rig_.layer.submit(block_.goal);
    if (variant_.meanwhile) haveItHappen(goal);
    const auto outcome = rig_.layer.endOf(goal);
    ASSERT_TRUE(outcome.has_value()) << "the goal has no end";
    if (outcome->ending == Ending::Done) expectNoLie(block_);
    if (!isDroppedBeforeItsTurn(goal, *outcome)) expectRightEnd(*outcome);
    if (variant_.stops_robot && block_.awaits_tag) expectStoppedOnTheWay();
    connectAnew();
    rig_.layer.stop();
    for (const auto& [id, ends] : rig_.layer.told().ends) EXPECT_EQ(ends.size(), 1u) << "goal " << id;
  }

 private:
  void haveItHappen(GoalId goal) {
    ASSERT_TRUE(rig_.layer.waitUntil([&](const Told& told) {
      return told.ended(goal) || told.reached(goal, Phase::Active) || told.reached(goal, Phase::Held);
    }));
    if (!rig_.layer.told().ended(goal)) variant_.meanwhile(rig_);
  }

  /// What a tag vouches for is so by now; all else is only under way, as its OK told.
  void expectNoLie(const BlockCase& done) {
    const auto deadline = std::chrono::steady_clock::now() + testing::kDeadline;
    std::string lie = done.lie(rig_.robot().state());
    while (!lie.empty() && !done.awaits_tag && done.block != blocks::kBlock<blocks::StopGoal> &&
           std::chrono::steady_clock::now() < deadline) {
      lie = done.lie(rig_.robot().state());
    }
    EXPECT_EQ(lie, "") << "a success that did not happen";
  }

  void expectStoppedOnTheWay() {
    const auto deadline = std::chrono::steady_clock::now() + testing::kDeadline;
    while (rig_.robot().state().in_motion && std::chrono::steady_clock::now() < deadline) {
    }
    EXPECT_NE(block_.lie(rig_.robot().state()), "") << "the robot went on to where the failed goal sent it";
  }

  /// A path is planned before its first command: on a busy machine the link may be lost by then.
  [[nodiscard]] bool isDroppedBeforeItsTurn(GoalId goal, const Outcome& outcome) const {
    const auto told = rig_.layer.told();
    const bool has_begun = told.reached(goal, Phase::Sent) || told.reached(goal, Phase::Active) ||
                           told.reached(goal, Phase::Held);
    return block_.block == blocks::kBlock<blocks::LoadPathGoal> && !has_begun &&
           outcome.ending == Ending::CommandAborted && variant_.ends.done != Ends::Done::Must &&
           outcome.error_description.find("the link was lost") == 0;
  }

  void expectRightEnd(const Outcome& outcome) const {
    const auto done = doneFor(block_, variant_.ends);
    if (outcome.ending == Ending::Done) {
      EXPECT_NE(done, Ends::Done::Never) << "it cannot have been done";
      return;
    }
    EXPECT_NE(done, Ends::Done::Must) << outcome.error_description;
    EXPECT_NE(outcome.ending, Ending::CommandAborted) << outcome.error_description;
    EXPECT_THAT(allowedFor(block_, variant_.ends), Contains(outcome.error_id)) << outcome.error_description;
    EXPECT_NE(blocks::findError(block_.block, outcome.error_id), nullptr);
    EXPECT_FALSE(outcome.remedy.empty());
    std::smatch inner;  // what of a cycle failed, and why
    if (block_.block == blocks::kBlock<blocks::PickAndPlaceGoal> &&
        std::regex_search(outcome.error_description, inner, std::regex("cycle 1: 16#([0-9A-F]+)"))) {
      EXPECT_THAT(variant_.ends.ids, Contains(std::stoi(inner[1], nullptr, 16))) << outcome.error_description;
    }
  }

  /// With nothing left of the fault, nor of what it held back.
  void connectAnew() {
    rig_.layer.cancel(link_);
    ASSERT_TRUE(rig_.layer.endOf(link_).has_value()) << "the connect goal has no end";
    rig_.proxy.reset();
    rig_.proxy.heal();
    rig_.operate(simulator::ClearFaults{});
    const auto robot = rig_.robot().state();
    if (robot.emergency_stop) rig_.operate(simulator::SetEmergencyStop{false});
    if (!robot.project_running) rig_.operate(simulator::RunProject{});
    if (robot.project_paused) rig_.operate(simulator::ResumeProject{});
    rig_.operate(simulator::EnterListenNode{});
    (void)rig_.connect();
    BlockCase proof = proofOfWork();
    std::get<blocks::MoveAbsoluteGoal>(proof.goal).buffer_mode =
        static_cast<int>(blocks::BufferMode::Buffered);
    const auto outcome = rig_.layer.endOf(rig_.layer.submit(proof.goal));
    ASSERT_TRUE(outcome.has_value()) << "the goal behind the next connect has no end";
    EXPECT_EQ(outcome->ending, Ending::Done)
        << "behind the next connect: " << outcome->error_id << ' ' << outcome->error_description;
    expectNoLie(proof);
  }

  const Variant& variant_;
  const BlockCase block_;
  Random random_;
  HostileRig rig_;
  GoalId link_ = 0;
};

void tryOne(const Variant& variant, std::size_t block, unsigned seed) {
  const BlockCase chosen = blockCases(variant.pace).at(block);
  SCOPED_TRACE(std::string(blocks::toString(chosen.block)) + " with \"" + variant.name + "\", seed " +
               std::to_string(seed));
  Trial(variant, chosen, seed).run();
}

/// All that one block meets of a row.
void tryBlock(const FaultRow& row, std::size_t block) {
  for (unsigned seed = 1; seed <= seeds(); ++seed) {
    if (row.all_at_once) {
      for (const Variant& variant : row.variants) tryOne(variant, block, seed);
    } else {
      tryOne(row.variants.at((seed + block) % row.variants.size()), block, seed);
    }
  }
}

class FaultMatrix : public ::testing::TestWithParam<FaultRow> {};

TEST_P(FaultMatrix, endsEveryGoalInTheWayThatNamesTheCause) {
  std::vector<std::thread> threads;
  for (std::size_t block = 0; block < blockCases(Pace::Quick).size(); ++block) {
    threads.emplace_back([&, block] { tryBlock(GetParam(), block); });
  }
  for (std::thread& thread : threads) thread.join();
}

const auto kNameOfRow = [](const auto& row) { return row.param.name; };
INSTANTIATE_TEST_SUITE_P(Each, FaultMatrix, ::testing::ValuesIn(faultRows()), kNameOfRow);

}  // namespace
}  // namespace cobot_command::hostile
