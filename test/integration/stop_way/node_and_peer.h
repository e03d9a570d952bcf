// A command node as a process, connected to a robot that takes everything and never moves.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "command_process.h"
#include "event_log.h"
#include "move_goal.h"
#include "own_folder.h"
#include "script_peer.h"
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include "cobot_command/CommandStatus.h"
#include "cobot_command/MoveAbsoluteActionGoal.h"
#include "cobot_command/StopActionGoal.h"

namespace cobot_command::testing {

class NodeAndPeer {
 public:
  /// `output`: of the node's log.
  explicit NodeAndPeer(std::optional<int> output = std::nullopt)
      : command({"__ns:=/timed", "_robot_model:=tm5-900", "_robot_ip:=127.0.0.1",
                 "_script_port:=" + std::to_string(peer.ports().script),
                 "_status_port:=" + std::to_string(peer.ports().status), "_auto_connect:=true",
                 "_tf_from_start:=false", "_reply_timeout:=60", "_tables_file:=" + folder.file("tables")},
                output) {
    listeners.start();
  }
  ~NodeAndPeer() { listeners.stop(); }
  NodeAndPeer(const NodeAndPeer&) = delete;
  NodeAndPeer& operator=(const NodeAndPeer&) = delete;

  void awaitReady() {
    EXPECT_TRUE(statuses.waitUntil([](const auto& seen) {
      return !seen.empty() && seen.back() == cobot_command::CommandStatus::READY;
    })) << "the command node is not ready";
    awaitListener(moves);
    awaitListener(stops);
  }
  /// Which the node listens to by now.
  template <class Message>
  [[nodiscard]] ros::Publisher advertised(const std::string& topic, std::uint32_t queue_size) {
    const auto publisher = handle.advertise<Message>(topic, queue_size);
    awaitListener(publisher);
    return publisher;
  }

  runtime::ScriptPeer peer;
  ros_adapter::OwnFolder folder;
  CommandProcess command;
  ros::CallbackQueue queue;
  ros::AsyncSpinner listeners{1, &queue};
  ros::NodeHandle handle{[this] {
    ros::NodeHandle in_its_namespace("/timed");
    in_its_namespace.setCallbackQueue(&queue);
    return in_its_namespace;
  }()};
  EventLog<int> statuses;
  ros::Publisher moves = handle.advertise<cobot_command::MoveAbsoluteActionGoal>("move_absolute/goal", 1000);
  ros::Publisher stops = handle.advertise<cobot_command::StopActionGoal>("stop/goal", 10);

 private:
  static void awaitListener(const ros::Publisher& publisher) {
    const auto deadline = std::chrono::steady_clock::now() + kDeadline;
    while (publisher.getNumSubscribers() == 0 && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::yield();
    }
    EXPECT_GT(publisher.getNumSubscribers(), 0U) << publisher.getTopic();
  }

  ros::Subscriber status_ = handle.subscribe<cobot_command::CommandStatus>(
      "command_status", 10, [this](const auto& message) { statuses.add(message->link_state); });
};

}  // namespace cobot_command::testing
