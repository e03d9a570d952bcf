// Several robots, several panels: each button acts on the robot that is written above it, each panel has a
// target of its own.
#include <QDockWidget>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "panel_fixture.h"
#include <gtest/gtest.h>
#include <ros/node_handle.h>
#include <rviz/visualization_frame.h>
#include <visualization_msgs/InteractiveMarkerFeedback.h>
#include <visualization_msgs/InteractiveMarkerInit.h>
#include <visualization_msgs/InteractiveMarkerUpdate.h>

namespace cobot_command::test {
namespace {

/// Its node is there, and nobody has connected it: whatever is sent to it fails.
constexpr const char* kOther = "/second";

TEST_F(Panel, actsOnTheRobotThatItShowsAndNotOnOneThatWasTypedAndNotConfirmed) {
  ASSERT_TRUE(holdsSoon([this] { return at_panel.offersRobot(kOther); }));
  at_panel.open("change_base");
  at_panel.typeRobot(kOther);
  EXPECT_EQ(at_panel.robot(), kOther) << "so it stands in the box";
  at_panel.click("execute");
  EXPECT_EQ(at_panel.robot(), "/");
  EXPECT_EQ(at_panel.outcome(), "done") << at_panel.textOf("status_text").toStdString();
}

TEST_F(Panel, showsTheRobotThatStopIsForAsSoonAsStopIsClicked) {
  ASSERT_TRUE(holdsSoon([this] { return at_panel.offersRobot(kOther); }));
  at_panel.typeRobot(kOther);
  at_panel.clickStop();
  EXPECT_EQ(at_panel.robot(), "/");
  EXPECT_TRUE(holdsSoon([this] {
    return at_panel.textAlways("stop_text") == "Stop: the robot is at standstill";
  })) << at_panel.textAlways("stop_text").toStdString();
}

TEST_F(Panel, doesNothingForAnotherRobotWithAButtonThatWasPressedForTheOneBefore) {
  at_panel.open("change_base");
  at_panel.press("execute");
  at_panel.chooseRobot(kOther);
  at_panel.release("execute");
  EXPECT_FALSE(at_panel.isLit("busy") || at_panel.isLit("error"));
}

TEST_F(Panel, choosesNoRobotByTheWheel) {
  ASSERT_TRUE(holdsSoon([this] { return at_panel.offersRobot(kOther); }));
  at_panel.scrollOverRobots();
  EXPECT_EQ(at_panel.robot(), "/");
}

TEST_F(Panel, stopsAllRobotsWhicheverIsChosen) {
  ASSERT_NO_FATAL_FAILURE(moveSlowly(300));
  at_panel.chooseRobot(kOther);
  ASSERT_TRUE(holdsSoon([this] { return at_panel.isThere("stop_all"); }));
  at_panel.clickAlways("stop_all");
  EXPECT_TRUE(holdsSoon([this] {
    const QString told = at_panel.textAlways("stop_text");
    const bool both = told.startsWith("Stop all: 2 of 2 robots stopped");
    return both ||
           (told.startsWith("Stop all: 1 of 2 robots stopped") && told.contains(QString(kOther) + ": "));
  })) << at_panel.textAlways("stop_text").toStdString();
  at_panel.chooseRobot("/");
  EXPECT_TRUE(holdsSoon([this] { return isReady() && !at_panel.link().contains("moving"); }));
}

/// The marker of a panel, as the display of RViz is told of it, and drags it.
class Markers {
 public:
  Markers() {
    const std::string topic = ownTopic("preview_target");
    told_ = node_.subscribe<visualization_msgs::InteractiveMarkerInit>(
        topic + "/update_full", 10, [this](const visualization_msgs::InteractiveMarkerInit::ConstPtr& told) {
          for (const auto& marker : told->markers) add(marker.name);
        });
    changed_ = node_.subscribe<visualization_msgs::InteractiveMarkerUpdate>(
        topic + "/update", 10, [this](const visualization_msgs::InteractiveMarkerUpdate::ConstPtr& told) {
          for (const auto& marker : told->markers) add(marker.name);
          for (const auto& pose : told->poses) add(pose.name);
        });
    mouse_ = node_.advertise<visualization_msgs::InteractiveMarkerFeedback>(topic + "/feedback", 1);
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool areHeard() const { return mouse_.getNumSubscribers() > 0; }

  void drag(const std::string& name, const std::string& by, double x) {
    visualization_msgs::InteractiveMarkerFeedback dragged;
    dragged.header.frame_id = "active_base";
    dragged.marker_name = name;
    dragged.client_id = by;
    dragged.event_type = visualization_msgs::InteractiveMarkerFeedback::POSE_UPDATE;
    dragged.pose.position.x = x;
    dragged.pose.position.y = 0.1;
    dragged.pose.position.z = 0.35;
    dragged.pose.orientation.x = 1;
    mouse_.publish(dragged);
  }

 private:
  void add(const std::string& name) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  }

