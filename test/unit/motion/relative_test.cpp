#include <limits>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

using Axes = PoseOffset::Axes;

const arm::Pose kOffset = moved(arm::Pose::Identity(), 0.03, -0.02, 0.04, 0.3, {1, 2, -1});

arm::Pose tcpAfter(const Command& command, const Setting& setting) {
  const arm::ArmModel arm = model();
  const auto motion = planned(plan(arm, workingPosture(), command, setting));
  return motion ? tcpAt(arm, motion->end().position, setting) : arm::Pose::Identity();
}

TEST(RelativeMotion, addsJointOffsetsToTheStart) {
  const auto motion = planned(plan(model(), workingPosture(),
                                   MovePtp{degrees(1, -2, 3, -4, 5, -6), 0.5, milliseconds(200)}, Setting{}));
  EXPECT_EQ(motion->end().position, arm::JointVector(workingPosture() + degrees(1, -2, 3, -4, 5, -6)));
}

TEST(RelativeMotion, shiftsAndTurnsAlongTheAxesOfTheBase) {
  const Setting setting = displacedSetting();
  const arm::Pose start = tcpAt(model(), workingPosture(), setting);
  const arm::Pose expected = moved(start, 0.03, -0.02, 0.04, 0.3, {1, 2, -1});
  for (const Command& command :
       {Command(MovePtp{PoseOffset{kOffset, Axes::Base}, 0.5, milliseconds(200)}),
        Command(MoveLine{PoseOffset{kOffset, Axes::Base}, TcpSpeed{0.1}, milliseconds(200)})}) {
    EXPECT_TRUE(tcpAfter(command, setting).isApprox(expected, 1e-9));
  }
}

TEST(RelativeMotion, shiftsAndTurnsInTheTool) {
  const Setting setting = displacedSetting();
  const arm::Pose expected = tcpAt(model(), workingPosture(), setting) * kOffset;
  for (const Command& command :
       {Command(MovePtp{PoseOffset{kOffset, Axes::Tool}, 0.5, milliseconds(200)}),
        Command(MoveLine{PoseOffset{kOffset, Axes::Tool}, TcpSpeed{0.1}, milliseconds(200)})}) {
    EXPECT_TRUE(tcpAfter(command, setting).isApprox(expected, 1e-9));
  }
}

TEST(RelativeMotion, takesTheTimeOfTheMotionToTheSamePlace) {
  const arm::ArmModel arm = model();
  const arm::Pose target = tcpAt(arm, workingPosture(), {}) * kOffset;
  const auto relative =
      planned(plan(arm, workingPosture(),
                   MoveLine{PoseOffset{kOffset, Axes::Tool}, SpeedRatio{0.2}, milliseconds(300)}, Setting{}));
  const auto direct =
      planned(plan(arm, workingPosture(), Line{target, SpeedRatio{0.2}, milliseconds(300)}, Setting{}));
  EXPECT_EQ(relative->duration(), direct->duration());
}

TEST(RelativeMotion, isRefusedByTheNameOfTheOffset) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PoseOffset no_number{arm::Pose::Identity(), Axes::Base};
  no_number.by.translation().x() = nan;
  PoseOffset no_rotation{arm::Pose::Identity(), Axes::Tool};
  no_rotation.by.linear() *= 1.1;
  const struct {
    Command command;
    Refusal::Reason reason;
    const char* word;
  } cases[] = {
      {MovePtp{degrees(0, nan, 0, 0, 0, 0), 0.5, milliseconds(200)}, Refusal::Reason::NotFinite,
       "joint offset"},
      {MovePtp{no_number, 0.5, milliseconds(200)}, Refusal::Reason::NotFinite, "the offset"},
      {MoveLine{no_number, SpeedRatio{0.5}, milliseconds(200)}, Refusal::Reason::NotFinite, "the offset"},
      {MoveLine{no_rotation, SpeedRatio{0.5}, milliseconds(200)}, Refusal::Reason::BadParameter,
       "orientation of the offset"},
      {MovePtp{no_rotation, 0.0, milliseconds(200)}, Refusal::Reason::BadParameter,
       "orientation of the offset"},
      {MovePtp{degrees(0, 0, 0, 0, 0, 1), 0.0, milliseconds(200)}, Refusal::Reason::BadParameter, "speed"},
      {MoveLine{{}, SpeedRatio{0.5}, milliseconds(-1)}, Refusal::Reason::BadParameter, "time to top speed"},
  };
  for (const auto& wrong : cases) {
    const auto result = plan(model(), workingPosture(), wrong.command, Setting{});
    ASSERT_FALSE(result.has_value()) << wrong.word;
    EXPECT_EQ(result.error().reason, wrong.reason) << result.error().message;
    EXPECT_NE(result.error().message.find(wrong.word), std::string::npos) << result.error().message;
  }
}

TEST(RelativeMotion, isRefusedWhereItLeadsOutOfReach) {
  PoseOffset far{arm::Pose::Identity(), Axes::Base};
  far.by.translation().x() = 2.0;
  const auto result = plan(model(), workingPosture(), MovePtp{far, 0.5, milliseconds(200)}, Setting{});
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().reason, Refusal::Reason::Unreachable);
}

}  // namespace
}  // namespace cobot_command::motion
