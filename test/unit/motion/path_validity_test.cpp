// Random lines and circles: each is followed to its end by the letter of the contract, or refused for a
// reason that is true.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "curves/circle_path.h"
#include "curves/tcp_path.h"
#include "motion_support.h"

#include "cobot_command/arm/inverse_kinematics.h"

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;

struct Request {
  arm::JointVector start;
  Command command;
  Setting setting;
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  arm::Pose pose(double reach, double turn) {
    const Eigen::Vector3d axis(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    return moved(arm::Pose::Identity(), uniform(-reach, reach), uniform(-reach, reach),
                 uniform(-reach, reach), uniform(-turn, turn), axis);
  }

  arm::JointVector posture(const arm::ArmModel& arm) {
    arm::JointVector joints;
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      joints[static_cast<Eigen::Index>(i)] = uniform(arm.limits()[i].lower, arm.limits()[i].upper);
    }
    return joints;
  }

  Request request(const arm::ArmModel& arm) {
    Request made;
    made.start = posture(arm);
    made.setting.base = pose(0.3, kPi);
    made.setting.tcp = pose(0.15, kPi);
    made.setting.speed_override = uniform(0.2, 1.0);
    const arm::Pose from = tcpAt(arm, made.start, made.setting);
    const double way = uniform(0.01, 0.25);
    const arm::Pose end = near(from, way, uniform(0.0, 0.8));
    const auto ramp = milliseconds(static_cast<int>(uniform(20, 400)));
    const PathSpeed speed = uniform(0, 1) < 0.5 ? PathSpeed(SpeedRatio{uniform(0.05, 0.6)})
                                                : PathSpeed(TcpSpeed{uniform(0.05, 0.8)});
    if (uniform(0, 1) < 0.5) {
      made.command = Line{end, speed, ramp};
    } else {
      const bool with_angle = uniform(0, 1) < 0.5;
      made.command =
          Circle{near(from, way, 0.0), end,
                 with_angle ? std::optional<double>(uniform(-2 * kPi, 2 * kPi)) : std::nullopt, speed, ramp};
    }
    return made;
  }

 private:
  arm::Pose near(const arm::Pose& from, double way, double turn) {
    const arm::Pose by = pose(way, turn);
    arm::Pose result = from;
    result.translation() += by.translation();
    result.linear() = by.linear() * from.linear();
    return result;
  }

  std::mt19937_64 engine_;
};

TcpPath geometryOf(const arm::ArmModel& arm, const Request& request) {
  const arm::Pose from = tcpAt(arm, request.start, request.setting);
  if (const auto* line = std::get_if<Line>(&request.command)) {
    return TcpPath::line(from, line->target);
  }
  return *circlePath(from, std::get<Circle>(request.command));
}

/// How far [m or rotation entry] the TCP is from the path: the path's nearest point is sought from `guess`
/// on.
double deviation(const TcpPath& path, const arm::Pose& tcp, double& guess) {
  for (int i = 0; i < 5; ++i) {
    const PathRate rate = path.rateAt(guess);
    const arm::Pose there = path.at(guess);
    PathRate gap;
    gap.head<3>() = tcp.translation() - there.translation();
    const Eigen::AngleAxisd turn(tcp.linear() * there.linear().transpose());
    gap.tail<3>() = turn.angle() * turn.axis();
    guess += rate.dot(gap) / rate.squaredNorm();
  }
  return std::max(distance(path.at(guess), tcp), turnError(path.at(guess), tcp));
}

void expectFollowed(const arm::ArmModel& arm, const Request& request, const Trajectory& motion) {
  const TcpPath path = geometryOf(arm, request);
  const arm::PoseBits bits = arm::poseBitsOf(arm, request.start);
  arm::JointVector previous = request.start;
  double progress = 0.0;
  for (Duration time = milliseconds(1); time - milliseconds(1) < motion.duration(); time += milliseconds(1)) {
    const JointState state = motion.at(time);
    ASSERT_LT(arm.firstJointOutsideLimits(state.position), 0) << toSeconds(time);
    ASSERT_EQ(arm::poseBitsOf(arm, state.position), bits) << toSeconds(time);
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      const auto joint = static_cast<Eigen::Index>(i);
      const double rated = arm.limits()[i].max_velocity;
      ASSERT_LE(std::abs(state.position[joint] - previous[joint]), rated * 1e-3 * 1.005) << toSeconds(time);
      ASSERT_LE(std::abs(state.velocity[joint]), rated * 1.01) << toSeconds(time);
    }
    ASSERT_LT(deviation(path, tcpAt(arm, state.position, request.setting), progress), 1e-9)
        << toSeconds(time);
    previous = state.position;
  }
  EXPECT_NEAR(progress, 1.0, 1e-6);
}

