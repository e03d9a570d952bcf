#include "cobot_command/motion/blend.h"

#include <cmath>
#include <functional>
#include <utility>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

using Axes = PoseOffset::Axes;

Command ptp(const arm::JointVector& offset, double ratio = 1.0, int ramp_ms = 200) {
  return MovePtp{offset, ratio, milliseconds(ramp_ms)};
}
/// By an offset in the base [m], turning by `turn` [rad].
Command straight(double x, double y, double z, double speed = 0.1, double turn = 0.0) {
  return MoveLine{PoseOffset{moved(arm::Pose::Identity(), x, y, z, turn, {1, 2, 1}), Axes::Base},
                  TcpSpeed{speed}, milliseconds(200)};
}

/// Two motions that blend: the whole of what the arm does.
struct Blended {
  TrajectoryPtr before;
  TrajectoryPtr next;
  Duration overlap{};
  TrajectoryPtr path;  // of the next one, with the blend into it

  [[nodiscard]] Duration takesOver() const { return before->duration() - overlap; }
  [[nodiscard]] Duration duration() const { return takesOver() + path->duration(); }
  [[nodiscard]] JointState at(Duration time) const {
    return time < takesOver() ? before->at(time) : path->at(time - takesOver());
  }
};

class Blending : public ::testing::Test {
 protected:
  using Make = std::function<Command(const arm::Pose& tcp)>;

  [[nodiscard]] Blended blend(const Make& before, const Make& next, const Blend& how,
                              Duration left = Duration::max()) const {
    Blended made;
    made.before = planned(plan(arm, start, before(tcpAt(arm, start, setting)), setting));
    if (!made.before) return made;
    const arm::JointVector corner = made.before->end().position;
    made.next = planned(plan(arm, corner, next(tcpAt(arm, corner, setting)), setting));
    if (!made.next) return made;
    made.overlap = overlapAt(arm, {*made.before, *made.next, setting.tcp}, how, {left});
    made.path = blended(made.before, made.next, made.overlap);
    return made;
  }
  [[nodiscard]] Blended blend(const Command& before, const Command& next, const Blend& how,
                              Duration left = Duration::max()) const {
    return blend([&](const arm::Pose&) { return before; }, [&](const arm::Pose&) { return next; }, how, left);
  }
  /// How far the TCP is from the corner [m].
  [[nodiscard]] double fromCorner(const Blended& motions, Duration time) const {
    return distance(tcpAt(arm, motions.at(time).position, setting),
                    tcpAt(arm, motions.before->end().position, setting));
  }

  arm::ArmModel arm = model();
  arm::JointVector start = workingPosture();
  Setting setting;
};

TEST_F(Blending, bySharesOfTheRampsShortensTheWholeByAsMuch) {
  // 45 deg at 180 deg/s, then 45 deg at 225 deg/s, each with 200 ms to the top speed.
  for (const auto& [share, overlap] : {std::pair(1.0, 200), std::pair(0.5, 100), std::pair(0.01, 2)}) {
    const Blended motions =
        blend(ptp(degrees(45, 0, 0, 0, 0, 0)), ptp(degrees(0, 0, 0, 0, 0, 45)), BlendShare{share});
    EXPECT_NEAR(toSeconds(motions.overlap), 1e-3 * overlap, 2e-9);
    EXPECT_NEAR(toSeconds(motions.duration()), (0.25 + 0.2) + (0.2 + 0.2) - 1e-3 * overlap, 4e-9);
  }
}

TEST_F(Blending, withNothingStops) {
  const Command one = ptp(degrees(45, 0, 0, 0, 0, 0));
  for (const Blend& none : {Blend(BlendShare{0.0}), Blend(BlendRadius{0.0}), Blend(BlendShare{-1.0})}) {
    const Blended motions = blend(one, one, none);
    EXPECT_EQ(motions.overlap, Duration::zero());
    EXPECT_EQ(motions.path, motions.next) << "and is the motion itself";
  }
}

