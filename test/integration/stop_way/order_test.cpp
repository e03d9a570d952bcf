// Stops, pauses and cancels go first: whatever the command node is at, or waits for, and in the order in
// which messages were received. The queue of goals is served only where a test says so.
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "event_log.h"
#include "move_goal.h"
#include "own_folder.h"
#include "ros_master.h"
#include "script_peer.h"
#include "slow_disk.h"
#include <boost/make_shared.hpp>
#include <gmock/gmock.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>

#include "cobot_command/ChangeSpeedOverride.h"
#include "cobot_command/CommandStatus.h"
#include "cobot_command/MoveAbsoluteActionGoal.h"
#include "cobot_command/MoveAbsoluteActionResult.h"
#include "cobot_command/SetOutputActionGoal.h"
#include "cobot_command/SetOutputActionResult.h"
#include "cobot_command/StopActionGoal.h"
#include "cobot_command/WriteLoad.h"
#include "cobot_command/ros/cell/cell_seat.h"
#include "cobot_command/ros/command/command_node.h"

namespace cobot_command::ros_adapter {
namespace {

using actionlib_msgs::GoalStatus;

struct Ended {
  std::string goal;
  int status;
  std::string why;
};

/// Twenty clients that call a service which takes as long as it may. When the first one has its answer, all
/// others are in the queue of the service: whatever comes into that queue now is served after all of them.
class ManyCalls {
 public:
  explicit ManyCalls(const std::function<void()>& call) {
    for (int client = 0; client < kClients; ++client) {
      clients_.emplace_back([this, call] {
        call();
        answered_.add(0);
      });
    }
  }
  ~ManyCalls() {
    for (std::thread& client : clients_) client.join();
  }
  ManyCalls(const ManyCalls&) = delete;
  ManyCalls& operator=(const ManyCalls&) = delete;

  void waitUntilOneIsAnswered() const {
    EXPECT_TRUE(answered_.waitUntil([](const auto& answers) { return !answers.empty(); }));
  }
  [[nodiscard]] bool areWaiting() const { return answered_.events().size() < kClients; }

 private:
  static constexpr int kClients = 20;
  mutable testing::EventLog<int> answered_;
  std::vector<std::thread> clients_;
};

/// At once into the queue of its subscriber: messages are received in the order in which they are published.
template <class Message>
void publish(const ros::Publisher& publisher, const Message& message) {
  publisher.publish(boost::make_shared<Message>(message));
}

/// A command node that is connected to a robot which takes everything and never moves.
class StopWay : public ::testing::Test {
 protected:
  StopWay() {
    CommandParameters parameters;
    parameters.arm = *arm::ArmModel::named("tm5-900");
    parameters.robot_ip = "127.0.0.1";
    parameters.script_port = peer.ports().script;
    parameters.link.status_port = peer.ports().status;
    parameters.link.reply_timeout = std::chrono::minutes(1);
    parameters.auto_connect = true;
    parameters.tf_from_start = false;
    parameters.tables.file = folder.file("tables.yaml");
    command = std::make_unique<CommandNode>(node, ros::NodeHandle("~"), std::move(parameters));
    listeners.start();
    EXPECT_TRUE(statuses.waitUntil([](const auto& seen) {
      return !seen.empty() && seen.back() == cobot_command::CommandStatus::READY;
    }));
  }
  ~StopWay() override {
    testing::SlowDisk::instance().goOn();
    testing::RosMaster::instance().goOn();
    peer.letAnswersGo();
    command.reset();
    listeners.stop();
  }

  static cobot_command::MoveAbsoluteActionGoal move(const std::string& id, double joint = 10) {
    auto goal = testing::moveOf(joint);
    goal.goal_id.id = id;
    return goal;
  }
  void stop() {
    cobot_command::StopActionGoal goal;
    goal.goal_id.id = "stop " + std::to_string(++stops_sent);
    publish(stop_goals, goal);
  }
  void cancelMoves(const std::string& id = "") {
    actionlib_msgs::GoalID cancel;
    cancel.id = id;
    publish(move_cancels, cancel);
  }
  [[nodiscard]] bool hearsStop() { return peer.timeOf(runtime::kStop, 0).has_value(); }

  /// Serves goals until that one has ended; how.
  int endOf(const std::string& goal) {
    const auto deadline = std::chrono::steady_clock::now() + testing::kDeadline;
    while (std::chrono::steady_clock::now() < deadline) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
      for (const Ended& ended : ends.events()) {
        if (ended.goal != goal) continue;
        why_ended = ended.why;
        return ended.status;
      }
    }
    return -1;
  }
  void beginMove() {
    publish(move_goals, move("first"));
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration());
    ASSERT_TRUE(peer.timeOf("PTP", 0).has_value()) << (ends.events().empty() ? "" : ends.events().back().why);
  }

  runtime::ScriptPeer peer;
  OwnFolder folder;
  ros::NodeHandle node{"robot"};
  ros::CallbackQueue queue;
  ros::AsyncSpinner listeners{1, &queue};
  ros::NodeHandle watcher{[this] {
    ros::NodeHandle handle("robot");
    handle.setCallbackQueue(&queue);
    return handle;
  }()};
  testing::EventLog<int> statuses;
  testing::EventLog<Ended> ends;
  ros::Subscriber status = watcher.subscribe<cobot_command::CommandStatus>(
      "command_status", 10, [this](const auto& message) { statuses.add(message->link_state); });
  ros::Subscriber move_ends = watcher.subscribe<cobot_command::MoveAbsoluteActionResult>(
      "move_absolute/result", 10, [this](const auto& message) {
        ends.add({message->status.goal_id.id, message->status.status, message->result.error_description});
      });
  ros::Subscriber output_ends = watcher.subscribe<cobot_command::SetOutputActionResult>(
      "set_output/result", 10, [this](const auto& message) {
        ends.add({message->status.goal_id.id, message->status.status, message->result.error_description});
      });
  ros::Publisher move_goals =
      watcher.advertise<cobot_command::MoveAbsoluteActionGoal>("move_absolute/goal", 10);
  ros::Publisher move_cancels = watcher.advertise<actionlib_msgs::GoalID>("move_absolute/cancel", 10);
  ros::Publisher output_goals = watcher.advertise<cobot_command::SetOutputActionGoal>("set_output/goal", 10);
  ros::Publisher stop_goals = watcher.advertise<cobot_command::StopActionGoal>("stop/goal", 10);
  std::string why_ended;  ///< the goal that was asked for last
  int stops_sent = 0;
  std::unique_ptr<CommandNode> command;
};

