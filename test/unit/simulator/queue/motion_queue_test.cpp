// The queue by itself, without the controller around it.
#include "queue/motion_queue.h"

#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::simulator {
namespace {

using namespace std::chrono_literals;

const arm::ArmModel& model() {
  static const arm::ArmModel instance = *arm::ArmModel::named("tm5-900");
  return instance;
}

MotionRequest turnOfFirstJoint() {
  script::Ptp ptp;
  ptp.format.target = script::DataFormat::Target::Joint;
  ptp.target = {90, 0, 90, 0, 90, 0};
  ptp.options = {100, 200, 0, false};
  return ptp;
}

/// On the way of the first joint to 90 degrees.
class MotionQueueTest : public ::testing::Test {
 protected:
  MotionQueueTest() {
    queue_.push(turnOfFirstJoint());
    queue_.run(now_);
    now_ += 300ms;
  }
  void waitUntilNothingIsDue() {
    while (queue_.nextEvent() != Instant::max()) {
      now_ = queue_.nextEvent();
      queue_.run(now_);
    }
  }
  double firstJointDeg() const { return radToDeg(queue_.arm().at(now_).position[0]); }

  FaultSwitches faults_;
  MotionQueue queue_{model(), arm::toJointVector({0, 0, 90, 0, 90, 0}), {200ms, true}, faults_};
  Instant now_{};
};

TEST_F(MotionQueueTest, letsAPausedArmGoOnWithASettingThatIsReset) {
  queue_.pause(now_);
  waitUntilNothingIsDue();
  ASSERT_LT(firstJointDeg(), 89);
  now_ += 1s;
  queue_.resetSetting(arm::Pose::Identity(), now_);
  EXPECT_FALSE(queue_.paused());
  waitUntilNothingIsDue();
  EXPECT_NEAR(firstJointDeg(), 90, 1e-9);
  EXPECT_TRUE(queue_.idle());
}

TEST_F(MotionQueueTest, leavesAnArmThatASafeguardHoldsWhereItIs) {
  queue_.pause(now_);
  queue_.pause(now_, Holder::Safeguard);
  queue_.resetSetting(arm::Pose::Identity(), now_ + 1s);
  waitUntilNothingIsDue();
  EXPECT_LT(firstJointDeg(), 89);
  queue_.resume(now_ + 2s, Holder::Safeguard);
  waitUntilNothingIsDue();
  EXPECT_NEAR(firstJointDeg(), 90, 1e-9);
}

}  // namespace
}  // namespace cobot_command::simulator
