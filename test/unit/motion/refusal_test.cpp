#include <cmath>
#include <regex>
#include <string>

#include "motion_support.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/inverse_kinematics.h"

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;
using ::testing::HasSubstr;

Refusal refused(const Result<TrajectoryPtr, Refusal>& result) {
  if (result) {
    ADD_FAILURE() << "planned, not refused";
    return {};
  }
  return result.error();
}

Line slowLine(const arm::Pose& target) {
  return {target, SpeedRatio{0.1}, milliseconds(200)};
}

TEST(Refusal, namesEveryReason) {
  EXPECT_STREQ(toString(Reason::NotFinite), "NOT_FINITE");
  EXPECT_STREQ(toString(Reason::BadParameter), "BAD_PARAMETER");
  EXPECT_STREQ(toString(Reason::Unreachable), "UNREACHABLE");
  EXPECT_STREQ(toString(Reason::PoseBits), "POSE_BITS");
  EXPECT_STREQ(toString(Reason::JointLimit), "JOINT_LIMIT");
  EXPECT_STREQ(toString(Reason::JointSpeed), "JOINT_SPEED");
  EXPECT_STREQ(toString(Reason::Singular), "SINGULAR");
  EXPECT_STREQ(toString(Reason::DegenerateCircle), "DEGENERATE_CIRCLE");
  EXPECT_STREQ(toString(Reason::AmbiguousTurn), "AMBIGUOUS_TURN");
}

TEST(PtpRefusal, namesTheJointOutsideItsLimitsAndWhatIsAllowed) {
  const arm::JointVector target = degrees(0, 0, 157.2, 0, 90, 0);
  const Refusal refusal =
      refused(plan(model(), workingPosture(), Ptp{target, 0.5, milliseconds(200)}, displacedSetting()));
  EXPECT_EQ(refusal.reason, Reason::JointLimit);
  EXPECT_EQ(refusal.joint, 2);
  EXPECT_EQ(refusal.at, 1.0);
  EXPECT_LT(distance(refusal.point, tcpAt(model(), target, displacedSetting())), 1e-12);
  EXPECT_THAT(refusal.message, HasSubstr("J3 at 157.20 deg, allowed -155.0..155.0 deg"));
}

TEST(PtpRefusal, tellsOutOfReachAndImpossibleBitsApart) {
  const arm::ArmModel arm = model();
  const arm::Pose far = moved(arm::forwardKinematics(arm, workingPosture()), 2.0, 0, 0);
  const Refusal unreachable =
      refused(plan(arm, workingPosture(), Ptp{PoseTarget{far, {}}, 0.5, milliseconds(200)}, Setting{}));
  EXPECT_EQ(unreachable.reason, Reason::Unreachable);
  EXPECT_LT(distance(unreachable.point, far), 1e-12);

  // The arm nearly stretched: with the wrist flipped it would have to be longer.
  const arm::Pose target = arm::forwardKinematics(arm, degrees(0, 80, 10, -90, 90, 0));
  const arm::PoseBits flipped{arm::Shoulder::Righty, arm::Elbow::Above, arm::Wrist::Flip};
  const Refusal bits = refused(
      plan(arm, workingPosture(), Ptp{PoseTarget{target, flipped}, 0.5, milliseconds(200)}, Setting{}));
  EXPECT_EQ(bits.reason, Reason::PoseBits);
}

TEST(LineRefusal, saysWhereAJointWouldLeaveItsLimits) {
  // A turn about the flange's own axis by 20 deg from J6 = 260 deg: only J6 moves, and is at 270 half way.
  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(10, 15, 80, -5, 85, 260);
  const arm::Pose from = arm::forwardKinematics(arm, start);
  const arm::Pose to = moved(from, 0, 0, 0, degToRad(20.0), from.linear().col(2));
  const Refusal refusal = refused(plan(arm, start, slowLine(to), Setting{}));
  EXPECT_EQ(refusal.reason, Reason::JointLimit);
  EXPECT_EQ(refusal.joint, 5);
  EXPECT_GE(refusal.at, 0.5);
  EXPECT_LT(refusal.at, 0.502);
  EXPECT_LT(distance(refusal.point, from), 1e-9);
  EXPECT_THAT(refusal.message, HasSubstr("% of the line"));
  EXPECT_THAT(refusal.message, HasSubstr("allowed -270.0..270.0 deg"));
}

