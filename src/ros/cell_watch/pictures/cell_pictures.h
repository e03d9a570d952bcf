// The pictures of a cell for RViz: bodies as measured, zones by the supervisor's state, claims on request,
// the shortest way between robots and mechanisms. On ROS's spinner.
#pragma once

#include <future>
#include <optional>
#include <string>
#include <vector>

#include "cell_watch/pictures/cell_markers.h"
#include "cell_watch/pictures/watch_view.h"
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <std_srvs/SetBool.h>

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

class CellPictures {
 public:
  /// Topics and services are relative to `node`. Without a scene there are no zones.
  CellPictures(const ros::NodeHandle& node, cell::Cell cell, std::optional<CellScene> scene);

  /// Shows where bodies are and how close robots are, and claims that were found meanwhile. To be called a
  /// few times a second.
  void show(const WatchView& view);

 private:
  using Claims = Result<std::vector<cell::RobotClaim>, std::vector<std::string>>;

  void hear(const cobot_command::CellState& state);
  bool showClaims(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void publishClaims();
  void showBodies(const WatchView& view);

  OwnHandle node_;
  cell::Cell cell_;
  std::optional<CellScene> scene_;
  std::vector<cobot_command::CellZone> shown_zones_;
  visualization_msgs::MarkerArray shown_bodies_;
  bool are_obstacles_shown_ = false;
  bool is_way_shown_ = false;
  bool are_claims_wanted_ = false;
  std::future<Claims> found_claims_;  ///< on their way
  std::optional<std::vector<cell::RobotClaim>> claims_;
  ros::Publisher bodies_;
  ros::Publisher obstacles_;
  ros::Publisher zones_;
  ros::Publisher claims_topic_;
  ros::Publisher closest_;
  ros::Subscriber states_;
  ros::ServiceServer show_claims_;
};

}  // namespace cobot_command::ros_adapter
