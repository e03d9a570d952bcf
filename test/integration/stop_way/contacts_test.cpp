// Whoever watches several robots goes on while the master hangs, and reaches a robot that was heard meanwhile
// as soon as it answers.
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "cell_watch/stop_line.h"
#include "event_log.h"
#include "ros_master.h"
#include "shared/steady_now.h"
#include "supervision/robot_contact.h"
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include "cobot_command/StopActionGoal.h"

namespace cobot_command::ros_adapter {
namespace {

class RobotHeardWhileTheMasterHangs : public ::testing::Test {
 protected:
  RobotHeardWhileTheMasterHangs() { listener.start(); }
  ~RobotHeardWhileTheMasterHangs() override {
    testing::RosMaster::instance().goOn();
    listener.stop();
  }
  /// Whether its node is told, when the master answers again.
  [[nodiscard]] bool isToldToStopBy(const std::function<void()>& stop) {
    testing::RosMaster::instance().goOn();
    const auto deadline = steadyNow() + testing::kDeadline;
    while (goals.events().empty() && steadyNow() < deadline) stop();
    return !goals.events().empty();
  }

  std::shared_ptr<ros::CallbackQueue> queue = std::make_shared<ros::CallbackQueue>();
  ros::AsyncSpinner listener{1, queue.get()};
  ros::NodeHandle node{[this] {
    ros::NodeHandle handle;
    handle.setCallbackQueue(queue.get());
    return handle;
  }()};
  testing::EventLog<std::string> goals;
  ros::Subscriber subscriber = node.subscribe<cobot_command::StopActionGoal>(
      "/late/stop/goal", 10, [this](const auto& goal) { goals.add(goal->goal_id.id); });
};

TEST_F(RobotHeardWhileTheMasterHangs, isReachedByTheSupervisorWhenItAnswers) {
  RobotContact contact(node);
  testing::RosMaster::instance().hang();
  contact.heardFrom("/late/command_node", true, steadyNow());
  contact.stop(steadyNow());
  EXPECT_EQ(contact.programs(), nullptr);
  EXPECT_TRUE(isToldToStopBy([&] { contact.settle(steadyNow()); }));
}

TEST_F(RobotHeardWhileTheMasterHangs, keepsNoOtherRobotWaiting) {
  testing::EventLog<std::string> others;
  const ros::Subscriber other = node.subscribe<cobot_command::StopActionGoal>(
      "/early/stop/goal", 10, [&others](const auto& goal) { others.add(goal->goal_id.id); });
  RobotContact known(node);
  known.heardFrom("/early/command_node", true, steadyNow());
  RobotContact wandering(node);
  wandering.heardFrom("/before/command_node", true, steadyNow());
  StopLine line(node, queue, "A", "/early");
  while (!line.isConnected()) std::this_thread::yield();
  testing::RosMaster::instance().hang();
  wandering.heardFrom("/late/command_node", true, steadyNow());
  static_cast<void>(known.programs());
  line.stop();
  EXPECT_TRUE(others.waitUntil([](const auto& ids) { return !ids.empty(); }));
  testing::RosMaster::instance().goOn();  // at its end each asks it
}

TEST_F(RobotHeardWhileTheMasterHangs, isReachedByTheMonitorWhenItAnswers) {
  StopLine line(node, queue, "A", "/early");
  testing::RosMaster::instance().hang();
  line.moveTo("/late");
  EXPECT_FALSE(line.isConnected());
  EXPECT_TRUE(isToldToStopBy([&] {
    if (line.isConnected()) line.stop();
  }));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