TEST(LineRefusal, saysWhereThePostureOfTheStartCanReachNoFurther) {
  // Straight outwards: the first point that the start's bits do not reach, found here by halving.
  const arm::ArmModel arm = model();
  const Setting setting = displacedSetting();
  const arm::JointVector start = workingPosture();
  const arm::Pose from = tcpAt(arm, start, setting);
  const Eigen::Vector3d way = setting.base.linear().transpose() * Eigen::Vector3d(1.0, 0.2, 0.0);
  const auto pointAt = [&](double share) {
    return moved(from, share * way.x(), share * way.y(), share * way.z());
  };
  const auto branchesAt = [&](double share) {
    return arm::allBranches(arm, setting.base * pointAt(share) * setting.tcp.inverse());
  };
  double inside = 0.0;
  double outside = 1.0;
  while (outside - inside > 1e-12) {
    const double share = 0.5 * (inside + outside);
    bool reached = false;
    for (const arm::Branch& branch : branchesAt(share)) {
      reached = reached || branch.bits == arm::poseBitsOf(arm, start);
    }
    (reached ? inside : outside) = share;
  }
  const Refusal refusal = refused(plan(arm, start, slowLine(pointAt(1.0)), setting));
  EXPECT_EQ(refusal.reason, branchesAt(outside).empty() ? Reason::Unreachable : Reason::PoseBits);
  EXPECT_GE(refusal.at, outside);
  EXPECT_LT(refusal.at, outside + 1e-3);
  EXPECT_LT(distance(refusal.point, pointAt(refusal.at)), 1e-9);
}

TEST(LineRefusal, saysWhereTheStartsOwnPostureIsOutsideItsLimits) {
  const arm::ArmModel arm = model();
  const arm::JointVector start = degrees(10, 15, 156, -5, 85, 20);
  const Refusal refusal =
      refused(plan(arm, start, slowLine(moved(arm::forwardKinematics(arm, start), 0, 0, 0.05)), Setting{}));
  EXPECT_EQ(refusal.reason, Reason::JointLimit);
  EXPECT_EQ(refusal.joint, 2);
  EXPECT_EQ(refusal.at, 0.0);
}

TEST(LineRefusal, refusesToStartOnASingularity) {
  const arm::ArmModel arm = model();
  const arm::JointVector upright = arm::JointVector::Zero();
  const Refusal refusal = refused(
      plan(arm, upright, slowLine(moved(arm::forwardKinematics(arm, upright), 0.1, 0, -0.2)), Setting{}));
  EXPECT_EQ(refusal.reason, Reason::Singular);
  EXPECT_EQ(refusal.at, 0.0);
  EXPECT_THAT(refusal.message, HasSubstr("singularity"));
}

TEST(LineRefusal, findsAWristSingularityInTheMiddleOfTheWayAtAnySpeed) {
  // A line along Y through a posture with J5 = 0. At 4.5 m/s the samples are further apart than the
  // neighbourhood of the singularity is wide; the starts are shifted so that some of them jump over it.
  const arm::ArmModel arm = model();
  const arm::Pose middle = arm::forwardKinematics(arm, degrees(0, 15, 80, -5, 0, 20));
  const arm::PoseBits bits{arm::Shoulder::Righty, arm::Elbow::Above, arm::Wrist::NoFlip};
  for (const double speed : {0.01, 0.1, 1.0, 4.5}) {
    for (const double shift : {0.0, 0.0006, 0.0012, 0.0018, 0.0024, 0.003, 0.0036, 0.0042}) {
      SCOPED_TRACE(std::to_string(speed) + " m/s, shifted by " + std::to_string(shift));
      const arm::Pose from = moved(middle, 0.0, -0.1 - shift, 0.0);
      const auto start = arm::postureFor(arm, from, bits, arm::JointVector::Zero());
      ASSERT_TRUE(start);
      const Line line{moved(middle, 0.0, 0.1, 0.0), TcpSpeed{speed}, milliseconds(5)};
      const Refusal refusal = refused(plan(arm, *start, line, Setting{}));
      EXPECT_EQ(refusal.reason, Reason::Singular) << refusal.message;
      EXPECT_LT(distance(refusal.point, middle), 0.002);
      EXPECT_THAT(refusal.message, HasSubstr("wrist straight"));
    }
  }
}

