// Somebody else commands the robot: it is told, and nothing is done about it.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kClient = "another client commands this controller";
constexpr const char* kMoved = "no command of this node is running";

struct Rig : CoreRig {
  Rig() : CoreRig(std::nullopt, link::LinkSettings{}) {
    connect();
    status(StatusFrames());
  }
  void stream(Duration duration, const StatusFrames& frame) { streamFor(duration, frame, 100ms); }
};

TEST(Stranger, isNoticedByATagThatWasNotGivenOutHere) {
  Rig rig;
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kClient)));
  rig.tag(7);
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kClient));
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("tag 7"));
  rig.close("gone");
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kClient))) << "who knows of the next connection";
}

TEST(Stranger, isNoneWhoseTagIsOursLateOrDoubled) {
  Rig rig;
  const GoalId done = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.tag(1);
  rig.tag(1);
  rig.status(StatusFrames());
  ASSERT_NE(rig.outcome(done), nullptr);
  const GoalId cancelled = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.cancel(cancelled);
  rig.reply(rig.takeScript().id);
  rig.tag(2);
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kClient)));
}

TEST(Stranger, isNoticedByAMotionThatIsNotOurs) {
  Rig rig;
  rig.stream(2s, StatusFrames());
  rig.status(StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr(kMoved));
  EXPECT_TRUE(rig.nothingSent()) << "it may be wanted";
  rig.status(StatusFrames());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kMoved)));
}

TEST(Stranger, isNoneWhileAndJustAfterOurOwnMotion) {
  Rig rig;
  rig.stream(2s, StatusFrames());
  const GoalId id = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.stream(2s, StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kMoved)));
  rig.tag(1);
  rig.status(StatusFrames());
  ASSERT_NE(rig.outcome(id), nullptr);
  rig.status(StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kMoved))) << "an arm may settle";
}

TEST(Stranger, isNoneWhileBlendedMotionsThatAreDoneForTheirGoalsStillMove) {
  Rig rig;
  rig.submit(CoreRig::blended());
  rig.reply(rig.takeScript().id);
  rig.stream(3s, StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kMoved)));
}

TEST(Stranger, isNoneWhereTheProjectMovesTheRobotInItsOtherNodes) {
  Rig rig;
  rig.listening = false;
  rig.stream(4s, StatusFrames().moving());
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr(kMoved)));
}

}  // namespace
}  // namespace cobot_command::testing
