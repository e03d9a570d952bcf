// How long a stop takes to its frame when everything that may wait does: a command node as a process, twenty
// clients on its services, a disk that takes 0.45 s, a controller that answers 0.3 s late, and a ROS master
// that hangs. The order of events is asserted in order_test.cpp; here it only has to come.
#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "figure.h"
#include "node_and_peer.h"
#include "ros_master.h"
#include "thorough.h"
#include <gtest/gtest.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/CalculateFrame.h"
#include "cobot_command/CalculateTool.h"
#include "cobot_command/ChangeSpeedOverride.h"
#include "cobot_command/ForwardKinematics.h"
#include "cobot_command/InverseKinematics.h"
#include "cobot_command/ReadDefaultDynamics.h"
#include "cobot_command/ReadFrame.h"
#include "cobot_command/ReadLoad.h"
#include "cobot_command/ReadMessages.h"
#include "cobot_command/ReadReferenceDynamics.h"
#include "cobot_command/ReadSoftwareLimits.h"
#include "cobot_command/ReadTool.h"
#include "cobot_command/RunScriptActionGoal.h"
#include "cobot_command/SetFeedrate.h"
#include "cobot_command/SetTracking.h"
#include "cobot_command/UpdateConfiguration.h"
#include "cobot_command/WriteDefaultDynamics.h"
#include "cobot_command/WriteFrame.h"
#include "cobot_command/WriteLoad.h"
#include "cobot_command/WriteReferenceDynamics.h"
#include "cobot_command/WriteTool.h"

namespace cobot_command::testing {
namespace {

constexpr int kClients = 20;
constexpr int kGoalsBefore = 200;
constexpr std::size_t kLargeGoal = 8U << 20U;  // [bytes]

/// A client that calls services until it is ended, each over a connection of its own, as the master hangs:
/// all that a command node has, but for those that end or hold what is under way themselves (finish,
/// interrupt, continue), change between which angles all is planned, and forget messages (reset).
class Client {
 public:
  Client(const ros::NodeHandle& node, int number) : node_(node) {
    cobot_command::WriteLoad load;
    load.request.load.index = 1 + number % 15;
    load.request.load.mass = 1;
    add<cobot_command::WriteLoad>("write_load", load);
    add<cobot_command::WriteTool>("write_tool");
    add<cobot_command::WriteFrame>("write_frame");
    add<cobot_command::ReadLoad>("read_load");
    add<cobot_command::ReadTool>("read_tool");
    add<cobot_command::ReadFrame>("read_frame");
    add<cobot_command::CalculateTool>("calculate_tool");
    add<cobot_command::CalculateFrame>("calculate_frame");
    cobot_command::ChangeSpeedOverride override;
    override.request.percent = 100;
    add<cobot_command::ChangeSpeedOverride>("change_speed_override", override);
    add<cobot_command::ReadReferenceDynamics>("read_reference_dynamics");
    add<cobot_command::WriteReferenceDynamics>("write_reference_dynamics");
    add<cobot_command::ReadDefaultDynamics>("read_default_dynamics");
    add<cobot_command::WriteDefaultDynamics>("write_default_dynamics");
    add<cobot_command::ReadSoftwareLimits>("read_software_limits");
    cobot_command::SetFeedrate feedrate;
    feedrate.request.percent = 100;
    add<cobot_command::SetFeedrate>("set_feedrate", feedrate);
    add<cobot_command::SetTracking>("set_tracking");
    add<std_srvs::Trigger>("stop_on_path");
    add<std_srvs::Trigger>("resume_path");
    add<cobot_command::ReadMessages>("read_messages");
    add<cobot_command::UpdateConfiguration>("update_configuration");
    add<cobot_command::ForwardKinematics>("forward_kinematics");
    add<cobot_command::InverseKinematics>("inverse_kinematics");
  }
  ~Client() {
    is_over_ = true;
    if (thread_.joinable()) thread_.join();
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void start() {
    thread_ = std::thread([this] {
      while (!is_over_) {
        for (const auto& call : calls_) call();
      }
    });
  }

 private:
  template <class Service>
  void add(const std::string& name, Service call = {}) {
    auto client = node_.serviceClient<Service>(name, true);
    calls_.emplace_back([client, call]() mutable { static_cast<void>(client.call(call)); });
  }

  ros::NodeHandle node_;
  std::vector<std::function<void()>> calls_;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

/// Whether goals are received right before each stop.
class StopFigure : public ::testing::TestWithParam<bool> {
 protected:
  StopFigure() {
    node.awaitReady();
    for (int i = 0; i < kClients; ++i) clients.push_back(std::make_unique<Client>(node.handle, i));
  }
  ~StopFigure() override {
    clients.clear();
    RosMaster::instance().goOn();
  }

  void publishGoals() const {
    cobot_command::RunScriptActionGoal large;
    large.goal.script.assign(kLargeGoal, 'x');
    scripts.publish(large);
    for (int i = 0; i < kGoalsBefore; ++i) node.moves.publish(bufferedMoveOf(i % 10));
  }

  NodeAndPeer node;
  ros::Publisher scripts = node.advertised<cobot_command::RunScriptActionGoal>("run_script/goal", 10);
  std::vector<std::unique_ptr<Client>> clients;
};
INSTANTIATE_TEST_SUITE_P(Of, StopFigure, ::testing::Values(false, true), [](const auto& tested) {
  return std::string(tested.param ? "behind_goals" : "behind_no_goals");
});

TEST_P(StopFigure, fromAStopToItsFrameWhileEverythingElseWaits) {
  Figure figure(
      "G21",
      std::string("stop to its frame read by the robot; 20 clients loop services, disk 0.45 s, replies 0.3 s "
                  "late, master stopped") +
          (GetParam() ? ", 200 goals and one of 8 MB before it" : ""),
      "ms", 20, Figure::Limited::NinetyNinthPercentile);
  node.peer.answerAfter(std::chrono::milliseconds(300));
  RosMaster::instance().hang();
  for (const auto& client : clients) client->start();
  for (int i = 0; i < quickOrThorough(2, 100); ++i) {
    node.moves.publish(bufferedMoveOf(20));
    ASSERT_TRUE(node.peer.timeOf("PTP", static_cast<std::size_t>(i)).has_value());
    if (GetParam()) publishGoals();
    const auto start = std::chrono::steady_clock::now();
    node.stops.publish(cobot_command::StopActionGoal());
    const auto heard = node.peer.timeOf(runtime::kStop, static_cast<std::size_t>(i));
    ASSERT_TRUE(heard.has_value());
    figure.add(*heard - start);
  }
}

}  // namespace
}  // namespace cobot_command::testing
