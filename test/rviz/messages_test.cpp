// What the panel says: for as long as it is so.
#include <QDialog>
#include <QFileDialog>
#include <QStringList>
#include <chrono>
#include <memory>

#include "panel_fixture.h"
#include <actionlib/server/action_server.h>
#include <cobot_command/StopAction.h>
#include <gtest/gtest.h>
#include <ros/node_handle.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

namespace cobot_command::test {
namespace {

TEST_F(Panel, saysThatThereIsNoNodeToStopOnlyUntilThereIsOne) {
  at_panel.chooseRobot("/late");
  at_panel.clickStop();
  ASSERT_TRUE(
      holdsSoon([this] { return at_panel.textAlways("stop_text").contains("There is no command node"); }));
  using Server = actionlib::ActionServer<cobot_command::StopAction>;
  ros::NodeHandle node("/late");
  const auto ignore = [](Server::GoalHandle /*goal*/) {};
  Server server(node, "stop", ignore, ignore, false);
  server.start();
  EXPECT_TRUE(holdsSoon([this] { return at_panel.textAlways("stop_text").isEmpty(); }));
}

TEST_F(Panel, saysThatARobotIsNotConnectedOnlyUntilItIs) {
  at_panel.open("connect");
  at_panel.click("cancel");
  ASSERT_TRUE(holdsSoon([this] { return at_panel.link().startsWith("not connected"); }));
  at_panel.open("change_base");
  at_panel.click("execute");
  ASSERT_EQ(at_panel.outcome(), "error");
  // Nobody connects it within the half second in which what the robot tells settles.
  const auto refused_at = std::chrono::steady_clock::now();
  ASSERT_TRUE(
      holdsSoon([&] { return std::chrono::steady_clock::now() - refused_at > std::chrono::seconds(1); }));
  at_panel.open("connect");
  at_panel.click("execute");
  ASSERT_TRUE(holdsSoon([this] { return isReady(); }));
  at_panel.open("change_base");
  EXPECT_TRUE(holdsSoon([this] { return !at_panel.isLit("error"); }));
  EXPECT_EQ(at_panel.textOf("status_text"), "");
}

TEST_F(Panel, saysWhatHasToBeDoneFirstAndOffersNoMoveUntilThen) {
  at_panel.open("connect");
  at_panel.click("cancel");
  EXPECT_TRUE(
      holdsSoon([this] { return at_panel.textAlways("guide").startsWith("First: connect the robot"); }));
  for (const char* page : {"move_absolute", "move_relative", "move_circle", "pick_and_place", "load_path"}) {
    at_panel.open(page);
    EXPECT_FALSE(at_panel.isEnabled("check")) << page;
    EXPECT_FALSE(at_panel.isEnabled("execute")) << page;
    EXPECT_TRUE(at_panel.isEnabled("cancel")) << page;
  }
  at_panel.open("jog");
  EXPECT_FALSE(at_panel.isEnabled("jog_0_plus"));
  at_panel.chooseRobot("/nobody");
  EXPECT_TRUE(holdsSoon([this] {
    return at_panel.textAlways("guide").startsWith("First: start the command node of /nobody");
  }));
  at_panel.chooseRobot("/");
  at_panel.open("connect");
  at_panel.click("execute");
  ASSERT_TRUE(holdsSoon([this] { return isReady(); }));
  EXPECT_TRUE(holdsSoon([this] { return at_panel.textAlways("guide").isEmpty(); }));
  at_panel.open("jog");
  EXPECT_TRUE(at_panel.isEnabled("jog_0_plus"));
}

/// As the dialogs of RViz do that ask for a file: they stop RViz, and hold all its windows.
class Dialog {
 public:
  explicit Dialog(RvizWindow& window) : manager_(*window.rviz().getManager()), dialog_(&window.frame()) {
    manager_.stopUpdate();
    dialog_.setWindowModality(Qt::ApplicationModal);
    dialog_.show();
  }
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;
  ~Dialog() {
    dialog_.hide();
    manager_.startUpdate();
  }

 private:
  rviz::VisualizationManager& manager_;
  QDialog dialog_;
};

TEST_F(Panel, saysThatADialogTakesStopAwayAndGoesOnShowingTheRobot) {
  ASSERT_NO_FATAL_FAILURE(moveSlowly(100));
  {
    const Dialog dialog(*window);
    EXPECT_TRUE(
        holdsSoon([this] { return at_panel.textAlways("guide").contains("STOP cannot be pressed"); }));
    EXPECT_EQ(at_panel.outcome(60), "done") << "it is heard of though RViz serves nothing";
    EXPECT_TRUE(holdsSoon([this] { return isReady() && !at_panel.link().contains("moving"); }))
        << at_panel.link().toStdString();
  }
  EXPECT_TRUE(holdsSoon([this] { return at_panel.textAlways("guide").isEmpty(); }));
}

TEST_F(Panel, tellsOfNoLossWhereItWasDisconnected) {
  at_panel.open("connect");
  at_panel.click("cancel");
  ASSERT_TRUE(holdsSoon([this] { return at_panel.link().startsWith("not connected"); }));
  at_panel.click("execute");
  ASSERT_TRUE(holdsSoon([this] { return isReady(); }));
  EXPECT_TRUE(at_panel.textOf("connection").contains("Last loss: never"));
  EXPECT_FALSE(at_panel.textOf("connection").contains("Last connection: never"));
}

TEST_F(Panel, saysWhetherTheRobotIsHeldOrGoesOn) {
  ASSERT_NO_FATAL_FAILURE(moveSlowly(100));
  at_panel.clickAlways("pause");
  EXPECT_TRUE(holdsSoon([this] {
    return at_panel.textAlways("control_text") == "Pause: the robot is paused";
  })) << at_panel.textAlways("control_text").toStdString();
  at_panel.clickAlways("resume");
  EXPECT_TRUE(holdsSoon([this] {
    return at_panel.textAlways("control_text") == "Resume: the robot continues";
  })) << at_panel.textAlways("control_text").toStdString();
  EXPECT_EQ(at_panel.outcome(60), "done");
  EXPECT_TRUE(holdsSoon([this] { return at_panel.textAlways("control_text").isEmpty(); })) << "not for ever";
}

TEST_F(Panel, countsThePointsOfAPathThatIsBrowsedFor) {
  at_panel.open("load_path");
  at_panel.enter("number_of_moves", 1);
  at_panel.click("all_points");
  EXPECT_EQ(at_panel.valueOf("number_of_moves"), 7) << at_panel.textOf("path_answer").toStdString();
  at_panel.click("browse");
  auto* dialog = window->panel().findChild<QFileDialog*>("browse_dialog");
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->isModal()) << "STOP stays at hand";
  at_panel.clickStop();
  EXPECT_TRUE(
      holdsSoon([this] { return at_panel.textAlways("stop_text") == "Stop: the robot is at standstill"; }));
  dialog->close();
  at_panel.click("preset");
}

TEST_F(Panel, takesAsManyLettersAsTheFieldHasBytesFor) {
  at_panel.open("change_base");
  QString long_name;
  for (int i = 0; i < 200; ++i) long_name += QChar(0x00FC);  // ü, two bytes
  at_panel.enter("base_name", long_name);
  EXPECT_EQ(at_panel.enteredIn("base_name"), long_name.left(127));
  at_panel.click("preset");
}

}  // namespace
}  // namespace cobot_command::test
