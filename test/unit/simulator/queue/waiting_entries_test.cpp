// What waits in the queue: its order, what is seen ahead in it, PVT while they are recorded, velocities.
#include "queue/waiting_entries.h"

#include "queue/pvt_recorder.h"
#include "queue/velocities.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

using namespace std::chrono_literals;

MotionRequest someMotion() {
  return script::Ptp{};
}
script::PvtPoint pointOf(double seconds) {
  script::PvtPoint point;
  point.duration = seconds;
  return point;
}
Instant at(Duration since_start) {
  return Instant{} + since_start;
}

std::vector<int> numbersOf(const std::vector<QueuedTag>& tags) {
  std::vector<int> numbers;
  for (const QueuedTag& tag : tags) numbers.push_back(tag.tag);
  return numbers;
}
using Numbers = std::vector<int>;

// --- The queue ---------------------------------------------------------------------------------------------

TEST(WaitingEntries, leaveInTheOrderInWhichTheyCame) {
  WaitingEntries waiting;
  waiting.push(LoadChange{1.0});
  waiting.push(QueuedTag{1, 11});
  EXPECT_EQ(std::get<LoadChange>(waiting.take()).mass, 1.0);
  EXPECT_EQ(std::get<QueuedTag>(waiting.take()).tag, 11);
  EXPECT_TRUE(waiting.empty());
}

TEST(WaitingEntries, seeAheadWithTheChangesBeforeTheMotion) {
  WaitingEntries waiting;
  waiting.push(QueuedTag{1, 11});
  waiting.push(LoadChange{1.0});
  waiting.push(BaseChange{arm::Pose::Identity(), "table"});
  EXPECT_FALSE(waiting.lookAhead({}));
  waiting.push(someMotion());
  waiting.push(LoadChange{2.0});
  const auto ahead = waiting.lookAhead({});
  ASSERT_TRUE(ahead);
  EXPECT_NE(ahead->motion, nullptr);
  EXPECT_EQ(ahead->setting.load, 1.0);
  EXPECT_EQ(ahead->setting.base_name, "table");
}

TEST(WaitingEntries, seeNoMotionBehindWhatStopsTheArm) {
  for (const QueueEntry& entry : {QueueEntry(TcpChange{}), QueueEntry(VelocityMode{})}) {
    WaitingEntries waiting;
    waiting.push(entry);
    waiting.push(someMotion());
    const auto ahead = waiting.lookAhead({});
    ASSERT_TRUE(ahead);
    EXPECT_EQ(ahead->motion, nullptr);
  }
}

TEST(WaitingEntries, countMotionsEntriesAndThePointsOfPvt) {
  WaitingEntries waiting;
  waiting.push(someMotion());
  waiting.push(QueuedTag{});
  EXPECT_EQ(waiting.motionCount(), 1);
  EXPECT_EQ(waiting.size(), 2U);
  waiting.pvt().open(false);
  waiting.pvt().add(pointOf(1));
  waiting.pvt().add(pointOf(1));
  EXPECT_EQ(waiting.motionCount(), 1);
  EXPECT_EQ(waiting.size(), 2U);
  EXPECT_EQ(waiting.pvtPoints(), 2U);
  for (const QueueEntry& entry : waiting.pvt().close()) waiting.push(entry);
  EXPECT_EQ(waiting.motionCount(), 2);
  EXPECT_EQ(waiting.size(), 3U);
  EXPECT_EQ(waiting.pvtPoints(), 2U);
}

TEST(WaitingEntries, giveUpAllAndLeaveTheTags) {
  WaitingEntries waiting;
  waiting.push(QueuedTag{1, 11});
  waiting.push(someMotion());
  waiting.pvt().open(false);
  waiting.push(QueuedTag{2, 12});
  EXPECT_EQ(numbersOf(waiting.giveUp()), (Numbers{11, 12}));
  EXPECT_TRUE(waiting.empty());
  EXPECT_FALSE(waiting.pvt().isOpen());
}

TEST(WaitingEntries, giveUpAnOpenPvtAlone) {
  WaitingEntries waiting;
  waiting.push(QueuedTag{1, 11});
  waiting.pvt().open(false);
  waiting.push(QueuedTag{2, 12});
  EXPECT_EQ(numbersOf(waiting.giveUpPvt()), Numbers{12});
  EXPECT_EQ(waiting.size(), 1U);
}

