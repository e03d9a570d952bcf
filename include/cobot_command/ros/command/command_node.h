// The command node of one robot: action servers and publishers around one command core.
//
// Everything it offers is relative to the node's namespace, so several robots are several namespaces.
//
// Threads: stops, pauses, cancels and keep-alives have one of their own, on which nothing waits for anything
// outside of this process, or for a lock that is held while somebody does. Services that wait have one for
// each kind of what they wait for. Goals, timers and all the rest are served by who spins the global queue;
// to be done by one thread.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>

#include "cobot_command/Finish.h"
#include "cobot_command/ros/command/action_bridge.h"
#include "cobot_command/ros/command/command_parameters.h"
#include "cobot_command/ros/command/diagnostics.h"
#include "cobot_command/ros/command/goal_files.h"
#include "cobot_command/ros/command/goal_intake.h"
#include "cobot_command/ros/command/status_publisher.h"
#include "cobot_command/ros/command/tf_frames.h"
#include "cobot_command/ros/shared/receipts.h"
#include "cobot_command/ros/shared/serving_thread.h"
#include "cobot_command/runtime/command/command_runtime.h"

namespace cobot_command::ros_adapter {

class ArmOfNow;
class CellSeat;
class DynamicsServices;
class ExchangeServices;
class InterruptionServices;
class KinematicsServices;
class MessageServices;
class PathPublisher;
class PathServices;
class RobotDataPublisher;
class TableServices;

class CommandNode {
 public:
  /// `self`: the node's private namespace.
  /// `seat`: in its cell; nullptr: it is in none.
  CommandNode(const ros::NodeHandle& node, const ros::NodeHandle& self, CommandParameters parameters,
              std::unique_ptr<CellSeat> seat = nullptr);
  ~CommandNode();  ///< stop()
  CommandNode(const CommandNode&) = delete;
  CommandNode& operator=(const CommandNode&) = delete;

  /// Begins the end, and returns at once: the robot is told to stop, behind what the core is at, which may be
  /// a long planning; then `begun` is called, on the core's thread. From any thread.
  void retire(const std::function<void()>& begun);
  /// Ends every open goal, closes the connections and joins the core's thread. When it returns the results
  /// are on their way. Once the end has begun (retire()), which it waits for, it takes at most 0.4 s,
  /// whatever the robot, the master and the clients do.
  void stop();

 private:
  // On the core's thread.
  void onAction(const command::Action& action, Instant now);
  void tellGoals(const command::Action& action, const ClockPair& clocks);
  void tellPaths(const command::Action& action);
  void tellRobot(const command::Action& action, const ClockPair& clocks);

  void makeServices(const ros::NodeHandle& node, const CommandParameters& parameters);
  void startCore(const ros::NodeHandle& node, CommandParameters parameters);
  [[nodiscard]] command::CorePorts ports();
  [[nodiscard]] GoalSink goalSink();
  [[nodiscard]] GoalSink stopSink();
  [[nodiscard]] GoalIntake::Core intakeCore();
  [[nodiscard]] FileSource fileSource();
  [[nodiscard]] std::unique_ptr<TableServices> tableServices(const ros::NodeHandle& node,
                                                             const TableParameters& parameters);
  [[nodiscard]] std::unique_ptr<PathServices> pathServices(const ros::NodeHandle& node);
  [[nodiscard]] std::unique_ptr<MessageServices> messageServices(const ros::NodeHandle& node);
  [[nodiscard]] std::unique_ptr<DynamicsServices> dynamicsServices(const ros::NodeHandle& node);
  [[nodiscard]] GoalListener& of(blocks::Block block) const {
    return *servers_[static_cast<std::size_t>(block)];
  }
  void end(blocks::Block block, blocks::GoalId id, const blocks::Outcome& outcome);
  /// Of the intake's goals, those that have fallen with a command of the core.
  void endFallen();
  void submit(blocks::GoalId id, blocks::Goal goal);
  [[nodiscard]] std::array<ServingThread*, 5> threads() {
    return {&stops_, &interruptions_, &controls_, &disk_, &questions_};
  }
  void adjustRetrying();
  [[nodiscard]] ros::Subscriber keepAlives(const ros::NodeHandle& node);
  bool finish(cobot_command::Finish::Request& request, cobot_command::Finish::Response& response);

  Receipts receipts_;
  NumberedQueue spinner_;
  ServingThread stops_;
  ServingThread interruptions_;  ///< wait for the controller, as the next
  ServingThread controls_;       ///< of speeds and paths
  ServingThread disk_;           ///< services that wait for a disk
  ServingThread questions_;      ///< services that wait for the core alone, or calculate
  std::unique_ptr<CellSeat> seat_;
  std::string default_host_;
  int default_port_;
  std::mutex fell_mutex_;
  std::vector<command::CommandsFell> fell_;  ///< told by the core, not to the intake yet
  std::unique_ptr<ArmOfNow> arm_;            ///< for services that calculate beside the core
  StatusPublisher publisher_;
  std::unique_ptr<PathPublisher> paths_;
  Diagnostics diagnostics_;
  TfFrames frames_;
  GoalFiles goal_files_;
  GoalIntake intake_;
  std::vector<std::unique_ptr<GoalListener>> servers_;  ///< by their blocks
  std::unique_ptr<TableServices> tables_;
  std::unique_ptr<PathServices> path_services_;
  std::unique_ptr<MessageServices> messages_;
  std::unique_ptr<ExchangeServices> exchange_;
  std::unique_ptr<InterruptionServices> interruption_;
  std::unique_ptr<KinematicsServices> kinematics_;
  std::unique_ptr<RobotDataPublisher> robot_data_;
  std::unique_ptr<DynamicsServices> dynamics_;
  std::unique_ptr<runtime::CommandRuntime> runtime_;  ///< below all that its thread speaks to
  ros::SteadyTimer retry_;
  ros::Subscriber keep_alive_;
  ros::ServiceServer finish_;
  bool stopped_ = false;
};

}  // namespace cobot_command::ros_adapter
