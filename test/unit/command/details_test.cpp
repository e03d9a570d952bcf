// What only one block tells, of its progress and of its end, comes out of the core as it went in.

#include "block_goals.h"
#include "board/output_board.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

struct Planning : CoreRig {
  Planning() : CoreRig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    connect();
    status(StatusFrames());
  }
};

/// How it ended; it has to have.
Outcome endOf(const CoreRig& rig, GoalId id) {
  const Outcome* const outcome = rig.outcome(id);
  EXPECT_NE(outcome, nullptr);
  return outcome != nullptr ? *outcome : Outcome();
}

MoveAbsoluteGoal aside() {
  return moveJoints({20, 0, 90, 0, 90, 0});
}
MoveAbsoluteGoal tooFar() {
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.target = {3000, 0, 300, 180, 0, 90};
  return goal;
}

CheckSequenceGoal sequence(std::vector<SequenceStep> steps) {
  CheckSequenceGoal goal;
  goal.steps = std::move(steps);
  return goal;
}

PickAndPlaceGoal cycleOf(const std::vector<MoveAbsoluteGoal>& moves) {
  PickAndPlaceGoal goal;
  for (const MoveAbsoluteGoal& move : moves) goal.steps.push_back({move, std::nullopt, std::nullopt, 0});
  return goal;
}

/// A block that does not exist yet.
struct Tracked {
  std::vector<int> points;
};

TEST(Details, ofAKindThatTheCoreDoesNotKnowAreHandedOnWithoutACopy) {
  std::vector<Action> actions;
  OutputBoard board(actions);
  constexpr Block kAny = kBlock<MoveAbsoluteGoal>;
  const Detail detail(Tracked{{1, 2, 3}});
  Progress progress;
  progress.detail = detail;
  Outcome outcome;
  outcome.detail = detail;
  board.accept(kAny, 1, 0);
  board.progress(kAny, 1, progress);
  board.end(kAny, 1, outcome);
  board.answer(kAny, 2, outcome);
  board.reject(kAny, 3, toRejection(kAny, {{own_error::kUnreachable, "", "", detail}}));
  int told = 0;
  for (const Action& action : actions) {
    if (const auto* progressed = std::get_if<GoalProgressed>(&action)) {
      EXPECT_EQ(progressed->progress.detail.find<Tracked>(), detail.find<Tracked>());
      ++told;
    }
    if (const auto* ended = std::get_if<GoalEnded>(&action)) {
      EXPECT_EQ(ended->outcome.detail.find<Tracked>(), detail.find<Tracked>());
      ++told;
    }
  }
  EXPECT_EQ(told, 4);
}

TEST(Details, ofAMotionThatIsOnlyCheckedAreItsPath) {
  Planning rig;
  MoveAbsoluteGoal absolute = aside();
  absolute.check_only = true;
  auto relative = good<MoveRelativeGoal>();
  relative.check_only = true;
  const GoalId checks[] = {rig.submit(absolute), rig.submit(relative)};
  for (const GoalId id : checks) {
    ASSERT_EQ(endOf(rig, id).ending, Ending::Done) << endOf(rig, id).error_description;
    ASSERT_NE(endOf(rig, id).detail.find<CheckedMotion>(), nullptr);
    EXPECT_FALSE(endOf(rig, id).detail.as<CheckedMotion>().joint_path.empty());
  }
}

TEST(Details, ofAMotionThatIsMadeAreNone) {
  Planning rig;
  const GoalId id = rig.submit(aside());
  rig.cancel(id);
  rig.discardSent();
  for (const Progress& progress : rig.progress(id)) EXPECT_TRUE(progress.detail.isNone());
  const GoalId refused = rig.submit(tooFar());
  EXPECT_EQ(endOf(rig, refused).ending, Ending::Rejected);
  EXPECT_TRUE(endOf(rig, refused).detail.isNone());
}