TEST_F(Blending, keepsTheSpeedWhereBothMotionsAreOneLine) {
  const Blended motions =
      blend(ptp(degrees(45, 0, 0, 0, 0, 0)), ptp(degrees(45, 0, 0, 0, 0, 0)), BlendShare{1.0});
  for (Duration time = milliseconds(201); time < motions.duration() - milliseconds(201);
       time += milliseconds(1)) {
    EXPECT_NEAR(motions.at(time).velocity[0], degToRad(180), 1e-6) << toSeconds(time);
  }
}

TEST_F(Blending, isNoLongerThanTheShorterRamp) {
  const Blended slow_first = blend(ptp(degrees(45, 0, 0, 0, 0, 0), 1.0, 300),
                                   ptp(degrees(0, 0, 0, 0, 0, 45), 1.0, 150), BlendShare{1});
  EXPECT_NEAR(toSeconds(slow_first.overlap), 0.15, 2e-9);
  // A triangle: 4.5 deg at 180 deg/s is 25 ms of travel; sqrt(25 ms * 200 ms) up, and as long down.
  const Blended short_first =
      blend(ptp(degrees(4.5, 0, 0, 0, 0, 0)), ptp(degrees(0, 0, 0, 0, 0, 45)), BlendShare{1.0});
  EXPECT_NEAR(toSeconds(short_first.overlap), std::sqrt(0.025 * 0.2), 2e-9);
}

TEST_F(Blending, ofThreeInARowNeverOverlaps) {
  for (const double middle : {0.01, 0.1, 1.0, 4.5, 40.0}) {
    const Command far = ptp(degrees(45, 0, 0, 0, 0, 0));
    const Command between = ptp(degrees(0, 0, 0, 0, 0, middle));
    const Blended into = blend(far, between, BlendShare{1.0});
    const Blended out = blend(between, far, BlendShare{1.0});
    EXPECT_GT(into.overlap, Duration::zero());
    EXPECT_LE(into.overlap + out.overlap, into.next->duration()) << middle << " deg";
  }
}

TEST_F(Blending, cutsTheCornerOfTwoPerpendicularLinesAsTheSumSays) {
  // At 100 mm/s, 200 ms to stop: the last 10 mm and the first 10 mm overlap. In the middle of it a quarter of
  // each is left: 2.5 mm along both. Joint space bends that by less than 10 mm * 10 mm / 16 / reach.
  const Blended motions = blend(straight(0, 0.08, 0), straight(0, 0, 0.08), BlendShare{1.0});
  EXPECT_NEAR(toSeconds(motions.overlap), 0.2, 2e-9);
  EXPECT_NEAR(fromCorner(motions, motions.takesOver()), 0.010, 1e-9);
  EXPECT_NEAR(fromCorner(motions, motions.takesOver() + milliseconds(100)), 0.0025 * std::sqrt(2.0), 2e-5);
  EXPECT_NEAR(fromCorner(motions, motions.takesOver() + milliseconds(200)), 0.010, 1e-9);
}

TEST_F(Blending, byRadiusLeavesAndJoinsThePathsAtTheRadius) {
  // The last 5 mm at a deceleration of 100 mm/s in 200 ms: sqrt(2 * 5 / 500) s.
  const Blended motions = blend(straight(0, 0.08, 0), straight(0, 0, 0.08), BlendRadius{0.005});
  EXPECT_NEAR(toSeconds(motions.overlap), std::sqrt(0.02), 2e-9);
  EXPECT_NEAR(fromCorner(motions, motions.takesOver()), 0.005, 1e-9);
  EXPECT_NEAR(fromCorner(motions, motions.takesOver() + motions.overlap / 2), 0.00125 * std::sqrt(2.0), 1e-5);
  EXPECT_NEAR(fromCorner(motions, motions.takesOver() + motions.overlap), 0.005, 1e-9);
}

