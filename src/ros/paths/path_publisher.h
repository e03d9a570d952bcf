// What everyone is told of paths: path_status; and for RViz planned_path, planned_points and active_point.
//
// Called on the core's thread only.
#pragma once

#include <optional>
#include <string>

#include "paths/path_board.h"
#include "paths/path_markers.h"
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "cobot_command/blocks/load_path.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

/// All topics are latched.
class PathPublisher {
 public:
  /// Topics are relative to `node`. `base_frame`: the tf frame of the robot base.
  PathPublisher(OwnHandle node, std::string base_frame);

  void take(const command::PathPlanned& path);
  void take(const command::GoalPreviewed& preview);
  void take(const command::GoalProgressed& progress);
  void take(const command::GoalEnded& end);
  void take(const command::RunTold& told);
  /// With no path under way the status has what is asked of the next one.
  void take(const command::PathControlsChanged& changed);

 private:
  [[nodiscard]] MarkerSite site() const;
  void showActive();

  std::string base_frame_;
  ros::Publisher line_;
  ros::Publisher points_;
  ros::Publisher active_point_;
  ros::Publisher status_;
  PathBoard board_;
  blocks::PathStatus told_;                ///< last
  std::optional<Eigen::Vector3d> active_;  ///< that was told last
};

}  // namespace cobot_command::ros_adapter
