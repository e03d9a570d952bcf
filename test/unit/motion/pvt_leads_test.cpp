// By how much a move is ahead of its plan at the points of a PVT, so that no cubic is steeper than the move.
#include "cobot_command/motion/pvt_leads.h"

#include <algorithm>
#include <cmath>

#include "motion_support.h"

namespace cobot_command::motion {
namespace {

/// A turn of joint 1 at 90 deg/s and 600 deg/s^2, with ramps of that law and jerk.
struct Turn {
  JointMove move;
  TrajectoryPtr motion;
  std::vector<Duration> times;  ///< about 25 ms apart, with the ends of its ramps among them

  Turn(SpeedLaw law, double jerk) {
    move.target = degrees(40, 0, 90, 0, 90, 0);
    move.rates = {degToRad(90), degToRad(600), degToRad(600)};
    move.ramps = {law, jerk, jerk};
    motion = *plan(model(), degrees(0, 0, 90, 0, 90, 0), move, {});
    times = {Duration::zero()};
    addUntil(motion->timeUp());
    addUntil(motion->duration() - motion->timeDown());
    addUntil(motion->duration());
  }
  void addUntil(Duration end) {
    const Duration from = times.back();
    const auto count = (end - from) / kLeastSegment;
    for (Duration::rep i = 1; i <= count; ++i) {
      const auto whole = (end - from) / milliseconds(1) * i / count;
      times.push_back(from + whole * milliseconds(1));
    }
  }
  [[nodiscard]] std::vector<double> leads() const { return leadsAt(move, *motion, times); }
  [[nodiscard]] JointState at(std::size_t i, double lead) const {
    JointState state = motion->at(times[i]);
    state.position += lead * state.velocity;
    return state;
  }
  /// Of joint 1 [deg/s^2].
  [[nodiscard]] double steepest(const std::vector<double>& leads) const {
    double steepest = 0;
    for (std::size_t i = 1; i < times.size(); ++i) {
      const double length = toSeconds(times[i] - times[i - 1]);
      const JointState from = at(i - 1, leads[i - 1]);
      const JointState to = at(i, leads[i]);
      const double way = 6 * (to.position[0] - from.position[0]) / (length * length);
      const double first = way - (4 * from.velocity[0] + 2 * to.velocity[0]) / length;
      const double last = (2 * from.velocity[0] + 4 * to.velocity[0]) / length - way;
      steepest = std::max({steepest, std::abs(first), std::abs(last)});
    }
    return radToDeg(steepest);
  }
};

TEST(PvtLeads, keepCubicsAsFlatAsTheMoveWhateverTheLawAndTheJerk) {
  double most = 0;
  for (const SpeedLaw law : {SpeedLaw::SCurve, SpeedLaw::Poly5, SpeedLaw::ModSine, SpeedLaw::SineSquared}) {
    for (const double jerk : {0.0, 0.05, 0.2, 0.5, 1.0}) {
      const Turn turn(law, jerk);
      EXPECT_LE(turn.steepest(turn.leads()), 600 * 1.0051);
      most = std::max(most, turn.steepest(std::vector<double>(turn.times.size(), 0.0)));
    }
  }
  EXPECT_GT(most, 600 * 1.1) << "without leads there is nothing to show";
}

TEST(PvtLeads, areNoneAtTheEndsOfRampsAndAlongTheCruise) {
  const Turn turn(SpeedLaw::Poly5, 0.3);
  const std::vector<double> leads = turn.leads();
  double most = 0;
  for (std::size_t i = 0; i < leads.size(); ++i) {
    const bool rises = turn.times[i] > Duration::zero() && turn.times[i] < turn.motion->timeUp();
    const Duration left = turn.motion->duration() - turn.times[i];
    const bool falls = left > Duration::zero() && left < turn.motion->timeDown();
    if (!rises && !falls) {
      EXPECT_EQ(leads[i], 0) << i;
    }
    most = std::max(most, std::abs(leads[i]));
  }
  EXPECT_GT(most, 0);
  EXPECT_LT(most, 3e-3);
}

TEST(PvtLeads, areNoneWhereTheAccelerationJumpsAtThePoints) {
  for (const double lead : Turn(SpeedLaw::SCurve, 0.0).leads()) EXPECT_NEAR(lead, 0, 1e-9);
}

TEST(PvtLeads, areNoneOfAMotionWithoutRampsOfItsOwn) {
  const Turn turn(SpeedLaw::Poly5, 0.3);
  const auto leads = leadsAt(Ptp{turn.move.target, 1.0, milliseconds(200)}, *turn.motion, turn.times);
  EXPECT_EQ(leads, std::vector<double>(turn.times.size(), 0.0));
}

}  // namespace
}  // namespace cobot_command::motion