TEST_F(Blending, byALargeRadiusIsThatOfTheWholeRamps) {
  const Blended whole = blend(straight(0, 0.08, 0), straight(0, 0, 0.08), BlendShare{1.0});
  const Blended large = blend(straight(0, 0.08, 0), straight(0, 0, 0.08), BlendRadius{0.04});
  EXPECT_EQ(large.overlap, whole.overlap);
}

TEST_F(Blending, byRadiusCountsWhereTheToolIsNotTheFlange) {
  setting = displacedSetting();
  const Blended motions =
      blend(straight(0, 0.05, 0, 0.1, 0.3), straight(0.02, 0, 0.05, 0.1, -0.4), BlendRadius{0.002});
  const double leaves = fromCorner(motions, motions.takesOver());
  const double joins = fromCorner(motions, motions.takesOver() + motions.overlap);
  EXPECT_NEAR(std::max(leaves, joins), 0.002, 1e-9);
  EXPECT_GT(std::min(leaves, joins), 0.001);
}

TEST_F(Blending, withWhatIsLeftWhenTheNextMotionComesLate) {
  const Command before = straight(0, 0.08, 0);
  const Command next = straight(0, 0, 0.08);
  EXPECT_EQ(blend(before, next, BlendShare{1.0}, milliseconds(70)).overlap, Duration(milliseconds(70)));
  EXPECT_EQ(blend(before, next, BlendRadius{0.005}, milliseconds(70)).overlap, Duration(milliseconds(70)));
  EXPECT_EQ(blend(before, next, BlendShare{1.0}, Duration::zero()).overlap, Duration::zero());
  EXPECT_EQ(blend(before, next, BlendShare{1.0}, -milliseconds(3)).overlap, Duration::zero());
}

TEST_F(Blending, stopsAtAMotionThatTakesNoTime) {
  const Command far = ptp(degrees(45, 0, 0, 0, 0, 0));
  const Command stands = ptp(degrees(0, 0, 0, 0, 0, 0));
  EXPECT_EQ(blend(far, stands, BlendShare{1.0}).overlap, Duration::zero());
  EXPECT_EQ(blend(stands, far, BlendShare{1.0}).overlap, Duration::zero());
}

TEST_F(Blending, ofTwoPtpsMakesNoJointFasterThanTheFasterOfBoth) {
  const arm::JointVector one = degrees(40, -20, 15, 30, -25, 60);
  const arm::JointVector two = degrees(30, 25, 10, -50, -30, 10);
  const Blended motions = blend(ptp(one, 0.8, 250), ptp(two, 0.6, 180), BlendShare{1.0});
  const arm::JointVector first = motions.before->at(milliseconds(250)).velocity.cwiseAbs();
  const arm::JointVector second = motions.next->at(milliseconds(180)).velocity.cwiseAbs();
  for (Duration time{}; time < motions.duration(); time += milliseconds(1)) {
    const arm::JointVector now = motions.at(time).velocity.cwiseAbs();
    EXPECT_TRUE((now.array() <= first.cwiseMax(second).array() * (1 + 1e-9)).all()) << toSeconds(time);
  }
}

struct Kind {
  const char* name;
  std::function<Command(const arm::Pose& tcp, int side)> make;  ///< `side` 1 or -1: another direction
};

/// About as fast as the arm can.
const Kind kKinds[] = {
    {"Ptp", [](const arm::Pose&, int side) { return ptp(degrees(20 * side, 10, -8, 15, -10 * side, 40)); }},
    {"PtpToPose",
     [](const arm::Pose& tcp, int side) {
       return Command(Ptp{PoseTarget{moved(tcp, 0.05, 0.1 * side, -0.05, 0.3), {}}, 0.7, milliseconds(180)});
     }},
    {"Line", [](const arm::Pose&, int side) { return straight(0.03, 0.1 * side, -0.06, 0.3, 0.3); }},
    {"LineInTheTool",
     [](const arm::Pose&, int side) {
       return Command(MoveLine{PoseOffset{moved(arm::Pose::Identity(), 0.06, 0.05 * side, -0.03), Axes::Tool},
                               TcpSpeed{0.25}, milliseconds(220)});
     }},
    {"Circle",
     [](const arm::Pose& tcp, int side) {
       return Command(Circle{moved(tcp, 0.03, 0.03 * side, 0.01), moved(tcp, 0.0, 0.06 * side, 0.02, 0.2),
                             std::nullopt, TcpSpeed{0.2}, milliseconds(200)});
     }},
    {"CircleByAngle",
     [](const arm::Pose& tcp, int side) {
       return Command(Circle{moved(tcp, 0.03, 0.03 * side, 0.0), moved(tcp, 0.0, 0.06 * side, 0.0),
                             degToRad(200), TcpSpeed{0.2}, milliseconds(200)});
     }},
};

