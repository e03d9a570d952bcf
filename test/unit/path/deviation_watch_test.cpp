// The arm against its plan: what is late, and what is off the path.
#include "cobot_command/path/deviation_watch.h"

#include <cmath>

#include "path_support.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

class Deviations : public Paths {
 protected:
  /// A line, a corner, another line.
  [[nodiscard]] PathPlan corner() const {
    return planned(
        {blending(incremental(toPose({0, 100, 0, 0, 0, 0})), 10), incremental(toPose({0, 0, 100, 0, 0, 0}))});
  }
  /// A stream of 66 frames a second, of an arm that is late, and has an error of each joint [rad].
  [[nodiscard]] Deviation seen(const PathPlan& plan, Duration late, double error = 0.0) const {
    DeviationWatch watch(scene.arm, plan);
    for (Duration time{}; time <= plan.duration() + late; time += milliseconds(15)) {
      watch.add(time, plan.at(time - late).position.array() + error);
    }
    return watch.deviation();
  }
};

TEST_F(Deviations, areNoneOfAnArmThatGoesAsPlanned) {
  const Deviation none = seen(corner(), {});
  EXPECT_EQ(none.joint, 0.0);
  EXPECT_LT(none.path, 1e-9);
  EXPECT_NEAR(none.lag, 0.0, 1e-6);
}

TEST_F(Deviations, tellHowLateAnArmIsThatStaysOnThePath) {
  for (const int late : {10, 50, 137, 310}) {
    const Deviation found = seen(corner(), milliseconds(late));
    EXPECT_NEAR(found.lag, 1e-3 * late, 4e-3);
    EXPECT_LT(mToMm(found.path), 0.01) << late;
    EXPECT_GT(found.joint, 0.0);
  }
}

TEST_F(Deviations, tellHowFarAnArmIsOffThePath) {
  const Deviation found = seen(corner(), {}, degToRad(0.1));
  EXPECT_NEAR(found.joint, degToRad(0.1), 1e-9);
  EXPECT_GT(mToMm(found.path), 0.5);
  EXPECT_LT(mToMm(found.path), 5.0);
}

TEST_F(Deviations, tellTheLastSampleToo) {
  const PathPlan plan = corner();
  DeviationWatch watch(scene.arm, plan);
  watch.add(milliseconds(500), plan.at(milliseconds(500)).position.array() + degToRad(0.1));
  EXPECT_GT(mToMm(watch.offThePath()), 0.1);
  watch.add(milliseconds(515), plan.at(milliseconds(515)).position);
  EXPECT_LT(mToMm(watch.offThePath()), 1e-6);
  EXPECT_GT(mToMm(watch.deviation().path), 0.1);
}

TEST_F(Deviations, ignoreWhatIsNoNumber) {
  const PathPlan plan = corner();
  DeviationWatch watch(scene.arm, plan);
  watch.add(milliseconds(500), plan.at(milliseconds(500)).position.array() + degToRad(0.1));
  const double before = watch.offThePath();
  watch.add(milliseconds(515), arm::JointVector::Constant(std::nan("")));
  EXPECT_EQ(watch.offThePath(), before);
  EXPECT_GT(watch.deviation().path, 0.0);
}

TEST_F(Deviations, ofAnArmThatStandsAreNone) {
  EXPECT_EQ(seen(planned({toJoints({0, 0, 90, 0, 90, 0})}), {}).lag, 0.0);
}

}  // namespace
}  // namespace cobot_command::path