TEST(WaitingEntries, giveAVelocityToTheModeOfItsKindThatWaits) {
  WaitingEntries waiting;
  const Velocity joints = arm::JointVector(arm::JointVector::Ones());
  waiting.push(VelocityMode{true, {}, {}});
  EXPECT_FALSE(waiting.giveVelocity(joints, false));
  waiting.push(VelocityMode{false, {}, {}});
  EXPECT_TRUE(waiting.giveVelocity(joints, false));
  EXPECT_FALSE(std::get<VelocityMode>(waiting.take()).first);
  EXPECT_TRUE(std::get<VelocityMode>(waiting.take()).first);
}

TEST(WaitingEntries, loseModesThatHaveNotBegun) {
  WaitingEntries waiting;
  waiting.push(VelocityMode{});
  waiting.push(QueuedTag{});
  waiting.removeVelocityModes();
  EXPECT_EQ(waiting.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<QueuedTag>(waiting.front()));
}

// --- PVT ---------------------------------------------------------------------------------------------------

TEST(PvtRecorder, makesOneMotionOfAllPointsAndMarksWhatIsBetween) {
  PvtRecorder pvt;
  pvt.open(true);
  pvt.add(pointOf(2));
  pvt.add(QueueEntry(QueuedTag{1, 11}));
  pvt.add(pointOf(3));
  pvt.add(QueueEntry(QueuedTag{2, 12}));
  const std::vector<QueueEntry> all = pvt.close();
  EXPECT_FALSE(pvt.isOpen());
  ASSERT_EQ(all.size(), 5U);
  const auto& block = std::get<planning::PvtBlock>(std::get<MotionRequest>(all[0]));
  EXPECT_TRUE(block.cartesian);
  EXPECT_EQ(block.points.size(), 2U);
  EXPECT_EQ(std::get<PvtMark>(all[1]).time, 2.0);
  EXPECT_EQ(std::get<QueuedTag>(all[2]).tag, 11);
  EXPECT_EQ(std::get<PvtMark>(all[3]).time, 5.0);
  EXPECT_EQ(std::get<QueuedTag>(all[4]).tag, 12);
}

TEST(PvtRecorder, beginsAnewWithEachOpening) {
  PvtRecorder pvt;
  EXPECT_TRUE(pvt.giveUp().empty());
  pvt.open(true);
  pvt.add(pointOf(2));
  EXPECT_EQ(pvt.points(), 1U);
  pvt.open(false);
  EXPECT_EQ(pvt.points(), 0U);
}

// --- Velocities --------------------------------------------------------------------------------------------

TEST(Velocities, areOfOneKind) {
  Velocities velocities;
  EXPECT_FALSE(velocities.on());
  EXPECT_FALSE(velocities.takes(true));
  velocities.begin(VelocityMode{true, {}, {}}, at(0s));
  EXPECT_TRUE(velocities.on());
  EXPECT_TRUE(velocities.takes(true));
  EXPECT_FALSE(velocities.takes(false));
  velocities.drop();
  EXPECT_FALSE(velocities.on());
}

TEST(Velocities, endByThemselvesOnlyWithATimeAndSoLongAfterTheLatest) {
  Velocities velocities;
  EXPECT_EQ(velocities.endsAt(), Instant::max());
  velocities.begin(VelocityMode{}, at(0s));
  velocities.renew(at(1s));
  EXPECT_EQ(velocities.endsAt(), Instant::max());
  velocities.begin(VelocityMode{false, {}, 5s}, at(1s));
  EXPECT_EQ(velocities.endsAt(), at(6s));
  velocities.renew(at(2s));
  EXPECT_EQ(velocities.endsAt(), at(7s));
  velocities.endAt(at(3s));
  EXPECT_EQ(velocities.endsAt(), at(3s));
}

TEST(Velocities, lastForTheShorterOfBothTimes) {
  Velocities velocities;
  EXPECT_FALSE(velocities.lasting());
  const auto lasting = [&](std::optional<Duration> rest, std::optional<Duration> end) {
    velocities.begin(VelocityMode{false, rest, end}, at(0s));
    return velocities.lasting();
  };
  EXPECT_EQ(lasting({}, {}), std::nullopt);
  EXPECT_EQ(lasting(1s, {}), Duration(1s));
  EXPECT_EQ(lasting({}, 2s), Duration(2s));
  EXPECT_EQ(lasting(1s, 2s), Duration(1s));
  EXPECT_EQ(lasting(3s, 2s), Duration(2s));
}

}  // namespace
}  // namespace cobot_command::simulator
