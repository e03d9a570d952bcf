// Whatever a peer says: a named diagnosis, one end for each goal and a cause with each error, bounded memory
// and time, and the next connect to a good controller works. Which peers there are: misbehaving_peers.cpp.
#include <ctime>

#include "peer_stage.h"
#include "watched.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace std::chrono_literals;
using namespace blocks;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::MisbehavingPeer;

/// One frame of 16 MB may be kept, and is copied on its way through.
constexpr std::size_t kMostMemory = std::size_t{128} * 1024 * 1024;
/// Far above what the longest flood takes, in a build with sanitizers too.
// [s]: what burns time without an end takes more, watched or not.
constexpr double kMostCpuTime = testing::kIsWatched ? 60 : 10;

double cpuTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// To where the stream says that the robot stands already: whoever compares finds it there.
MoveAbsoluteGoal move() {
  MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(Movement::Ptp);
  goal.data_format = static_cast<int>(AbsoluteFormat::Jpp);
  goal.target = {0, 0, 90, 0, 90, 0};
  goal.speed = 50;
  goal.accel_time = 200;
  goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
  return goal;
}

class Meeting {
 public:
  explicit Meeting(const MisbehavingPeer& peer) : peer_(peer), stage_(settingsFor(peer)) { stage_.put(peer); }

  void hold() {
    const double begin = cpuTime();
    connect();
    if (stage_.connected(link_)) command();
    meetAGoodController();
    stage_.shutDown();
    EXPECT_EQ(stage_.ends().size(), static_cast<std::size_t>(stage_.goals())) << "a goal without an end";
    EXPECT_LT(stage_.mostMemory(), kMostMemory);
    EXPECT_LT(cpuTime() - begin, kMostCpuTime);
  }

 private:
  static link::LinkSettings settingsFor(const MisbehavingPeer& peer) {
    link::LinkSettings settings;
    settings.unplanned_motion_timeout = 5s;
    if (peer.port == link::Channel::Script) settings.status_port = 0;
    return settings;
  }

  void connect() {
    link_ = stage_.submit(ConnectGoal{"robot", 5890, 10, {}});
    ASSERT_TRUE(stage_.runUntil(15s, [&] { return stage_.ended(link_) || stage_.connected(link_); }));
    EXPECT_EQ(stage_.connected(link_), peer_.connect_error == 0) << stage_.status().diagnosis;
    if (!stage_.ended(link_)) return;
    expectError(kBlock<ConnectGoal>, stage_.endOf(link_), {peer_.connect_error});
  }

  void command() {
    if (peer_.port == link::Channel::Status) {
      stage_.run(2s);  // time for a stream to be seen for what it is
      EXPECT_THAT(stage_.status().status_diagnosis, HasSubstr(peer_.words));
      EXPECT_EQ(stage_.status().status_diagnosis.empty(), peer_.words.empty());
    }
    const GoalId goal = stage_.submit(move());
    ASSERT_TRUE(stage_.runUntil(60s, [&] { return stage_.ended(goal); })) << "the goal has no end";
    const Outcome& outcome = stage_.endOf(goal);
    if (peer_.goal_errors.empty()) {
      EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
    } else {
      expectError(kBlock<MoveAbsoluteGoal>, outcome, peer_.goal_errors);
    }
  }

  void expectError(Block block, const Outcome& outcome, const std::set<int>& ids) const {
    EXPECT_THAT(ids, Contains(outcome.error_id)) << outcome.error_description;
    EXPECT_NE(findError(block, outcome.error_id), nullptr);
    EXPECT_FALSE(outcome.remedy.empty());
    const bool of_script_port = peer_.port == link::Channel::Script;
    EXPECT_THAT(outcome.error_description, HasSubstr(of_script_port ? peer_.words : ""));
  }

  void meetAGoodController() {
    stage_.cancel(link_);
    ASSERT_TRUE(stage_.runUntil(10s, [&] { return stage_.ended(link_); }));
    stage_.putGoodPeers();
    const GoalId link = stage_.submit(ConnectGoal{"robot", 5890, 10, {}});
    ASSERT_TRUE(stage_.runUntil(10s, [&] { return stage_.connected(link); })) << stage_.status().diagnosis;
    const GoalId goal = stage_.submit(move());
    ASSERT_TRUE(stage_.runUntil(10s, [&] { return stage_.ended(goal); }));
    EXPECT_EQ(stage_.endOf(goal).ending, Ending::Done) << stage_.endOf(goal).error_description;
  }

  const MisbehavingPeer& peer_;
  PeerStage stage_;
  GoalId link_ = 0;
};

void meetAll(const std::vector<MisbehavingPeer>& peers) {
  for (const MisbehavingPeer& peer : peers) {
    SCOPED_TRACE("the peer is \"" + peer.name + "\"");
    Meeting(peer).hold();
  }
}

TEST(MisbehavingPeers, thatCannotBeCommandedAreNamed) {
  meetAll(testing::peersThatCannotBeCommanded());
}
TEST(MisbehavingPeers, thatAnswerStrangelyEndNoGoalWithoutACause) {
  meetAll(testing::peersThatAnswerStrangely());
}
TEST(MisbehavingPeers, ofTheStatusPortAreNamed) {
  meetAll(testing::peersOfTheStatusPort());
}

}  // namespace
}  // namespace cobot_command::testing
