// One robot, by the namespace of its command node: what it tells, and what always has to be at hand: stop,
// pause and resume.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/command.h"
#include "clients/situation.h"
#include <Eigen/Geometry>
#include <cobot_command/ActiveFrames.h>
#include <cobot_command/CommandStatus.h>
#include <cobot_command/GroupState.h>
#include <cobot_command/RobotStatus.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

namespace cobot_command::rviz_plugin {

class Robot {
 public:
  /// `name`: its namespace.
  explicit Robot(const std::string& name);
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;
  ~Robot();

  /// What comes by it is served by listen().
  [[nodiscard]] const ros::NodeHandle& node() const { return node_; }
  /// Often, on the thread of the user interface: serves all that has come. RViz itself serves nothing while
  /// one of its dialogs is open.
  void listen() { queue_.callAvailable(); }

  /// Nothing: the node is not there, or has told nothing yet.
  [[nodiscard]] std::optional<cobot_command::CommandStatus> commandStatus() const;
  [[nodiscard]] std::optional<cobot_command::RobotStatus> robotStatus() const;
  [[nodiscard]] std::optional<cobot_command::GroupState> groupState() const;
  /// Commands can be sent.
  [[nodiscard]] bool isReady() const;
  [[nodiscard]] Situation situation() const;
  /// Of J1 to J6 [deg], as the controller streams them.
  [[nodiscard]] std::optional<std::array<double, 6>> joints() const;
  /// The active TCP in the active base [mm, deg].
  [[nodiscard]] std::optional<std::array<double, 6>> tool() const;
  /// The same in the robot base [m].
  [[nodiscard]] std::optional<Eigen::Isometry3d> toolInBase() const;
  /// Called with each pose of the tool.
  void onTool(std::function<void()> listener) { tool_listener_ = std::move(listener); }
  /// As in joint_states; none: it has told nothing yet.
  [[nodiscard]] const std::vector<std::string>& jointNames() const { return joints_.name; }
  /// Whether joints and tool are of now: a connection alone tells nothing.
  [[nodiscard]] bool isStreaming() const;
  /// The node says that the controller tells where the robot is, and tells nothing of it itself.
  [[nodiscard]] bool isSilent() const;
  /// Called when base or TCP have become others.
  void onFrames(std::function<void()> listener) { frames_listener_ = std::move(listener); }
  /// The frame in tf of the robot base; empty: nobody has told it yet.
  [[nodiscard]] const std::string& baseFrame() const { return frames_.header.frame_id; }
  [[nodiscard]] const cobot_command::ActiveFrames& activeFrames() const { return frames_; }
  /// The frame in tf that the numbers of moves are in; empty: nobody has told it yet.
  [[nodiscard]] std::string activeBaseFrame() const;

  [[nodiscard]] Command& stopping() { return *stop_.command; }
  [[nodiscard]] Command& control() { return *control_.command; }
  void stop() { stop_.send(); }
  void pause() { control_.send(); }
  void resume() { resume_(); }

  /// From time to time, on the thread of the user interface.
  void look();

 private:
  struct Sender {
    std::unique_ptr<Command> command;
    std::function<void()> send;
  };

  ros::CallbackQueue queue_;  ///< first: all others are served by it
  ros::NodeHandle node_;
  std::optional<cobot_command::CommandStatus> command_status_;
  std::optional<cobot_command::RobotStatus> robot_status_;
  std::optional<cobot_command::GroupState> group_state_;
  sensor_msgs::JointState joints_;
  geometry_msgs::PoseStamped tool_;
  cobot_command::ActiveFrames frames_;
  Sender stop_;
  Sender control_;
  std::function<void()> resume_;
  std::function<void()> tool_listener_;
  std::function<void()> frames_listener_;
  ros::WallTime tool_heard_;
  /// Last: they are gone before what they write into.
  ros::Subscriber command_status_topic_, robot_status_topic_, group_state_topic_, joints_topic_, tool_topic_,
      frames_topic_;
};

}  // namespace cobot_command::rviz_plugin
