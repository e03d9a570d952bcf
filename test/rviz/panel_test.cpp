// An operator at RViz, beside a simulated robot and its command node.
#include <QStringList>
#include <set>
#include <string>
#include <vector>

#include "panel_fixture.h"
#include <gmock/gmock.h>
#include <ros/node_handle.h>
#include <rviz/panel.h>
#include <sensor_msgs/JointState.h>

namespace cobot_command::test {
namespace {

TEST_F(Panel, opensEachPageFromTheMainMenu) {
  at_panel.clickAlways("main_menu");
  at_panel.takePicture("main");
  for (const char* page : {"connect", "change_base", "change_tcp", "interface", "move_relative",
                           "move_absolute", "move_circle", "pick_and_place", "load_path", "jog"}) {
    at_panel.open(page);
    at_panel.takePicture(page);
  }
}

TEST_F(Panel, tellsHowTheConnectionIsAndSinceWhen) {
  at_panel.open("connect");
  ASSERT_TRUE(
      holdsSoon([this] { return !at_panel.textOf("connection").contains("Last connection: never"); }));
  EXPECT_TRUE(at_panel.textOf("connection").contains("Last loss:"));
}

TEST_F(Panel, checksAndThenMakesAnAbsoluteMove) {
  at_panel.open("move_absolute");
  at_panel.click("preset");
  at_panel.click("check");
  EXPECT_EQ(at_panel.outcome(), "checked") << at_panel.textOf("status_text").toStdString();
  EXPECT_TRUE(at_panel.textOf("status_text").contains("Nothing was sent to the robot"));
  at_panel.takePicture("checked");
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done") << at_panel.textOf("status_text").toStdString();
  EXPECT_NE(at_panel.textOf("command_id_ack"), "–");
  at_panel.enter("target.0", 0);
  at_panel.click("take_target");
  EXPECT_NEAR(at_panel.valueOf("target.0"), 400, 0.1);
}

TEST_F(Panel, saysWhatIsWrongWithATargetOutOfReach) {
  at_panel.open("move_absolute");
  at_panel.click("preset");
  at_panel.enter("target.2", 1050);
  at_panel.click("check");
  EXPECT_EQ(at_panel.outcome(), "error");
  EXPECT_EQ(at_panel.textOf("error_id"), "16#201");
  const QString text = at_panel.textOf("status_text");
  EXPECT_EQ(text.count("hoose "), 1) << "one remedy: " << text.toStdString();
  at_panel.takePicture("refused");
  at_panel.enter("target.2", 400);
  EXPECT_FALSE(at_panel.isLit("error")) << "that was another target";
  EXPECT_EQ(at_panel.textOf("status_text"), "");
}

/// What the display of the ghost gets.
class GhostListener {
 public:
  GhostListener() {
    topic_ = ros::NodeHandle().subscribe<sensor_msgs::JointState>(
        ownTopic("preview_joints"), 1,
        [this](const sensor_msgs::JointState::ConstPtr& joints) { joints_ = *joints; });
  }

  [[nodiscard]] bool isThere() const { return joints_.position.size() == 6; }
  [[nodiscard]] std::vector<double> joints() const { return joints_.position; }