class BlendingOfPairs : public Blending, public ::testing::WithParamInterface<std::pair<int, int>> {
 protected:
  [[nodiscard]] Blended pair(const Blend& how) const {
    const Kind& one = kKinds[GetParam().first];
    const Kind& other = kKinds[GetParam().second];
    return blend([&](const arm::Pose& tcp) { return one.make(tcp, 1); },
                 [&](const arm::Pose& tcp) { return other.make(tcp, -1); }, how);
  }
};

TEST_P(BlendingOfPairs, isContinuousInPositionAndSpeed) {
  const Blended motions = pair(BlendShare{1.0});
  EXPECT_GT(motions.overlap, milliseconds(50));
  constexpr double kStep = 1e-3;
  constexpr double kLargestAcceleration = 40.0;  // [rad/s^2]; the PTPs have 20
  JointState before = motions.at(Duration::zero());
  for (Duration time = milliseconds(1); time < motions.duration() + milliseconds(2);
       time += milliseconds(1)) {
    const JointState now = motions.at(time);
    const arm::JointVector predicted = before.position + 0.5 * kStep * (before.velocity + now.velocity);
    EXPECT_LT((now.position - predicted).cwiseAbs().maxCoeff(), kLargestAcceleration * kStep * kStep);
    EXPECT_LT((now.velocity - before.velocity).cwiseAbs().maxCoeff(), kLargestAcceleration * kStep);
    before = now;
  }
  EXPECT_EQ(before.position, motions.next->end().position);
  EXPECT_TRUE(before.velocity.isZero());
}

TEST_P(BlendingOfPairs, isExactWhereItBeginsAndWhereItEnds) {
  const Blended motions = pair(BlendShare{0.7});
  EXPECT_EQ(motions.path->at(Duration::zero()).position, motions.before->at(motions.takesOver()).position);
  EXPECT_EQ(motions.path->at(Duration::zero()).velocity, motions.before->at(motions.takesOver()).velocity);
  for (const Duration time : {motions.overlap, motions.overlap + milliseconds(1), motions.next->duration()}) {
    EXPECT_EQ(motions.path->at(time).position, motions.next->at(time).position);
    EXPECT_EQ(motions.path->at(time).velocity, motions.next->at(time).velocity);
  }
  EXPECT_EQ(motions.path->duration(), motions.next->duration());
}

TEST_P(BlendingOfPairs, staysWithinTheRadiusAroundTheCorner) {
  for (const double radius : {0.0005, 0.005, 0.02, 0.05}) {
    const Blended motions = pair(BlendRadius{radius});
    EXPECT_GT(motions.overlap, Duration::zero()) << radius;
    for (Duration time{}; time <= motions.overlap; time += milliseconds(1)) {
      EXPECT_LE(fromCorner(motions, motions.takesOver() + time), radius + 1e-9) << radius;
    }
  }
}

TEST_P(BlendingOfPairs, keepsEveryJointWithinItsLimitsAndItsRatedSpeed) {
  const Blended motions = pair(BlendShare{1.0});
  for (Duration time{}; time < motions.duration(); time += milliseconds(1)) {
    const JointState state = motions.at(time);
    EXPECT_LT(arm.firstJointOutsideLimits(state.position), 0);
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      EXPECT_LE(std::abs(state.velocity[static_cast<Eigen::Index>(i)]), arm.limits()[i].max_velocity * 1.001);
    }
  }
}

