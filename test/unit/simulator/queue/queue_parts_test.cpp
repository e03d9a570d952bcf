// The parts of the queue by themselves: tool and base, holds, the error, what is told.
#include "drive/robot_error.h"
#include "queue/holds.h"
#include "queue/queue_reports.h"
#include "queue/tool_and_base.h"
#include "table_checks.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

// --- Tool and base -----------------------------------------------------------------------------------------

arm::Pose up(double metres) {
  return arm::Pose(Eigen::Translation3d(0, 0, metres));
}

TEST(ToolAndBase, isThatOfTheRobotAtFirst) {
  const ToolAndBase setting;
  EXPECT_EQ(setting.base_name, script::kRobotBase);
  EXPECT_EQ(setting.tcp_name, script::kNoTool);
  EXPECT_TRUE(setting.base.isApprox(arm::Pose::Identity()));
  EXPECT_TRUE(setting.tcp.isApprox(arm::Pose::Identity()));
  EXPECT_EQ(setting.tcp_mass + setting.load, 0.0);
}

TEST(ToolAndBase, changesTheBaseAlone) {
  ToolAndBase setting;
  setting.apply(BaseChange{up(0.5), "table"});
  EXPECT_EQ(setting.base_name, "table");
  EXPECT_TRUE(setting.base.isApprox(up(0.5)));
  EXPECT_EQ(setting.tcp_name, script::kNoTool);
}

TEST(ToolAndBase, keepsMassAndInertiaOfATcpThatIsGivenWithoutThem) {
  ToolAndBase setting;
  script::ToolInertia inertia;
  inertia.moment.front() = 7;
  setting.apply(TcpChange{up(0.1), "gripper", 1.5, inertia});
  setting.apply(TcpChange{up(0.2), "", std::nullopt, std::nullopt});
  EXPECT_EQ(setting.tcp_name, "");
  EXPECT_TRUE(setting.tcp.isApprox(up(0.2)));
  EXPECT_EQ(setting.tcp_mass, 1.5);
  EXPECT_EQ(setting.tcp_inertia.moment.front(), 7);
}

TEST(ToolAndBase, holdsTheLoadBesideTheTool) {
  ToolAndBase setting;
  setting.apply(TcpChange{up(0.1), "gripper", 1.5, std::nullopt});
  setting.apply(LoadChange{2.0});
  EXPECT_EQ(setting.tcp_mass, 1.5);
  EXPECT_EQ(setting.load, 2.0);
}

// --- Holds -------------------------------------------------------------------------------------------------

TEST(Holds, endWhenTheLastHolderLetsGo) {
  Holds holds;
  EXPECT_FALSE(holds.any());
  holds.add(Holder::Project);
  holds.add(Holder::Safeguard);
  holds.remove(Holder::Project);
  EXPECT_TRUE(holds.any());
  EXPECT_FALSE(holds.by(Holder::Project));
  EXPECT_TRUE(holds.by(Holder::Safeguard));
  holds.remove(Holder::Safeguard);
  EXPECT_FALSE(holds.any());
}

TEST(Holds, countAHolderOnceHoweverOftenItHolds) {
  Holds holds;
  holds.add(Holder::Pvt);
  holds.add(Holder::Pvt);
  holds.remove(Holder::Pvt);
  EXPECT_FALSE(holds.any());
}

// --- The error ---------------------------------------------------------------------------------------------

TEST(ErrorTable, isSound) {
  testing::expectSoundTable<ErrorTable>(ErrorState::OfRobot, ErrorEvent::Cleared, ErrorState::None);
}

TEST(ErrorLatch, forgetsAMotionThatFailedWithTheNextOne) {
  ErrorLatch latch;
  latch.motionFailed({0x15, "circle"});
  ASSERT_TRUE(latch.error());
  EXPECT_EQ(latch.error()->code, 0x15);
  EXPECT_FALSE(latch.stands());
  latch.motionQueued();
  EXPECT_FALSE(latch.error());
}

TEST(ErrorLatch, tellsTheLatestOfSeveral) {
  ErrorLatch latch;
  latch.motionFailed({0x15, "circle"});
  latch.motionFailed({0x21, "speed"});
  EXPECT_EQ(latch.error()->code, 0x21);
  latch.robotFailed({0x14058, "robot"});
  EXPECT_EQ(latch.error()->code, 0x14058);
}

TEST(ErrorLatch, keepsAnErrorOfTheRobotUntilItIsCleared) {
  ErrorLatch latch;
  latch.robotFailed({0x14058, "robot"});
  latch.motionQueued();
  latch.motionFailed({0x15, "circle"});
  EXPECT_TRUE(latch.stands());
  EXPECT_EQ(latch.error()->code, 0x14058);
  latch.clear();
  EXPECT_FALSE(latch.stands());
  EXPECT_FALSE(latch.error());
}

// --- Reports -----------------------------------------------------------------------------------------------

struct Reports : ::testing::Test {
  FaultSwitch stale_tag;
  QueueReports reports{stale_tag};
  const std::vector<QueuedTag> tags{{1, 11}, {2, 12}};

  /// Each as "settled 11", "dropped 11".
  std::vector<std::string> taken() {
    std::vector<std::string> texts;
    for (const QueueEvent& event : reports.take()) {
      if (const auto* settled = std::get_if<TagSettled>(&event)) {
        texts.push_back((settled->complete ? "complete " : "incomplete ") + std::to_string(settled->tag.tag));
      }
      if (const auto* dropped = std::get_if<TagDropped>(&event)) {
        texts.push_back("dropped " + std::to_string(dropped->tag.tag));
      }
    }
    return texts;
  }
};
using Texts = std::vector<std::string>;

TEST_F(Reports, tellTagsInOrderAndOnce) {
  reports.settle(tags, true);
  reports.settle({{3, 13}}, false);
  EXPECT_EQ(taken(), (Texts{"complete 11", "complete 12", "incomplete 13"}));
  EXPECT_EQ(taken(), Texts{});
}

TEST_F(Reports, tellThatTagsAreDropped) {
  reports.dropOrKeep(tags);
  EXPECT_EQ(taken(), (Texts{"dropped 11", "dropped 12"}));
  reports.settleKept();
  EXPECT_EQ(taken(), Texts{});
}

TEST_F(Reports, keepDroppedTagsForTheNextMotionWithTheFault) {
  stale_tag = {true, 1, 0, ""};
  reports.dropOrKeep({});
  EXPECT_TRUE(stale_tag.on) << "nothing was dropped, and the fault counts none";
  reports.dropOrKeep(tags);
  EXPECT_EQ(taken(), Texts{});
  reports.settleKept();
  EXPECT_EQ(taken(), (Texts{"complete 11", "complete 12"}));
  reports.dropOrKeep(tags);
  EXPECT_EQ(taken(), (Texts{"dropped 11", "dropped 12"}));
}

TEST_F(Reports, forgetWhatTheyKeptWithTheProject) {
  stale_tag.on = true;
  reports.dropOrKeep(tags);
  reports.forgetKept();
  reports.settleKept();
  EXPECT_EQ(taken(), Texts{});
}

}  // namespace
}  // namespace cobot_command::simulator
