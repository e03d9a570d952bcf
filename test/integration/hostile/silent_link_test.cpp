// A link that goes silent at once, with no end of any connection: a cable, a switch, or a computer that dies.
// What the arm does then, and what the layer makes of it when the link is back.
#include <cmath>
#include <functional>
#include <string>

#include "chain.h"
#include "fault_proxy.h"
#include "hostile_rig.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::hostile {
namespace {

using blocks::Phase;

link::LinkSettings soonLost() {
  link::LinkSettings settings = quickSettings();
  settings.supervision_period = 200ms;
  settings.supervision_misses = 4;
  return settings;
}

/// In real time, as heartbeats are.
class SilentLink : public ::testing::Test {
 protected:
  void connect() {
    const auto link = layer.submit(blocks::ConnectGoal{"127.0.0.1", proxy.ports().script, 10, {}});
    const int before = layer.told().robot_statuses;
    ASSERT_TRUE(layer.waitUntil([&](const Told& told) {
      return told.reached(link, Phase::Connected) && told.robot_statuses > before;
    }));
  }
  void fallSilent() {
    for (const auto port : {testing::FaultProxy::Port::Script, testing::FaultProxy::Port::Status}) {
      for (const auto direction : {testing::Direction::ToClient, testing::Direction::ToController}) {
        testing::Fault nothing_passes;
        nothing_passes.direction = direction;
        proxy.add(port, nothing_passes);
      }
    }
  }
  [[nodiscard]] double firstJointDeg() { return radToDeg(robot.state().joints[0]); }
  [[nodiscard]] bool moves() { return robot.state().velocities.cwiseAbs().maxCoeff() > degToRad(0.1); }
  /// False when it does not come true in time. `meanwhile` is done all the time.
  [[nodiscard]] static bool comesTrue(
      const std::function<bool()>& condition, const std::function<void()>& meanwhile = [] {}) {
    const auto deadline = std::chrono::steady_clock::now() + testing::kDeadline;
    while (!condition()) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      meanwhile();
    }
    return true;
  }

  Robot robot{1};
  testing::FaultProxy proxy{{robot.ports().script, robot.ports().status}, 1};
  Layer layer{proxy.ports().status, soonLost()};
};

TEST_F(SilentLink, letsAJoggedArmStandAfterTheMovesThatItHas) {
  connect();
  blocks::JogGoal jog;
  jog.mode = static_cast<int>(blocks::JogMode::Axes);
  jog.directions[0] = 1;
  jog.speed = 20;  // 36 deg/s
  const auto goal = layer.submit(jog);
  const auto keep = [this] {
    layer.keepJogging();
    static_cast<void>(layer.waitUntil([](const Told&) { return false; }, 10ms));
  };
  ASSERT_TRUE(comesTrue([this] { return firstJointDeg() > 10; }, keep));
  fallSilent();
  const double at = firstJointDeg();
  ASSERT_TRUE(comesTrue([this] { return !moves(); }, keep)) << "though its client holds on";
  EXPECT_LT(firstJointDeg() - at, 0.25 * 36);
  const auto outcome = layer.endOf(goal);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, blocks::Ending::Aborted) << outcome->error_description;
}

TEST_F(SilentLink, letsAMotionGoOnThatIsStoppedWhenItIsBack) {
  connect();
  const auto goal = layer.submit(runtime::endlessMove());
  ASSERT_TRUE(comesTrue([this] { return moves(); }));
  fallSilent();
  const auto outcome = layer.endOf(goal);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->error_id, blocks::motion_error::kLinkDropped) << outcome->error_description;
  EXPECT_TRUE(moves()) << "the controller knows of nothing";
  proxy.heal();
  proxy.reset();
  connect();
  EXPECT_TRUE(comesTrue([this] { return !moves(); }));
  EXPECT_LT(firstJointDeg(), 89) << "not by its target";
}

}  // namespace
}  // namespace cobot_command::hostile