std::vector<std::pair<int, int>> allPairs() {
  std::vector<std::pair<int, int>> pairs;
  for (int one = 0; one < static_cast<int>(std::size(kKinds)); ++one) {
    for (int other = 0; other < static_cast<int>(std::size(kKinds)); ++other) pairs.emplace_back(one, other);
  }
  return pairs;
}

std::string nameOf(const ::testing::TestParamInfo<std::pair<int, int>>& pair) {
  return std::string(kKinds[pair.param.first].name) + "Then" + kKinds[pair.param.second].name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, BlendingOfPairs, ::testing::ValuesIn(allPairs()), nameOf);

/// Moves J1 only, in any way: to reach what no planned motion does.
class AnyMotion final : public Trajectory {
 public:
  using State = std::function<std::pair<double, double>(double seconds)>;
  explicit AnyMotion(State j1) : j1_(std::move(j1)) {}
  [[nodiscard]] Duration duration() const override { return milliseconds(400); }
  [[nodiscard]] Duration timeUp() const override { return milliseconds(200); }
  [[nodiscard]] Duration timeDown() const override { return milliseconds(200); }
  [[nodiscard]] JointState at(Duration time) const override {
    const auto [position, velocity] = j1_(toSeconds(time));
    JointState state{workingPosture(), arm::JointVector::Zero()};
    state.position[0] = position;
    state.velocity[0] = velocity;
    return state;
  }

 private:
  State j1_;
};

TEST_F(Blending, isShortenedUntilNoJointIsFasterThanRated) {
  const double rated = arm.limits()[0].max_velocity;
  // Slows down from the rated speed over its ramp; the other one has half of it from the start.
  const AnyMotion before([&](double t) { return std::pair(0.0, rated * std::min(1.0, (0.4 - t) / 0.2)); });
  const AnyMotion next([&](double) { return std::pair(0.0, 0.5 * rated); });
  EXPECT_EQ(overlapAt(arm, {before, next}, BlendShare{1.0}), Duration(milliseconds(100)));
  const AnyMotion too_fast([&](double) { return std::pair(0.0, 1.1 * rated); });
  EXPECT_EQ(overlapAt(arm, {before, too_fast}, BlendShare{1.0}), Duration::zero());
}

TEST_F(Blending, isShortenedUntilNoJointLeavesItsLimits) {
  const double limit = arm.limits()[0].upper;
  // Both come from the limit; 0.1 rad of each add up at the corner.
  const AnyMotion before([&](double t) { return std::pair(limit - 0.05 + 0.1 * (0.4 - t) / 0.2, 0.0); });
  const AnyMotion next([&](double t) { return std::pair(limit - 0.05 + 0.1 * std::min(1.0, t / 0.2), 0.0); });
  const Duration overlap = overlapAt(arm, {before, next}, BlendShare{1.0});
  EXPECT_EQ(overlap, Duration(milliseconds(100)));
}

TEST_F(Blending, isShortenedUntilTheToolStaysWithinTheRadius) {
  // Away and back within the ramp: its end alone would say that it fits.
  const double corner = workingPosture()[0];
  const AnyMotion before([&](double) { return std::pair(corner, 0.0); });
  const AnyMotion next([&](double t) { return std::pair(corner + 0.2 * std::sin(t / 0.2 * kPi), 0.0); });
  const Duration overlap = overlapAt(arm, {before, next}, BlendRadius{0.02});
  EXPECT_GT(overlap, Duration::zero());
  for (Duration time{}; time <= overlap; time += milliseconds(1)) {
    EXPECT_LE(distance(tcpAt(arm, next.at(time).position, {}), tcpAt(arm, workingPosture(), {})),
              0.02 + 1e-9);
  }
}

}  // namespace
}  // namespace cobot_command::motion
