// Half a turn can be made either way round: a plan of it is refused, the arm itself makes it.
#include <vector>

#include "motion_support.h"
#include <gmock/gmock.h>

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;
using ::testing::HasSubstr;

constexpr double kDegree = degToRad(1.0);
const arm::JointVector kStart = degrees(10, 15, 80, -5, 85, 20);

Setting forecast() {
  Setting setting = displacedSetting();
  setting.start_tolerance = kDegree;
  return setting;
}

arm::Pose start() {
  return tcpAt(model(), kStart, forecast());
}

/// Where J6 alone takes the TCP.
arm::Pose turned(double turn_deg) {
  return tcpAt(model(), kStart + degrees(0, 0, 0, 0, 0, turn_deg), forecast());
}

constexpr TcpSpeed kSpeed{0.05};

Line line(double turn_deg) {
  return {turned(turn_deg), kSpeed, milliseconds(200)};
}

std::vector<Command> motionsThatTurn(double turn_deg) {
  const arm::Pose end = turned(turn_deg);
  arm::Pose middle = moved(start(), 0.0, 0.0, 0.02);
  middle.translation() += 0.5 * (end.translation() - start().translation());
  const arm::Pose offset = start().inverse() * end;
  return {line(turn_deg),
          Circle{middle, end, std::nullopt, kSpeed, milliseconds(200)},
          PLine{end, kSpeed, milliseconds(200)},
          MoveLine{{offset, PoseOffset::Axes::Tool}, kSpeed, milliseconds(200)},
          MovePLine{PoseOffset{offset, PoseOffset::Axes::Tool}, kSpeed, milliseconds(200)},
          Ptp{PoseTarget{end, {}}, 0.5, milliseconds(200)},
          MovePtp{PoseOffset{offset, PoseOffset::Axes::Tool}, 0.5, milliseconds(200)},
          Pvt{std::vector<PvtPosePoint>{{end, {}, 2.0}}}};
}

std::string answer(const Command& command, const Setting& setting) {
  const auto result = plan(model(), kStart, command, setting);
  return result ? "planned" : toString(result.error().reason);
}

TEST(HalfTurn, isRefusedInAPlanWhateverMotionMakesIt) {
  for (const double turn : {179.1, 180.0, -180.0, -179.1, 180.9}) {
    for (const Command& command : motionsThatTurn(turn)) {
      EXPECT_EQ(answer(command, forecast()), "AMBIGUOUS_TURN") << turn << ", kind " << command.index();
    }
  }
}

TEST(HalfTurn, isRefusedNoFurtherFromHalfATurnThanTheStartIsUncertain) {
  for (const double turn : {178.9, -178.9, 181.1, 90.0}) {
    for (const Command& command : motionsThatTurn(turn)) {
      EXPECT_EQ(answer(command, forecast()), "planned") << turn << ", kind " << command.index();
    }
  }
}

TEST(HalfTurn, isMadeByTheArmItself) {
  for (const Command& command : motionsThatTurn(180.0)) {
    EXPECT_EQ(answer(command, displacedSetting()), "planned") << "kind " << command.index();
  }
}

TEST(HalfTurn, saysWhatTurnsByHowMuchAndWhatToDo) {
  const auto path = plan(model(), kStart, line(179.5), forecast());
  ASSERT_FALSE(path);
  EXPECT_THAT(path.error().message, HasSubstr("the line turns the TCP by 179.50 deg"));
  EXPECT_THAT(path.error().message, HasSubstr("add an intermediate point"));
  EXPECT_LT(distance(path.error().point, turned(179.5)), 1e-9);
  const auto ptp =
      plan(model(), kStart, Ptp{PoseTarget{turned(179.5), {}}, 0.5, milliseconds(200)}, forecast());
  ASSERT_FALSE(ptp);
  EXPECT_EQ(ptp.error().joint, 5);
  EXPECT_THAT(ptp.error().message, HasSubstr("J6 turns by"));
  EXPECT_THAT(ptp.error().message, HasSubstr("give the target as joints"));
}

TEST(HalfTurn, isNoQuestionWhereTheTargetIsGivenAsJoints) {
  const arm::JointVector target = kStart + degrees(0, 0, 0, 0, 0, 180);
  EXPECT_EQ(answer(Ptp{target, 0.5, milliseconds(200)}, forecast()), "planned");
  EXPECT_EQ(answer(MovePtp{degrees(0, 0, 0, 0, 0, 180), 0.5, milliseconds(200)}, forecast()), "planned");
}

TEST(HalfTurn, isNoQuestionOnAnArcThatHoldsTheOrientation) {
  const Circle circle{moved(start(), 0.0, 0.03, 0.0), turned(180.0), degToRad(90), kSpeed, milliseconds(200)};
  EXPECT_EQ(answer(circle, forecast()), "planned");
}

TEST(HalfTurn, isNoQuestionForAPtpWhereOneWayRoundLeavesTheLimits) {
  // J6 from 100 to -80 deg, or to 280 deg, which the arm cannot.
  const arm::JointVector from = degrees(10, 15, 80, -5, 85, 100);
  const arm::Pose target = arm::forwardKinematics(model(), degrees(10, 15, 80, -5, 85, -80));
  Setting setting;
  setting.start_tolerance = kDegree;
  const TrajectoryPtr motion =
      planned(plan(model(), from, Ptp{PoseTarget{target, {}}, 0.5, milliseconds(200)}, setting));
  EXPECT_NEAR(radToDeg(motion->end().position[5]), -80, 1e-6);
}

}  // namespace
}  // namespace cobot_command::motion
