// The command node of one robot: action servers and publishers around one command core.
//
// All its names are relative to the node's namespace, so that each robot has its own namespace.
//
// Threads: stops, pauses, cancels and keep-alives have a thread of their own. Nothing on it waits for
// anything outside this process, or for a lock whose owner does. Services that wait have one thread for each
// kind of thing that they wait for. Goals, timers and everything else are processed by the spinner of the
// global queue, which must be one thread.
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
  /// `self`: the node's private namespace. `seat`: the robot's seat in its cell; nullptr: it is in no cell.
  CommandNode(const ros::NodeHandle& node, const ros::NodeHandle& self, CommandParameters parameters,
              std::unique_ptr<CellSeat> seat = nullptr);
  ~CommandNode();  ///< stop()
  CommandNode(const CommandNode&) = delete;
  CommandNode& operator=(const CommandNode&) = delete;

  /// Begins the shutdown, and returns at once. The robot is stopped after the present work of the core, which
  /// may be a long planning. Then `begun` is called, on the core's thread. Callable from any thread.
  void retire(const std::function<void()>& begun);
  /// Ends every open goal, closes the connections and joins the core's thread. When it returns, the results
  /// are being sent. It waits until the shutdown has begun (retire()). After that it takes at most 0.4 s,
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
  /// Ends those goals of the intake that end together with a command of the core.
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
  ServingThread interruptions_;  ///< services that wait for the controller, as do those of the next thread
  ServingThread controls_;       ///< for speeds and paths
  ServingThread disk_;           ///< services that wait for a disk
  ServingThread questions_;      ///< services that wait for the core alone, or calculate
  std::unique_ptr<CellSeat> seat_;
  std::string default_host_;
  int default_port_;
  std::mutex fell_mutex_;
  std::vector<command::CommandsFell> fell_;  ///< reported by the core; the intake is not notified yet
  std::unique_ptr<ArmOfNow> arm_;            ///< for services that calculate in parallel with the core
  StatusPublisher publisher_;
  std::unique_ptr<PathPublisher> paths_;
  Diagnostics diagnostics_;
  TfFrames frames_;
  GoalFiles goal_files_;
  GoalIntake intake_;
  std::vector<std::unique_ptr<GoalListener>> servers_;  ///< in the order of their blocks
  std::unique_ptr<TableServices> tables_;
  std::unique_ptr<PathServices> path_services_;
  std::unique_ptr<MessageServices> messages_;
  std::unique_ptr<ExchangeServices> exchange_;
  std::unique_ptr<InterruptionServices> interruption_;
  std::unique_ptr<KinematicsServices> kinematics_;
  std::unique_ptr<RobotDataPublisher> robot_data_;
  std::unique_ptr<DynamicsServices> dynamics_;
  std::unique_ptr<runtime::CommandRuntime> runtime_;  ///< declared after everything that its thread calls
  ros::SteadyTimer retry_;
  ros::Subscriber keep_alive_;
  ros::ServiceServer finish_;
  bool stopped_ = false;
};

}  // namespace cobot_command::ros_adapter
