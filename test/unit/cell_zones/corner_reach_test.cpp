// How much of two motions a corner can have, at whatever project speed each of them is made.
#include <algorithm>

#include "planned_step.h"
#include "random_program.h"
#include "thorough.h"
#include <gtest/gtest.h>

#include "cobot_command/motion/blend.h"

namespace cobot_command::cell {
namespace {

/// What a motion is made of at any project speed.
struct TwoSteps {
  Step before;
  Step next;
  Scene scene;
};

/// Nothing: they cannot be made one behind the other.
std::optional<std::pair<motion::TrajectoryPtr, motion::TrajectoryPtr>> planned(const TwoSteps& steps,
                                                                               double speed_before,
                                                                               double speed_next) {
  const auto order_of = [&](const Step& step) {
    return std::visit([&](const auto& goal) { return orderOf(goal, steps.scene.base); }, step.goal);
  };
  planning::ScriptPlanner planner(tm5(),
                                  {steps.scene.joints, steps.scene.base, steps.scene.tcp, speed_before});
  const auto before = planner.append(order_of(steps.before).commands->front());
  if (!before || !before->trajectory) return std::nullopt;
  planning::ScriptPlanner::Start start = planner.end();
  start.speed_override = speed_next;
  planning::ScriptPlanner behind(tm5(), start);
  const auto next = behind.append(order_of(steps.next).commands->front());
  if (!next || !next->trajectory) return std::nullopt;
  return std::make_pair(before->trajectory, next->trajectory);
}

motion::Blend anyBlend(RandomSteps& random) {
  if (random.coin()) return motion::BlendShare{random.within(0.05, 1.0)};
  return motion::BlendRadius{random.within(0.002, 0.2)};
}

TwoSteps anySteps(RandomSteps& random) {
  TwoSteps steps;
  steps.scene = random.scene();
  steps.before = random.coin() ? random.line(steps.scene) : random.ptp(steps.scene);
  Scene behind = steps.scene;
  const auto before = plannedStep(steps.before, steps.scene);
  if (before) behind.joints = before->trajectory->end().position;
  steps.next = random.coin() ? random.line(behind) : random.ptp(behind);
  return steps;
}

/// How far joints are from where a motion is at its nearest of many moments in an interval [rad].
double awayFrom(const motion::Trajectory& trajectory, Duration from, Duration to,
                const arm::JointVector& joints) {
  double least = 1e9;
  constexpr int kMoments = 1000;
  for (int i = 0; i <= kMoments; ++i) {
    const auto there = trajectory.at(from + (to - from) * i / kMoments).position;
    least = std::min(least, (there - joints).cwiseAbs().maxCoeff());
  }
  return least;
}

TEST(TheReachOfACorner, hasWhatAnySpeedsOfBothMotionsMakeOfIt) {
  const int corners = testing::quickOrThorough(100, 5000);
  RandomSteps random(40);
  int found = 0;
  for (int tries = 0; found < corners && tries < 20 * corners; ++tries) {
    const TwoSteps steps = anySteps(random);
    const motion::Blend blend = anyBlend(random);
    const auto full = planned(steps, 1.0, 1.0);
    const auto slow = planned(steps, random.within(0.05, 1.0), random.within(0.05, 1.0));
    if (!full || !slow) continue;
    const motion::Corner corner{*slow->first, *slow->second, steps.scene.tcp};
    const Duration overlap = motion::overlapAt(tm5(), corner, blend);
    if (overlap <= Duration::zero()) continue;
    ++found;
    const auto reach = motion::cornerReach(tm5(), {*full->first, *full->second, steps.scene.tcp}, blend);
    const Duration end = full->first->duration();
    const auto first = slow->first->at(slow->first->duration() - overlap).position;
    const auto last = slow->second->at(overlap).position;
    // As near as the moments of a corner are to each other.
    constexpr double kNear = 2e-3;
    EXPECT_LT(awayFrom(*full->first, end - reach.before, end, first), kNear) << tries;
    EXPECT_LT(awayFrom(*full->second, Duration::zero(), reach.next, last), kNear) << tries;
  }
  EXPECT_EQ(found, corners);
}

TEST(TheReachOfACorner, isNothingWithoutABlend) {
  RandomSteps random(41);
  for (int tries = 0; tries < 50; ++tries) {
    const TwoSteps steps = anySteps(random);
    const auto full = planned(steps, 1.0, 1.0);
    if (!full) continue;
    const motion::Corner corner{*full->first, *full->second, steps.scene.tcp};
    for (const motion::Blend& none :
         {motion::Blend(motion::BlendShare{0.0}), motion::Blend(motion::BlendRadius{0.0})}) {
      const auto reach = motion::cornerReach(tm5(), corner, none);
      EXPECT_EQ(std::min(reach.before, reach.next), Duration::zero());
    }
  }
}

}  // namespace
}  // namespace cobot_command::cell
