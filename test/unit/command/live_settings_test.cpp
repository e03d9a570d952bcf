// Settings of the link that change while it is up.

#include "core_rig.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

class LiveSettings : public ::testing::Test {
 protected:
  LiveSettings() : rig(std::nullopt, CoreRig::noStatus()) { rig.connect(); }
  void use() {
    rig.core.useSettings(settings, rig.now);
    rig.pump();
  }
  /// How long the core takes to find that nobody answers its lifesigns.
  Duration timeToFindADeadPeer() {
    rig.answers_lifesigns = false;
    const Instant begin = rig.now;
    while (rig.latest().link == CommandStatus::LinkState::Ready && rig.now < begin + 10s) rig.pass(1ms);
    rig.discardSent();
    return rig.now - begin;
  }
  link::LinkSettings settings = CoreRig::noStatus();
  CoreRig rig;
};

TEST_F(LiveSettings, askForTheLifesignAsTheNewPeriodSaysFromNowOn) {
  settings.supervision_period = 20ms;
  use();
  EXPECT_LE(timeToFindADeadPeer(), 60ms);
}

TEST_F(LiveSettings, waitAsLongForTheNextAnswerAsTheyNowSay) {
  settings.reply_timeout = 5s;
  use();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.pass(4s);
  EXPECT_FALSE(rig.outcome(goal));
  rig.pass(1s);
  EXPECT_TRUE(rig.outcome(goal));
  rig.discardSent();
}

TEST_F(LiveSettings, leaveWhatWasAskedForBeforeItsTime) {
  const GoalId goal = rig.submit(CoreRig::move());
  rig.takeScript();
  settings.reply_timeout = 5s;
  use();
  rig.pass(1s);
  EXPECT_TRUE(rig.outcome(goal));
  rig.discardSent();
}

TEST(LiveStatusPort, staysThatOfTheLinkThatIsUp) {
  CoreRig rig{std::nullopt, link::LinkSettings{}};
  rig.core.keepConnected(CoreRig::robot(), rig.now);
  rig.pump();
  rig.open();
  rig.open(link::Channel::Status);
  rig.status({});
  link::LinkSettings settings;
  settings.status_port = 5895;
  rig.core.useSettings(settings, rig.now);
  rig.pump();
  ConnectGoal other = CoreRig::robot();
  other.status_port = 5895;
  rig.submit(other);
  const auto opening = rig.pendingOpen(link::Channel::Script);
  EXPECT_TRUE(opening) << "another port of the stream is another controller: the link is made anew";
  rig.discardSent();
}

}  // namespace
}  // namespace cobot_command::testing