TEST_F(StopWay, goalsThatWereReceivedBeforeAStopNeverBegin) {
  publish(move_goals, move("move"));
  cobot_command::SetOutputActionGoal output;
  output.goal_id.id = "output";
  output.goal.module = "ControlBox";
  output.goal.value = 1;
  output.goal.at_once = true;
  publish(output_goals, output);
  stop();
  ASSERT_TRUE(hearsStop());
  EXPECT_EQ(endOf("move"), GoalStatus::RECALLED);
  EXPECT_EQ(endOf("output"), GoalStatus::RECALLED);
  EXPECT_FALSE(peer.hasHeard("PTP"));
  EXPECT_FALSE(peer.hasHeard("IO["));
}

TEST_F(StopWay, goalsThatWereReceivedBeforeACancelOfAllNeverBegin) {
  publish(move_goals, move("one"));
  publish(move_goals, move("two"));
  cancelMoves();
  EXPECT_EQ(endOf("one"), GoalStatus::RECALLED);
  EXPECT_EQ(endOf("two"), GoalStatus::RECALLED) << why_ended;
  EXPECT_FALSE(peer.hasHeard("PTP"));
}

TEST_F(StopWay, aGoalThatIsReceivedAfterACancelOfAllBegins) {
  publish(move_goals, move("before"));
  cancelMoves();
  publish(move_goals, move("after"));
  EXPECT_EQ(endOf("before"), GoalStatus::RECALLED);
  EXPECT_TRUE(peer.timeOf("PTP", 0).has_value());
}

TEST_F(StopWay, aCancelByIdTakesItsGoalOutOfThoseThatAreNotServedYet) {
  publish(move_goals, move("one"));
  cancelMoves("one");
  EXPECT_EQ(endOf("one"), GoalStatus::RECALLED);
  EXPECT_FALSE(peer.hasHeard("PTP"));
}

TEST_F(StopWay, aCancelThatOvertakesItsGoalIsKept) {
  cancelMoves("one");
  publish(move_goals, move("one"));
  EXPECT_EQ(endOf("one"), GoalStatus::RECALLED);
  EXPECT_FALSE(peer.hasHeard("PTP"));
}

TEST_F(StopWay, aCancelStopsWhatIsUnderWayThoughNoGoalIsServed) {
  beginMove();
  cancelMoves("first");
  EXPECT_TRUE(hearsStop());
}

TEST_F(StopWay, nothingIsKeptOfAGoalThatHasEndedButItsStatus) {
  auto message = boost::make_shared<cobot_command::MoveAbsoluteActionGoal>(move("refused", 1000));
  const boost::weak_ptr<cobot_command::MoveAbsoluteActionGoal> content = message;
  move_goals.publish(message);
  message.reset();
  EXPECT_EQ(endOf("refused"), GoalStatus::REJECTED);
  command->stop();  // whoever has ended it has let go of it
  EXPECT_TRUE(content.expired());
}

TEST_F(StopWay, aStopWaitsForNoDisk) {
  beginMove();
  testing::SlowDisk::instance().hang();
  const ManyCalls calls([this] {
    cobot_command::WriteLoad call;
    call.request.load.index = 1;
    call.request.load.mass = 1;
    EXPECT_TRUE(node.serviceClient<cobot_command::WriteLoad>("write_load").call(call));
  });
  ASSERT_TRUE(testing::SlowDisk::instance().isWaitedFor());
  calls.waitUntilOneIsAnswered();
  stop();
  EXPECT_TRUE(hearsStop());
  EXPECT_TRUE(calls.areWaiting());
  testing::SlowDisk::instance().goOn();
}

TEST_F(StopWay, aStopWaitsForNoServiceThatWaitsForTheController) {
  beginMove();
  peer.holdAnswersTo("Pause");
  const ManyCalls calls([this] {
    cobot_command::ChangeSpeedOverride call;
    EXPECT_TRUE(node.serviceClient<cobot_command::ChangeSpeedOverride>("change_speed_override").call(call));
  });
  ASSERT_TRUE(peer.timeOf("Pause", 0).has_value());
  calls.waitUntilOneIsAnswered();
  stop();
  EXPECT_TRUE(hearsStop());
  EXPECT_TRUE(calls.areWaiting());
  peer.letAnswersGo();
}

TEST_F(StopWay, aStopWaitsForNoMaster) {
  beginMove();
  testing::RosMaster::instance().hang();
  auto in_frame = move("in a frame");
  in_frame.goal.target_pose.header.frame_id = "table";
  publish(move_goals, in_frame);
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration());
  stop();
  EXPECT_TRUE(hearsStop());
  EXPECT_EQ(endOf("in a frame"), GoalStatus::RECALLED);
  testing::RosMaster::instance().goOn();
}

}  // namespace
}  // namespace cobot_command::ros_adapter
