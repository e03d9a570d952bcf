// An operator who jogs the arm.
#include <QStringList>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "panel_fixture.h"
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_msgs/Empty.h>

namespace cobot_command::test {
namespace {

TEST_F(Panel, jogsAJointAsLongAsItsButtonIsHeld) {
  moveToPreset();
  at_panel.open("jog");
  at_panel.choose("mode", 2);
  const double before = jointValue();
  const auto has_moved = [&] { return jointValue() > before + 1; };
  // A machine so busy that RViz stands still for a quarter of a second lets go of the arm, as it has to: then
  // once more.
  for (int tries = 0; tries < 10 && !has_moved(); ++tries) {
    at_panel.release("jog_0_plus");
    at_panel.press("jog_0_plus");
    EXPECT_TRUE(holdsSoon([&] { return has_moved() || !at_panel.isLit("busy"); }));
  }
  EXPECT_TRUE(has_moved()) << at_panel.textOf("status_text").toStdString();
  at_panel.release("jog_0_plus");
  EXPECT_EQ(at_panel.outcome(5), "done") << at_panel.textOf("status_text").toStdString();
}

/// How many keep-alives come, counted on a thread that goes on while that of the user interface is busy.
class KeepAlives {
 public:
  KeepAlives() : spinner_(1, &queue_) {
    node_.setCallbackQueue(&queue_);
    heard_ = node_.subscribe<std_msgs::Empty>(
        "jog_keep_alive", 100, [this](const std_msgs::Empty::ConstPtr& /*alive*/) { ++count_; });
    spinner_.start();
  }

  [[nodiscard]] int count() const { return count_; }

 private:
  std::atomic<int> count_{0};
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::AsyncSpinner spinner_;
  ros::Subscriber heard_;
};

TEST_F(Panel, keepsAJogGoingWhileTheUserInterfaceIsBusyForAMoment) {
  moveToPreset();
  KeepAlives heard;
  at_panel.open("jog");
  at_panel.choose("mode", 2);
  int most = 0;
  // On a machine that is busy itself the other thread may get no time just then: then once more.
  for (int tries = 0; tries < 50 && most < 3; ++tries) {
    at_panel.press(tries % 2 == 0 ? "jog_0_plus" : "jog_0_minus");
    ASSERT_TRUE(holdsSoon([&] { return heard.count() > 0 && at_panel.isLit("busy"); }));
    const int before = heard.count();
    std::this_thread::sleep_for(
        std::chrono::milliseconds(80));  // so long nothing is drawn, and no timer serves
    most = std::max(most, heard.count() - before);
    at_panel.release(tries % 2 == 0 ? "jog_0_plus" : "jog_0_minus");
    ASSERT_NE(at_panel.outcome(5), "busy");
  }
  EXPECT_GE(most, 3) << "more than were on their way";
}

/// A keep-alive names no jog: that of a button that is pressed anew keeps none going that another button has
/// begun.
TEST_F(Panel, jogsTheOtherWayWhenTheOtherButtonIsPressedAtOnce) {
  moveToPreset();
  at_panel.open("jog");
  at_panel.choose("mode", 2);
  at_panel.press("jog_0_plus");
  const double before = jointValue();
  ASSERT_TRUE(holdsSoon([&] { return jointValue() > before + 1 || !at_panel.isLit("busy"); }));
  at_panel.release("jog_0_plus");
  at_panel.press("jog_0_minus");
  const double turned = jointValue();
  bool has_turned_back = false;
  for (int tries = 0; tries < 10 && !has_turned_back; ++tries) {
    ASSERT_TRUE(holdsSoon([&] {
      has_turned_back = jointValue() < turned - 1;
      return has_turned_back || !at_panel.isLit("busy");
    }));
    at_panel.release("jog_0_minus");
    if (!has_turned_back) at_panel.press("jog_0_minus");
  }
  EXPECT_TRUE(has_turned_back) << at_panel.textOf("status_text").toStdString();
  EXPECT_NE(at_panel.outcome(5), "busy");
}

TEST_F(Panel, letsGoOfTheArmWhereverTheMouseIsReleased) {
  moveToPreset();
  at_panel.open("jog");
  at_panel.choose("mode", 2);
  at_panel.press("jog_0_minus");
  at_panel.releaseElsewhere();
  EXPECT_EQ(at_panel.outcome(5), "done") << at_panel.textOf("status_text").toStdString();
}

TEST_F(Panel, saysBeforeWhichLimitAJogHasEnded) {
  moveToPreset();
  at_panel.open("jog");
  at_panel.choose("mode", 2);
  at_panel.type("speed", "15");  // what is shown counts, confirmed or not
  for (int tries = 0; tries < 10 && !at_panel.textOf("status_text").contains("limit"); ++tries) {
    at_panel.press("jog_2_plus");
    EXPECT_NE(at_panel.outcome(20), "busy");
    at_panel.release("jog_2_plus");
  }
  EXPECT_TRUE(at_panel.textOf("status_text").contains("J3")) << at_panel.textOf("status_text").toStdString();
  EXPECT_EQ(at_panel.valueOf("speed"), 15);
  at_panel.enter("speed", 10);
}

TEST_F(Panel, jogsTheToolInSteps) {
  moveToPreset();
  at_panel.open("jog");
  at_panel.choose("mode", 1);
  at_panel.tick("stepwise", true);
  at_panel.enter("increment_mm", 20);
  at_panel.click("jog_2_minus");
  EXPECT_EQ(at_panel.outcome(), "done") << at_panel.textOf("status_text").toStdString();
  at_panel.tick("stepwise", false);
  at_panel.open("move_absolute");
  at_panel.click("take_target");
  EXPECT_NEAR(at_panel.valueOf("target.2"), 420, 0.2);
}

}  // namespace
}  // namespace cobot_command::test