 private:
  sensor_msgs::JointState joints_;
  ros::Subscriber topic_;
};

TEST_F(Panel, showsTheArmAtATargetInEachConfigurationThatReachesIt) {
  moveToPreset();
  GhostListener ghost;
  at_panel.open("move_absolute");
  at_panel.enter("target.1", 200);
  ASSERT_TRUE(holdsSoon([&] { return ghost.isThere(); }));
  std::set<std::vector<double>> seen{ghost.joints()};
  std::set<QString> names;
  for (int i = 0; i < 8; ++i) {
    const std::vector<double> before = ghost.joints();
    at_panel.click("configuration_next");
    EXPECT_TRUE(holdsSoon([&] { return ghost.joints() != before || i == 0; }));
    names.insert(at_panel.textOf("configuration"));
    seen.insert(ghost.joints());
    if (i == 1) at_panel.takePicture("ghost");
  }
  EXPECT_GE(names.size(), 4u);
  EXPECT_GE(seen.size(), 4u);
}

TEST_F(Panel, makesARelativeMove) {
  moveToPreset();
  at_panel.open("move_relative");
  at_panel.click("preset");
  at_panel.choose("movement_command", 0);
  at_panel.enter("target.2", 50);
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done") << at_panel.textOf("status_text").toStdString();
  at_panel.open("move_absolute");
  at_panel.click("take_target");
  EXPECT_NEAR(at_panel.valueOf("target.2"), 450, 0.1);
}

TEST_F(Panel, makesACircle) {
  moveToPreset();
  at_panel.open("move_circle");
  at_panel.click("preset");
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done") << at_panel.textOf("status_text").toStdString();
}

TEST_F(Panel, changesBaseAndTcpAndBack) {
  at_panel.open("change_base");
  at_panel.enter("base.0", 100);
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done");
  at_panel.click("preset");
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done");
  at_panel.open("change_tcp");
  at_panel.enter("tcp_offset.2", 120);
  at_panel.enter("weight", 1.5);
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done");
  at_panel.click("preset");
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done");
}

TEST_F(Panel, stopsARobotThatMovesWhateverPageIsOpen) {
  ASSERT_NO_FATAL_FAILURE(moveSlowly(300));
  EXPECT_TRUE(at_panel.isLit("busy"));
  at_panel.open("change_base");
  at_panel.clickStop();
  EXPECT_TRUE(holdsSoon([this] { return !at_panel.link().contains("moving"); }));
  at_panel.open("move_relative");
  EXPECT_EQ(at_panel.outcome(), "aborted");
}

TEST_F(Panel, pausesAndResumesAMove) {
  ASSERT_NO_FATAL_FAILURE(moveSlowly(200));
  at_panel.clickAlways("pause");
  EXPECT_TRUE(holdsSoon([this] { return at_panel.link().contains("paused"); }));
  EXPECT_TRUE(at_panel.isLit("busy"));
  at_panel.clickAlways("resume");
  EXPECT_EQ(at_panel.outcome(60), "done") << at_panel.textOf("status_text").toStdString();
}

TEST_F(Panel, takesTheNumberThatWasTypedOrKeepsTheOneThatWas) {
  at_panel.open("move_relative");
  at_panel.click("preset");
  at_panel.type("target.0", "12,5");
  at_panel.click("check");
  EXPECT_EQ(at_panel.valueOf("target.0"), 12.5);
  at_panel.type("target.1", "1e2");
  at_panel.click("check");
  EXPECT_EQ(at_panel.valueOf("target.1"), 100);
  at_panel.type("target.2", "1234567");
  at_panel.click("check");
  EXPECT_EQ(at_panel.valueOf("target.2"), 0);
  at_panel.open("change_tcp");
  at_panel.type("weight", "500");
  at_panel.open("connect");
  at_panel.open("change_tcp");
  EXPECT_EQ(at_panel.valueOf("weight"), 0);
}

TEST_F(Panel, runsThePickAndPlaceWithAMoveThatWasEdited) {
  at_panel.open("pick_and_place");
  at_panel.click("preset");
  for (const char* move : {"edit_3", "edit_6"}) {
    at_panel.click(move);
    at_panel.enter("dwell", 0);
    if (std::string(move) == "edit_3") at_panel.takePicture("edited_move");
    at_panel.click("back");
  }
  at_panel.click("check");
  ASSERT_EQ(at_panel.outcome(), "checked") << at_panel.textOf("status_text").toStdString();
  at_panel.click("execute");
  ASSERT_TRUE(holdsSoon([this] { return at_panel.isLit("busy"); }));
  at_panel.takePicture("cycle");
  EXPECT_EQ(at_panel.outcome(60), "done") << at_panel.textOf("status_text").toStdString();
}

TEST_F(Panel, drivesAPathFromAFile) {
  GhostListener ghost;
  at_panel.open("load_path");
  at_panel.click("preset");
  at_panel.click("check");
  ASSERT_EQ(at_panel.outcome(), "checked") << at_panel.textOf("status_text").toStdString();
  EXPECT_TRUE(holdsSoon([&] { return ghost.isThere(); }));
  at_panel.takePicture("path");
  at_panel.enter("feedrate", 50);
  at_panel.click("set_feedrate");
  EXPECT_TRUE(holdsSoon([this] { return !at_panel.textOf("path_answer").isEmpty(); }));
  at_panel.enter("feedrate", 100);
  at_panel.click("set_feedrate");
}

TEST_F(Panel, enablesAndDisablesTheInterface) {
  at_panel.open("interface");
  at_panel.click("preset");
  at_panel.enter("life_sign_time_out", 3000);
  at_panel.click("execute");
  EXPECT_TRUE(
      holdsSoon([this] { return at_panel.textOf("group_state").contains("Interface: initialized"); }));
  at_panel.takePicture("interface_enabled");
  at_panel.click("cancel");
  EXPECT_EQ(at_panel.outcome(), "done");
}

TEST_F(Panel, isSavedWithTheConfigurationOfRviz) {
  auto& panel = dynamic_cast<rviz::Panel&>(Panel::window->panel());
  at_panel.open("move_relative");
  at_panel.click("preset");
  at_panel.enter("target.1", 12.5);
  rviz::Config kept;
  panel.save(kept);
  at_panel.enter("target.1", 99);
  at_panel.clickAlways("main_menu");
  panel.load(kept);
  at_panel.open("move_relative");
  EXPECT_EQ(at_panel.valueOf("target.1"), 12.5);
  EXPECT_TRUE(holdsSoon([this] { return isReady(); }));
}

}  // namespace
}  // namespace cobot_command::test

int main(int argc, char** argv) {
  ::testing::InitGoogleMock(&argc, argv);
  cobot_command::test::RvizWindow rviz(argc, argv);
  cobot_command::test::Panel::window = &rviz;
  return RUN_ALL_TESTS();
}
