// The monitor of a cell on a thread of its own: joint states in, distances and stops out.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cell_watch/robot_whereabouts.h"
#include "cell_watch/stop_line.h"
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/CellReport.h"
#include "cobot_command/cell/monitor/monitor.h"

namespace cobot_command::ros_adapter {

/// How things stand, for pictures and diagnostics.
struct WatchView {
  struct Robot {
    std::string name;
    std::string space;                       ///< of its command node
    std::optional<arm::JointVector> joints;  ///< as measured last [rad]
    bool takes_stops = false;                ///< somebody listens to them
  };
  cell::MonitorStatus status;
  std::vector<Robot> robots;  ///< in the order of the cell
};

class Watch {
 public:
  /// Of a robot that is heard for the first time, the prefix of its names. On the watch's thread.
  using PrefixTold = std::function<void(std::size_t robot, const std::string& prefix)>;

  /// Topics and services are relative to `node`.
  Watch(const ros::NodeHandle& node, cell::Monitor monitor, RobotWhereabouts whereabouts,
        PrefixTold prefix_told);
  ~Watch();  ///< stop()
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  void start();
  /// Nothing is watched any more. It may be called again.
  void stop();
  /// As it was told last. From any thread.
  [[nodiscard]] WatchView view() const;

 private:
  void listenTo(std::size_t robot);
  void take(std::size_t robot, const sensor_msgs::JointState& message);
  void hear(const ros::MessageEvent<cobot_command::CellReport const>& event);
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  /// Looks, where that is due, does what follows, and has itself called again.
  void advance(Instant now);
  void carryOut();
  void stopAll(const std::string& why);
  void tell(Instant now);
  void arm(Instant now);

  ros::NodeHandle node_;
  ros::CallbackQueue queue_;
  cell::Monitor monitor_;
  RobotWhereabouts whereabouts_;
  PrefixTold prefix_told_;
  std::vector<bool> is_prefix_told_;
  std::vector<std::optional<arm::JointVector>> joints_;
  std::vector<std::unique_ptr<StopLine>> stop_lines_;
  std::vector<ros::Subscriber> joint_states_;
  ros::Subscriber reports_;
  ros::ServiceServer reset_;
  ros::Publisher distances_;
  ros::SteadyTimer timer_;
  std::optional<Instant> armed_;
  bool is_news_ = true;  ///< since it was told last
  Instant told_at_{};
  std::unique_ptr<ros::AsyncSpinner> spinner_;

  mutable std::mutex mutex_;  // guards the next one
  WatchView view_;
};

}  // namespace cobot_command::ros_adapter
