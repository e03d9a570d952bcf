// What is called for every millisecond of a path takes no memory.
#include "cobot_command/arm/wrist_inverse.h"

#include "failing_allocation.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::allocation {
namespace {

TEST(WristInverse, allocatesNothing) {
  const arm::ArmModel model = *arm::ArmModel::named("tm5-900");
  const arm::WristArm wrist_arm(model, arm::Pose::Identity());
  arm::JointVector joints;
  joints << 0.3, -0.2, 1.5, 0.1, 1.2, -0.7;
  const Eigen::Vector3d origin = arm::forwardKinematics(model, joints).translation();
  const FailingAllocation failing(1);
  failing.during([&] {
    const auto found = wrist_arm.solve(joints.tail<3>(), origin, wrist_arm.branchOf(joints), joints);
    EXPECT_TRUE(found && found->isApprox(joints, 1e-9));
    EXPECT_EQ(wrist_arm.solutions(joints.tail<3>(), origin).size(), 4U);
    EXPECT_GT(wrist_arm.singularityDistance(joints).elbow, 0.1);
  });
  EXPECT_FALSE(failing.happened());
}

}  // namespace
}  // namespace cobot_command::allocation
