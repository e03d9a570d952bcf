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

namespace cobot_command::rviz_plugin {

class Preview {
 public:
  explicit Preview(Robot& robot);
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;
  /// Nothing of this robot is left in the scene.
  ~Preview();

  /// The end of the plan as a ghost; or its offending point in red, with the reason.
  void show(const Plan& plan);
  /// The arm with these joints [deg].
  void showArm(const std::array<double, 6>& joints);
  /// A TCP in the active base [mm, deg] that no arm reaches.
  void showUnreachable(const std::array<double, 6>& target, const std::string& reason);
  void hide();
  /// Ten times a second: tells the path that was driven.
  void look();

 private:
  void followTool();
  void publishArm(const std::vector<std::string>& names, const std::vector<double>& positions);
  void publishFault(const std::array<double, 6>& place, const std::string& reason);
  void hideFault();

  Robot& robot_;
  ros::Publisher joints_;
  ros::Publisher markers_;
  ros::Publisher trail_topic_;
  Trail trail_;
  bool has_grown_ = false;  ///< the trail, since it was told
};

}  // namespace cobot_command::rviz_plugin
