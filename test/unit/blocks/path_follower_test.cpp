// Where the arm is on a piece of a path, and how far from it: also where the command layer was late itself.
#include "paths/path_follower.h"

#include "block_goals.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

using std::chrono::milliseconds;

class PathFollowing : public ::testing::Test {
 protected:
  /// A turn and two lines, blended.
  static LoadedPiecePtr piece() {
    path::PathSection section;
    section.points = {testing::pathPoint({40, 0, 90, 0, 90, 0}), testing::pathPoint({40, -10, 100, 0, 90, 0}),
                      testing::pathPoint({0, 0, 90, 0, 90, 0})};
    for (path::PathPoint& point : section.points) {
      point.termination_type = static_cast<int>(path::Termination::Blend);
      point.command_tolerance = 20;
    }
    section.number_of_moves = 3;
    path::PathPlanner planner({arm(), arm::toJointVector({0, 0, 90, 0, 90, 0})});
    EXPECT_EQ(planner.append(section), std::nullopt);
    return std::make_shared<const LoadedPiece>(LoadedPiece{planner.plan(), {}});
  }
  static arm::ArmModel arm() { return *arm::ArmModel::named("tm5-900"); }

  /// Of an arm that goes `lag` behind its plan, seen by a layer that hears of the begin so much later.
  static path::Deviation seen(Duration hears_late, Duration lag) {
    const LoadedPiecePtr followed = piece();
    PathFollower follower(arm(), followed, 1.0, Instant{} + hears_late);
    const Duration end = followed->plan.duration() + lag;
    for (Duration time = hears_late; time <= end; time += milliseconds(15)) {
      follower.see(followed->plan.at(time - lag).position, Instant{} + time);
    }
    return follower.deviation();
  }
};

TEST_F(PathFollowing, findsNoDeviationWhereTheArmGoesAsPlanned) {
  const path::Deviation found = seen({}, {});
  EXPECT_LT(radToDeg(found.joint), 1e-6);
  EXPECT_LT(mToMm(found.path), 1e-6);
  EXPECT_NEAR(found.lag, 0.0, 1e-3);
}

/// As on a machine with much other work: max_deviation would stop the robot for that.
TEST_F(PathFollowing, doesNotBlameTheArmForHearingLateThatItHasBegun) {
  for (const int late : {5, 30, 118, 350}) {
    const path::Deviation found = seen(milliseconds(late), {});
    EXPECT_LT(mToMm(found.path), 0.1) << late;
    EXPECT_LT(radToDeg(found.joint), 1.0) << late;
    EXPECT_LT(found.lag, 0.01) << late;
  }
}

TEST_F(PathFollowing, tellsOfAnArmThatIsLateItself) {
  for (const int lag : {20, 100, 200}) {
    const path::Deviation found = seen({}, milliseconds(lag));
    EXPECT_NEAR(found.lag, 1e-3 * lag, 5e-3);
    EXPECT_LT(mToMm(found.path), 0.1) << lag;
    EXPECT_GT(radToDeg(found.joint), 0.5) << lag;
  }
}

}  // namespace
}  // namespace cobot_command::blocks