TEST(Details, ofASequenceAreWhatWasFoundOfItsSteps) {
  Planning rig;
  const GoalId done = rig.submit(sequence({aside(), aside()}));
  ASSERT_EQ(endOf(rig, done).ending, Ending::Done);
  ASSERT_NE(endOf(rig, done).detail.find<SequenceReport>(), nullptr);
  EXPECT_EQ(endOf(rig, done).detail.as<SequenceReport>().steps.size(), 2U);
  const GoalId refused = rig.submit(sequence({aside(), tooFar()}));
  ASSERT_NE(endOf(rig, refused).detail.find<SequenceReport>(), nullptr);
  EXPECT_EQ(endOf(rig, refused).detail.as<SequenceReport>().failed_step, 1);
}

TEST(Details, ofASequenceThatCannotBeReadAreTheStepWhoseFaultItIs) {
  Planning rig;
  CheckSequenceGoal goal = sequence({aside()});
  goal.steps_fault = "step 3: kind is 9";
  EXPECT_TRUE(endOf(rig, rig.submit(goal)).detail.isNone());
  goal.faulty_step = 2;
  const SequenceReport report = endOf(rig, rig.submit(goal)).detail.as<SequenceReport>();
  EXPECT_EQ(report.failed_step, 2);
  ASSERT_EQ(report.steps.size(), 3U);
  EXPECT_EQ(report.steps[2].error_id, 0);
}

TEST(Details, ofACycleAreWhereItIsAndHowOftenItWasDone) {
  CoreRig rig;
  rig.connect();
  PickAndPlaceGoal goal = cycleOf({CoreRig::move()});
  goal.cycles = 2;
  goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
  const GoalId id = rig.submit(goal);
  const GoalId behind = rig.submit(goal);
  EXPECT_TRUE(rig.progress(behind).back().detail.isNone()) << "it waits";
  for (const int cycle : {1, 2}) {
    rig.reply(rig.takeScript().id);
    EXPECT_EQ(rig.progress(id).back().detail.as<CyclePlace>().cycle, cycle);
    EXPECT_EQ(rig.progress(id).back().detail.as<CyclePlace>().step, 0);
    rig.tag(rig.latest().open_tags.at(0));
  }
  ASSERT_EQ(endOf(rig, id).ending, Ending::Done);
  EXPECT_EQ(endOf(rig, id).detail.as<CycleReport>().cycles_done, 2);
  rig.discardSent();
}

/// By its own rules, by the plan of its steps; and behind its acceptance.
TEST(Details, ofACycleThatIsRefusedOrFailsNameTheStep) {
  Planning rig;
  PickAndPlaceGoal dwelling = cycleOf({aside()});
  dwelling.steps[0].dwell = -1;
  PickAndPlaceGoal slow = cycleOf({aside(), aside()});
  slow.steps[1].move.speed = 0;
  const std::pair<PickAndPlaceGoal, int> refused[] = {
      {dwelling, 0}, {slow, 1}, {cycleOf({aside(), tooFar()}), 1}};
  for (const auto& [goal, step] : refused) {
    const GoalId id = rig.submit(goal);
    ASSERT_EQ(endOf(rig, id).ending, Ending::Rejected);
    ASSERT_NE(endOf(rig, id).detail.find<CycleReport>(), nullptr) << endOf(rig, id).error_description;
    EXPECT_EQ(endOf(rig, id).detail.as<CycleReport>().failed_step, step);
  }
  const GoalId failed = rig.submit(cycleOf({aside(), aside()}));
  rig.reply(rig.takeScript().id, false, {1});
  EXPECT_EQ(endOf(rig, failed).ending, Ending::Aborted);
  EXPECT_EQ(endOf(rig, failed).detail.as<CycleReport>().failed_step, 0);
  EXPECT_FALSE(endOf(rig, failed).detail.as<CycleReport>().steps.at(1).joint_path.empty())
      << "what the check found of it before";
}

}  // namespace
}  // namespace cobot_command::testing