/// The reason given is true at the point given.
void expectTrue(const arm::ArmModel& arm, const Request& request, const Refusal& refusal) {
  const Setting& setting = request.setting;
  if (refusal.reason == Reason::DegenerateCircle) {
    return;
  }
  ASSERT_LT(distance(geometryOf(arm, request).at(refusal.at), refusal.point), 1e-9);
  const arm::PoseBits bits = arm::poseBitsOf(arm, request.start);
  const arm::Branches branches = arm::allBranches(arm, setting.base * refusal.point * setting.tcp.inverse());
  const auto same = std::find_if(branches.begin(), branches.end(),
                                 [&](const arm::Branch& branch) { return branch.bits == bits; });
  switch (refusal.reason) {
    case Reason::Unreachable:
      EXPECT_TRUE(branches.empty()) << refusal.message;
      break;
    case Reason::PoseBits:
      EXPECT_TRUE(!branches.empty() && same == branches.end()) << refusal.message;
      break;
    case Reason::JointLimit: {
      ASSERT_NE(same, branches.end());
      const auto joint = static_cast<std::size_t>(refusal.joint);
      const double value = same->joints[refusal.joint];
      const arm::JointLimit& limit = arm.limits()[joint];
      const bool has_turn_outside = value - 2 * kPi < limit.lower || value + 2 * kPi > limit.upper;
      EXPECT_TRUE(has_turn_outside) << refusal.message;
      break;
    }
    case Reason::Singular: {
      ASSERT_NE(same, branches.end());
      const auto gap = arm::singularityDistance(arm, same->joints);
      EXPECT_LT(std::min({gap.shoulder, gap.elbow, gap.wrist}), 2.6e-3) << refusal.message;
      break;
    }
    case Reason::JointSpeed:
      EXPECT_GE(refusal.joint, 0);
      break;
    default:
      ADD_FAILURE() << refusal.message;
  }
}

/// The reason of a refusal, nothing when it is followed.
std::optional<Reason> expectFollowedOrRefusedForAReason(const arm::ArmModel& arm, const Request& request) {
  const auto result = plan(arm, request.start, request.command, request.setting);
  if (result) {
    expectFollowed(arm, request, **result);
    return std::nullopt;
  }
  expectTrue(arm, request, result.error());
  return result.error().reason;
}

TEST(RandomPaths, areFollowedToTheLetterOrRefusedForATrueReason) {
  std::map<Reason, int> refusals;
  int followed = 0;
  for (const char* name : {"tm5-700", "tm5-900", "tm12", "tm14s"}) {
    const arm::ArmModel arm = model(name);
    Random random(20240607);
    for (int i = 0; i < 250; ++i) {
      SCOPED_TRACE(std::string(name) + " request " + std::to_string(i));
      const Request request = random.request(arm);
      if (const auto reason = expectFollowedOrRefusedForAReason(arm, request)) {
        ++refusals[*reason];
      } else {
        ++followed;
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(followed, 100);
  for (const Reason reason :
       {Reason::Unreachable, Reason::PoseBits, Reason::JointLimit, Reason::JointSpeed}) {
    EXPECT_GT(refusals[reason], 0) << toString(reason);
  }
  RecordProperty("followed", followed);
  for (const auto& [reason, count] : refusals) {
    RecordProperty(toString(reason), count);
  }
}

/// They are looked at less often than each millisecond.
TEST(RandomPaths, thatAreSlowAreAlsoFollowedOrRefusedForATrueReason) {
  const arm::ArmModel arm = model();
  Random random(1871);
  int followed = 0;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    Request request = random.request(arm);
    if (i % 2 == 0) request.start[4] = random.uniform(0.01, 0.1);  // a wrist that turns fast all the same
    Line slow{random.pose(0.01, 0.05) * tcpAt(arm, request.start, request.setting),
              TcpSpeed{random.uniform(0.002, 0.05)}, milliseconds(50)};
    request.command = slow;
    if (!expectFollowedOrRefusedForAReason(arm, request)) ++followed;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(followed, 30);
}

TEST(RandomPaths, startingNextToASingularityAreAlsoFollowedOrRefusedForATrueReason) {
  const arm::ArmModel arm = model();
  Random random(4711);
  int followed = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Request request = random.request(arm);
    arm::JointVector start = request.start;
    (i % 2 == 0 ? start[2] : start[4]) = random.uniform(0.002, 0.02);
    const arm::Pose shift =
        tcpAt(arm, start, request.setting) * tcpAt(arm, request.start, request.setting).inverse();
    request.start = start;
    if (auto* line = std::get_if<Line>(&request.command)) {
      line->target = shift * line->target;
    } else {
      auto& circle = std::get<Circle>(request.command);
      circle.via = shift * circle.via;
      circle.end = shift * circle.end;
    }
    if (!expectFollowedOrRefusedForAReason(arm, request)) ++followed;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(followed, 0);
}

}  // namespace
}  // namespace cobot_command::motion
