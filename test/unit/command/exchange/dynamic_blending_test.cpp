// What a script does to the blend of the motion in front of it (SRCI: AllowDynamicBlending).
#include "exchange_rig.h"
#include "status_frames.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

class DynamicBlending : public ::testing::Test {
 protected:
  /// A blended motion that is under way, and a script that comes behind it.
  void sendBehindABlendedMotion(bool is_allowed) {
    rig.connect();
    rig.status(StatusFrames());
    rig.exchangeWith([&](auto& s) { s.allow_dynamic_blending = is_allowed; });
    rig.submit(CoreRig::blended(50));
    rig.reply(rig.takeScript().id);
    rig.stream(StatusFrames().moving());
    RunScriptGoal script;
    script.script = "var_i = 1";
    script.buffer_mode = static_cast<int>(BufferMode::Buffered);
    behind = rig.submit(script);
  }

  ExchangeRig rig{std::nullopt, link::LinkSettings{}};
  GoalId behind = 0;
};

TEST_F(DynamicBlending, thatIsNotAllowedHasTheMotionGoToItsEndInFrontOfTheScript) {
  sendBehindABlendedMotion(false);
  EXPECT_TRUE(rig.nothingSent());
  rig.stream(StatusFrames(), 60);
  EXPECT_EQ(rig.takeScript().script, "var_i = 1");
}

TEST_F(DynamicBlending, thatIsAllowedSendsTheScriptAtOnce) {
  sendBehindABlendedMotion(true);
  EXPECT_EQ(rig.takeScript().script, "var_i = 1");
}

TEST_F(DynamicBlending, letsTheNextMotionBlendWhenTheScriptIsCancelled) {
  sendBehindABlendedMotion(false);
  rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  rig.cancel(behind);
  EXPECT_NE(rig.takeScript().script.find("PTP"), std::string::npos);
}

}  // namespace
}  // namespace cobot_command::testing
