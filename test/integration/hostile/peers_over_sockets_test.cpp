// Misbehaving peers over real connections: the layer names them, goes on, and ends quickly in their midst.
//
// test/unit/peers meets all of them in invented time; here are those whose bytes come in floods, in trickles,
// or end a connection.
#include <algorithm>
#include <set>
#include <thread>

#include "hostile_rig.h"
#include "misbehaving_peers.h"
#include "peer_server.h"
#include <gmock/gmock.h>

namespace cobot_command::hostile {
namespace {

using blocks::Ending;
using blocks::GoalId;
using blocks::Phase;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::MisbehavingPeer;

/// What a stop may take in any state (reliability.md, G7), on a machine that does other things too.
constexpr auto kQuickStop = 2s;

std::vector<MisbehavingPeer> chosen(const std::set<std::string>& names) {
  std::vector<MisbehavingPeer> peers;
  for (const auto& table : {testing::peersThatCannotBeCommanded(), testing::peersThatAnswerStrangely(),
                            testing::peersOfTheStatusPort()}) {
    std::copy_if(table.begin(), table.end(), std::back_inserter(peers),
                 [&](const MisbehavingPeer& peer) { return names.count(peer.name) != 0; });
  }
  EXPECT_GE(peers.size(), names.size()) << "a peer has another name now";
  return peers;
}

/// Each on a thread of its own.
template <class Meet>
void meetAll(const std::vector<MisbehavingPeer>& peers, Meet meet) {
  std::vector<std::thread> threads;
  threads.reserve(peers.size());
  for (const MisbehavingPeer& peer : peers) {
    threads.emplace_back([&] {
      SCOPED_TRACE("the peer is \"" + peer.name + "\"");
      meet(peer);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

/// Two ports with a peer each; the one that is not meant is a good one.
struct Stage {
  explicit Stage(const MisbehavingPeer& peer)
      : script(peer.port == link::Channel::Script ? peer : testing::goodController()),
        status(peer.port == link::Channel::Status ? peer : testing::goodStream()),
        layer(status.port()) {}

  [[nodiscard]] blocks::ConnectGoal controller(int timeout = 10) const {
    return {"127.0.0.1", script.port(), static_cast<double>(timeout), {}};
  }

  testing::PeerServer script;
  testing::PeerServer status;
  Layer layer;
};

/// To where the stream says that the robot stands already.
blocks::MoveAbsoluteGoal move() {
  return runtime::moveJoints({0, 0, 90, 0, 90, 0});
}

void expectAGoodControllerToWork(Stage& stage) {
  stage.script.become(testing::goodController());
  stage.status.become(testing::goodStream());
  const GoalId link = stage.layer.submit(stage.controller());
  ASSERT_TRUE(stage.layer.waitUntil([&](const Told& told) {
    return told.reached(link, Phase::Connected) && told.status.status_diagnosis.empty();
  })) << stage.layer.told().status.diagnosis;
  const auto outcome = stage.layer.endOf(stage.layer.submit(move()));
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::Done) << outcome->error_description;
}

TEST(PeersOverSockets, thatCannotBeCommandedAreNamed) {
  meetAll(chosen({"says nothing", "closes at once", "noise", "trickles garbage", "a flood of dollars",
                  "half a frame of 16 MB, fast", "a flood of CPERR", "the status port"}),
          [](const MisbehavingPeer& peer) {
            if (peer.port != link::Channel::Script) return;
            Stage stage(peer);
            const auto outcome = stage.layer.endOf(stage.layer.submit(stage.controller()));
            ASSERT_TRUE(outcome.has_value());
            EXPECT_EQ(outcome->error_id, peer.connect_error) << outcome->error_description;
            EXPECT_THAT(outcome->error_description, HasSubstr(peer.words));
            expectAGoodControllerToWork(stage);
          });
}

TEST(PeersOverSockets, thatAnswerStrangelyEndNoGoalWithoutACause) {
  meetAll(chosen({"no answer to scripts", "an id of 1 MB", "closes at the script", "OK, and closes",
                  "everything three times", "data of scripts for ever", "a Listen node of 1 MB",
                  "10,000 frames a second", "10,000 items"}),
          [](const MisbehavingPeer& peer) {
            Stage stage(peer);
            const GoalId link = stage.layer.submit(stage.controller());
            ASSERT_TRUE(stage.layer.reaches(link, Phase::Connected));
            const auto outcome = stage.layer.endOf(stage.layer.submit(move()));
            ASSERT_TRUE(outcome.has_value());
            if (outcome->ending == Ending::Done) {
              EXPECT_TRUE(peer.goal_errors.empty());
            } else {
              EXPECT_THAT(peer.goal_errors, Contains(outcome->error_id)) << outcome->error_description;
            }
            stage.layer.cancel(link);
            ASSERT_TRUE(stage.layer.endOf(link).has_value());
            expectAGoodControllerToWork(stage);
          });
}

TEST(PeersOverSockets, holdUpNoEnd) {
  meetAll(chosen({"says nothing", "noise", "a flood of zeros", "trickles dollars", "closes at once",
                  "half a frame of 16 MB, fast", "a flood of CPERR", "the entry message for ever",
                  "data of scripts for ever", "10,000 frames a second"}),
          [](const MisbehavingPeer& peer) {
            Stage stage(peer);
            const GoalId link = stage.layer.submit(stage.controller());
            const bool of_script_port = peer.port == link::Channel::Script;
            ASSERT_TRUE((of_script_port ? stage.script : stage.status).hasSpoken());
            const auto begin = std::chrono::steady_clock::now();
            stage.layer.stop();
            EXPECT_LT(std::chrono::steady_clock::now() - begin, kQuickStop);
            EXPECT_TRUE(stage.layer.told().ended(link));
          });
}

}  // namespace
}  // namespace cobot_command::hostile
