// Zones, claims and distances of a cell as RViz shows them, in the frame `world`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/Point.h>
#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "cobot_command/CellState.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/claims/claims.h"

namespace cobot_command::ros_adapter {

/// Voxels that can be seen: those that have a neighbour outside of the set.
struct VoxelHull {
  double edge = 0;                            ///< [m]
  std::vector<geometry_msgs::Point> centres;  ///< [m]
  cell::AlignedBox box;                       ///< around all of them [m]
};
[[nodiscard]] VoxelHull hullOf(const cell::VoxelSet& voxels, double edge);

/// All that is drawn of a cell and does not change.
struct CellScene {
  struct Robot {
    std::string name;
    std::optional<Eigen::Vector3d> base;  ///< [m]; nothing: it is a mechanism
  };
  struct Zone {
    std::string name;
    VoxelHull hull;
  };
  std::string hash;           ///< the digest of the artifact
  std::vector<Robot> robots;  ///< and then mechanisms, in the order of their colours
  std::vector<Zone> zones;
};
[[nodiscard]] CellScene sceneOf(const cell::Artifact& artifact);

/// Each zone as cubes in the colour of who holds it (grey: nobody; red: quarantined), the edges of its box,
/// its name and owner, and a line from each robot that waits for it. Zones of which the state says nothing
/// are grey. Markers that were there before are taken away.
[[nodiscard]] visualization_msgs::MarkerArray toZoneMarkers(const CellScene& scene,
                                                            const cobot_command::CellState& state,
                                                            const ros::Time& stamp);

/// Where each robot can be at all, translucent; nothing: only takes away what was there.
[[nodiscard]] visualization_msgs::MarkerArray toClaimMarkers(const std::vector<cell::RobotClaim>& claims,
                                                             double edge, const ros::Time& stamp);

/// The shortest way between the bodies of two robots or mechanisms.
struct ShortestWay {
  Eigen::Vector3d from;  ///< on the one [m]
  Eigen::Vector3d to;    ///< on the other [m]
  double distance = 0;   ///< [m]
  bool breached = false;
};
/// A line along it, with its length; nothing: takes away what was there.
[[nodiscard]] visualization_msgs::MarkerArray toDistanceMarkers(const std::optional<ShortestWay>& way,
                                                                const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
