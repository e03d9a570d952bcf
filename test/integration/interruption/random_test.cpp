// Sequences of motions, interrupted at random moments, end as they do without that.
#include <random>

#include "interrupted_robot.h"
#include "thorough.h"

namespace cobot_command::testing {
namespace {

using Random = std::mt19937;

double between(Random& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}
int below(Random& random, int count) {
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

/// A place in front of the arm.
blocks::SixValues placeIn(Random& random) {
  return {between(random, 400, 520), between(random, -200, 100), between(random, 300, 460), 180, 0,
          between(random, 60, 120)};
}

template <class Goal>
blocks::Goal queued(Random& random, Goal goal) {
  goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
  return below(random, 2) == 0 ? blocks::Goal(goal) : blocks::Goal(blended(between(random, 5, 60), goal));
}

blocks::Goal goalFrom(Random& random) {
  switch (below(random, 6)) {
    case 0:
      return queued(random, lineTo(placeIn(random)));
    case 1: {
      auto goal = lineTo(placeIn(random));
      goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
      goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Cpp);
      goal.speed = 30;
      return queued(random, goal);
    }
    case 2:
      return queued(random, lineBy({0, 0, between(random, -20, 20), 0, 0, between(random, -10, 10)},
                                   blocks::RelativeFormat::Tap));
    case 3: {
      blocks::SetOutputGoal goal{0, "ControlBox", below(random, 16), 1};
      goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
      return goal;
    }
    case 4:
      return inMode(BufferMode::Buffered, blocks::WaitTimeGoal{between(random, 0, 1)});
    default:
      return queued(random, moveJoints({between(random, -20, 20), between(random, -5, 5),
                                        between(random, 80, 100), 0, 90, 0}));
  }
}

/// Where the arm stands in the end; each goal is done, or refused as it would be without an interruption.
arm::JointVector endOfAll(const std::vector<blocks::Goal>& goals, Random* interrupts,
                          std::vector<blocks::Ending>& ends) {
  InterruptedRobot rig;
  std::vector<GoalId> ids;
  ids.reserve(goals.size());
  for (const blocks::Goal& goal : goals) ids.push_back(rig.submit(goal));
  // The last ones may be blended: done with their acceptance.
  const auto is_over = [&] {
    const bool all_ended =
        std::all_of(ids.begin(), ids.end(), [&](GoalId id) { return rig.outcome(id) != nullptr; });
    if (!all_ended || !rig.stands()) return false;
    rig.pass(300ms);
    return rig.stands();
  };
  while (interrupts != nullptr && !is_over()) {
    rig.pass(std::chrono::milliseconds(below(*interrupts, 1200)));
    const auto answer = rig.interruptNow();
    if (!answer.success) {
      EXPECT_EQ(answer.error_id, 0x233) << answer.message;
      continue;
    }
    rig.pass(300ms);
    EXPECT_TRUE(rig.stands());
    const auto on = rig.goOn();
    EXPECT_TRUE(on.success) << on.message;
  }
  EXPECT_TRUE(rig.passUntil(is_over, 2min)) << "goals without an end";
  for (const GoalId id : ids) {
    const blocks::Outcome* const outcome = rig.outcome(id);
    ends.push_back(outcome != nullptr ? outcome->ending : Ending::CommandAborted);
    if (outcome != nullptr && outcome->ending == Ending::Aborted) {
      ADD_FAILURE() << outcome->error_id << " " << outcome->error_description;
    }
  }
  return rig.robot().joints;
}

TEST(InterruptionsAtRandom, loseNothingOfASequence) {
  const unsigned first = fromEnvironment("COBOT_TEST_SEED", 20261125);
  const unsigned rounds = fromEnvironment("COBOT_TEST_SEEDS", 40);
  for (unsigned seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE(::testing::Message() << "COBOT_TEST_SEED=" << seed);
    Random random(seed);
    std::vector<blocks::Goal> goals;
    goals.reserve(8);
    for (int i = 0; i < 8; ++i) goals.push_back(goalFrom(random));
    std::vector<Ending> plain;
    std::vector<Ending> interrupted;
    const arm::JointVector wanted = endOfAll(goals, nullptr, plain);
    const arm::JointVector found = endOfAll(goals, &random, interrupted);
    EXPECT_EQ(interrupted, plain);
    EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), degToRad(0.05));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace cobot_command::testing