  ros::NodeHandle node_;
  std::vector<std::string> names_;
  ros::Publisher mouse_;
  ros::Subscriber told_, changed_;
};

TEST_F(Panel, takesATargetThatIsDraggedInTheScene) {
  Markers markers;
  at_panel.open("move_absolute");
  at_panel.click("preset");
  ASSERT_TRUE(holdsSoon([&] { return markers.areHeard() && !markers.names().empty(); }));
  markers.drag(markers.names().back(), ownTopic("Target"), 0.45);
  EXPECT_TRUE(holdsSoon([this] { return std::abs(at_panel.valueOf("target.0") - 450) < 0.01; }));
  EXPECT_NEAR(at_panel.valueOf("target.1"), 100, 0.01);
  EXPECT_NEAR(at_panel.valueOf("target.3"), 180, 0.01);
}

TEST_F(Panel, takesNoTargetThatIsDraggedInAnotherRviz) {
  Markers markers;
  at_panel.open("move_absolute");
  at_panel.click("preset");
  ASSERT_TRUE(holdsSoon([&] { return markers.areHeard() && !markers.names().empty(); }));
  markers.drag(markers.names().back(), "/another_rviz/Target", 0.48);
  double most = 0;
  EXPECT_TRUE(holdsSoon([&] {
    // By the same connection, so it comes after the other one; and again, as for a second the marker is the
    // other's.
    markers.drag(markers.names().back(), ownTopic("Target"), 0.45);
    most = std::max(most, at_panel.valueOf("target.0"));
    return std::abs(at_panel.valueOf("target.0") - 450) < 0.01;
  }));
  EXPECT_LT(most, 470);
}

/// A second panel in this RViz, on the same robot.
class TwoPanels : public Panel {
 protected:
  TwoPanels() {
    dock_.reset(
        window->rviz().addPanelByName("Cobot 2", "cobot_command/Cobot", Qt::LeftDockWidgetArea, true));
    other_ = dock_->findChild<QWidget*>("cobot_panel");
  }
  ~TwoPanels() override { dock_->close(); }

  std::unique_ptr<QDockWidget> dock_;
  QWidget* other_ = nullptr;
};

TEST_F(TwoPanels, haveATargetOfTheirOwnEach) {
  Operator at_other(*dock_, *other_, "");
  Markers markers;
  at_panel.open("move_absolute");
  at_panel.click("preset");
  ASSERT_TRUE(holdsSoon([&] { return markers.areHeard() && !markers.names().empty(); }));
  const std::string own = markers.names().back();
  ASSERT_TRUE(holdsSoon([&] { return at_other.link().startsWith("ready"); }));
  at_other.open("move_absolute");
  at_other.click("preset");
  ASSERT_TRUE(holdsSoon([&] { return markers.names().back() != own; }));
  markers.drag(own, ownTopic("Target"), 0.45);
  markers.drag(markers.names().back(), ownTopic("Target"), 0.50);
  EXPECT_TRUE(holdsSoon([&] {
    return std::abs(at_panel.valueOf("target.0") - 450) < 0.01 &&
           std::abs(at_other.valueOf("target.0") - 500) < 0.01;
  })) << at_panel.valueOf("target.0")
      << ", " << at_other.valueOf("target.0");
}

}  // namespace
}  // namespace cobot_command::test