TEST(LineRefusal, namesTheSpeedThatWouldDoWhenAJointIsTooSlow) {
  // TM12, close to the first axis: J1 is rated 120 deg/s.
  const arm::ArmModel arm = model("tm12");
  const arm::JointVector start = degrees(0, -40, 130, 0, 90, 0);
  const arm::Pose to = moved(arm::forwardKinematics(arm, start), 0.0, 0.3, 0.0);
  const auto line = [&](const PathSpeed& speed) { return Line{to, speed, milliseconds(100)}; };

  const Refusal refusal = refused(plan(arm, start, line(SpeedRatio{1.0}), Setting{}));
  ASSERT_EQ(refusal.reason, Reason::JointSpeed) << refusal.message;
  EXPECT_GE(refusal.joint, 0);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(refusal.message, found, std::regex("at most ([0-9.]+) % is possible")))
      << refusal.message;
  const double percent = std::stod(found[1]);
  EXPECT_LT(percent, 100.0);
  planned(plan(arm, start, line(SpeedRatio{percent / 100.0}), Setting{}));
  EXPECT_EQ(refused(plan(arm, start, line(SpeedRatio{1.02 * percent / 100.0}), Setting{})).reason,
            Reason::JointSpeed);

  const Refusal absolute = refused(plan(arm, start, line(TcpSpeed{1.3}), Setting{}));
  EXPECT_THAT(absolute.message, HasSubstr("mm/s is possible"));
}

TEST(LineRefusal, namesTheSpeedThatWouldDoWhenItIsTheTurnThatIsTooFast) {
  // About the axis of J6, which is rated half of what the TCP may turn here.
  const arm::ArmModel arm = model("tm12").turning(2.0 * kPi);
  const arm::JointVector start = workingPosture();
  const arm::Pose from = arm::forwardKinematics(arm, start);
  const Eigen::Vector3d axis = from.linear().col(2);
  const auto line = [&](double way, double speed) {
    return Line{moved(from, way, 0.0, 0.0, degToRad(60.0), axis), TcpSpeed{speed}, milliseconds(100)};
  };
  const Refusal refusal = refused(plan(arm, start, line(0.005, 1.0), Setting{}));
  ASSERT_EQ(refusal.reason, Reason::JointSpeed) << refusal.message;
  std::smatch found;
  ASSERT_TRUE(std::regex_search(refusal.message, found, std::regex("at most ([0-9.]+) mm/s is possible")))
      << refusal.message;
  const double speed = std::stod(found[1]);
  EXPECT_LT(speed, 100.0);
  planned(plan(arm, start, line(0.005, speed / 1000.0), Setting{}));

  EXPECT_THAT(refused(plan(arm, start, line(0.0, 1.0), Setting{})).message,
              HasSubstr("no useful speed in mm/s is slow enough: give it in %"));
}

TEST(CircleRefusal, speaksOfTheCircle) {
  const arm::ArmModel arm = model();
  const arm::Pose from = arm::forwardKinematics(arm, workingPosture());
  const Circle circle{moved(from, 1.0, 1.0, 0), moved(from, 2.0, 0.0, 0), std::nullopt, SpeedRatio{0.2},
                      milliseconds(200)};
  const Refusal refusal = refused(plan(arm, workingPosture(), circle, Setting{}));
  EXPECT_THAT(refusal.message, HasSubstr("% of the circle"));
  EXPECT_GT(refusal.at, 0.0);
}

}  // namespace
}  // namespace cobot_command::motion
