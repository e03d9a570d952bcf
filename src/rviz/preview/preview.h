// What RViz shows of a robot beside the robot itself: where the arm would stand, where a target is, what
// cannot be and why, and the way that the tool has gone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "clients/plan.h"
#include "clients/robot.h"
#include "preview/trail.h"
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <visualization_msgs/Marker.h>

namespace cobot_command::rviz_plugin {

class Preview {
 public:
  explicit Preview(Robot& robot);
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;
  ~Preview();

  /// The end of the plan as a ghost; or its offending point in red, with the reason.
  void show(const Plan& plan);
  /// The arm with these joints [deg].
  void showArm(const std::array<double, 6>& joints);
  /// A TCP in the active base [mm, deg] that no arm reaches.
  void showUnreachable(const std::array<double, 6>& target, const std::string& reason);
  void hide();
  /// Nothing of this robot is left in the scene, and nothing more comes: before that of another one is shown.
  void leave();
  /// Ten times a second: tells the path that was driven, and the names of frames.
  void look();

 private:
  void followTool();
  void publishArm(const std::vector<std::string>& names, const std::vector<double>& positions);
  void setFault(const std::array<double, 6>& place, const std::string& reason);
  void clearFault();
  void publishMarkers();
  void publishTrail();
  /// Beside base and tool: RViz writes those of tf in white.
  [[nodiscard]] std::vector<visualization_msgs::Marker> names() const;

  Robot& robot_;
  ros::Publisher joints_;
  ros::Publisher markers_;
  ros::Publisher trail_topic_;
  Trail trail_;
  std::vector<visualization_msgs::Marker> fault_;  ///< a point, and why it cannot be
  std::string named_;                              ///< the frames whose names are shown
  bool has_grown_ = false;                         ///< the trail, since it was told
  bool has_left_ = false;
};

}  // namespace cobot_command::rviz_plugin
