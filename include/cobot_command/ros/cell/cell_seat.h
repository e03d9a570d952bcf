// The seat of a robot's command node in its cell: the robot's agent, on the core's thread, and the topics
// between the agent and the supervisor.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>

#include "cobot_command/CellState.h"
#include "cobot_command/cell/agent/agent.h"
#include "cobot_command/command/command_status.h"
#include "cobot_command/command/core_ports.h"
#include "cobot_command/common/result.h"
#include "cobot_command/ros/cell/cell_parameters.h"

namespace cobot_command::ros_adapter {

class CellSeat {
 public:
  /// Calls the function on the core's thread; the core checks its goals again afterwards.
  using InCore = std::function<void(std::function<void(Instant now)>)>;

  /// `model`: of the robot; empty: its name is not known. An error is a sentence.
  [[nodiscard]] static Result<std::unique_ptr<CellSeat>, std::string> of(const CellParameters& parameters,
                                                                         const std::string& model);
  ~CellSeat();

  /// Sets the ports of the core that this seat is for.
  void fill(command::CorePorts& ports) const;
  /// From now on it receives and publishes, on a thread of its own: a slow service does not stop its
  /// messages.
  void start(const ros::NodeHandle& node, InCore in_core);
  /// It receives nothing any more.
  void stop();
  /// On the core's thread.
  void observe(const link::RobotStatus& status, Instant now);
  void observe(const command::CommandStatus& status, Instant now);

 private:
  explicit CellSeat(std::string cell, std::shared_ptr<cell::Agent> agent, Duration period);
  void hear(const cobot_command::CellState& message);
  void tell(Instant now);

  std::string cell_;
  std::shared_ptr<cell::Agent> agent_;
  Duration period_;
  InCore in_core_;
  ros::CallbackQueue queue_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
  ros::Publisher reports_;
  ros::Subscriber states_;
  ros::SteadyTimer timer_;
};

}  // namespace cobot_command::ros_adapter
