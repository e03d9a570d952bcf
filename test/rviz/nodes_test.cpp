// The panel beside a command node that is not there, hangs, or dies, and with several robots.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "panel_fixture.h"
#include <gtest/gtest.h>

namespace cobot_command::test {
namespace {

TEST_F(Panel, saysThatThereIsNoNodeForACommandAndWorksOn) {
  at_panel.chooseRobot("/nobody");
  EXPECT_TRUE(holdsSoon([this] { return at_panel.link() == "no command node"; }));
  at_panel.open("change_base");
  at_panel.click("execute");
  EXPECT_TRUE(at_panel.isLit("busy"));
  EXPECT_EQ(at_panel.outcome(), "error");
  EXPECT_TRUE(at_panel.textOf("status_text").contains("There is no command node"));
  at_panel.chooseRobot("/");
  EXPECT_TRUE(holdsSoon([this] { return isReady(); }));
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "done");
}

TEST_F(Panel, sendsNothingBehindAStopThatStillWaitedForItsNode) {
  at_panel.chooseRobot("/nobody");
  at_panel.open("change_base");
  at_panel.click("execute");
  EXPECT_TRUE(at_panel.isLit("busy"));
  at_panel.clickStop();
  EXPECT_FALSE(at_panel.isLit("busy") || at_panel.isLit("error"));
}

TEST_F(Panel, showsTheRobotThatItCommandsWhateverWasTyped) {
  at_panel.chooseRobot("no name!");
  EXPECT_EQ(at_panel.robot(), "/");
  EXPECT_TRUE(holdsSoon([this] { return at_panel.link() == "'no name!' is not a namespace"; }));
  at_panel.typeRobot("/third");
  at_panel.open("connect");
  at_panel.enter("timeout", 30);
  EXPECT_EQ(at_panel.robot(), "/");
  EXPECT_TRUE(holdsSoon([this] { return isReady(); }));
}

/// Of a node that lives: one that hangs does not tell it.
std::string pidOfSecond() {
  const std::unique_ptr<FILE, int (*)(FILE*)> told(
      popen("rosnode info /second/command_node | sed -n 's/^Pid: //p'", "r"), pclose);
  std::array<char, 16> pid{};
  return fgets(pid.data(), pid.size(), told.get()) == nullptr ? "" : std::string(pid.data());
}

void signalTo(const std::string& pid, const char* signal) {
  ASSERT_EQ(std::system(("kill -" + std::string(signal) + " " + pid).c_str()), 0);
}

TEST_F(Panel, saysThatANodeDoesNotAnswerAndTakesTheCommandBack) {
  at_panel.chooseRobot("/second");
  at_panel.open("change_base");
  ASSERT_TRUE(holdsSoon([this] { return at_panel.link() == "not connected"; }));
  ASSERT_TRUE(holdsSoon([this] {  // its clients have found each other
    at_panel.click("execute");
    return at_panel.outcome(5) == "error" && at_panel.textOf("error_id") == "16#10";
  }));
  const std::string pid = pidOfSecond();
  ASSERT_NO_FATAL_FAILURE(signalTo(pid, "STOP"));
  at_panel.click("execute");
  EXPECT_EQ(at_panel.outcome(), "error");
  EXPECT_TRUE(at_panel.textOf("status_text").contains("does not answer"));
  at_panel.clickStop();
  EXPECT_TRUE(
      holdsSoon([this] { return at_panel.textAlways("stop_text").contains("Use the emergency stop"); }));
  ASSERT_NO_FATAL_FAILURE(signalTo(pid, "CONT"));
  EXPECT_TRUE(holdsSoon([this] { return !at_panel.textAlways("stop_text").contains("emergency stop"); }));
  EXPECT_TRUE(holdsSoon([this] { return at_panel.isLit("aborted"); }))
      << "it answers again, and the command was withdrawn";
}

/// Of another robot, whose command node nobody needs, and which is started again.
TEST_F(Panel, saysThatANodeHasDiedAndFindsTheNextOne) {
  at_panel.chooseRobot("/second");
  at_panel.open("connect");
  at_panel.enter("host", "127.0.0.1");
  at_panel.enter("port", 1);
  at_panel.enter("timeout", 300);
  at_panel.click("execute");
  ASSERT_TRUE(holdsSoon([this] { return at_panel.link().startsWith("connecting"); }));
  ASSERT_NO_FATAL_FAILURE(signalTo(pidOfSecond(), "KILL"));
  EXPECT_EQ(at_panel.outcome(), "error");
  EXPECT_TRUE(holdsSoon([this] { return at_panel.link() == "not connected"; }))
      << at_panel.link().toStdString();
  at_panel.click("execute");
  EXPECT_TRUE(holdsSoon([this] { return at_panel.link().startsWith("connecting"); }));
  at_panel.click("cancel");
  EXPECT_EQ(at_panel.outcome(), "done");
}

}  // namespace
}  // namespace cobot_command::test
