#include "preview/preview.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <sensor_msgs/JointState.h>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::rviz_plugin {
namespace {

using visualization_msgs::Marker;

constexpr double kRadiansPerDegree = M_PI / 180;
constexpr double kSphere = 0.05;   // [m]
constexpr double kLetters = 0.04;  // [m]
constexpr double kAbove = 0.07;    // [m] the text above its point
constexpr double kLine = 0.004;    // [m]
constexpr std::size_t kLongestReason = 80;

std_msgs::ColorRGBA colorOf(float red, float green, float blue) {
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = 1;
  return color;
}

Marker markerOf(const std::string& frame, const char* name, std::int32_t type) {
  Marker marker;
  marker.header.frame_id = frame;
  marker.ns = name;
  marker.type = type;
  marker.pose.orientation.w = 1;
  return marker;
}

/// The first sentence, or as much as can be read in a scene.
std::string shortened(const std::string& reason) {
  const std::size_t end = std::min(reason.find(": "), reason.find(". "));
  std::string text = reason.substr(0, end);
  if (text.size() > kLongestReason) text = text.substr(0, kLongestReason) + " ...";
  return text;
}

}  // namespace

Preview::Preview(Robot& robot) : robot_(robot) {
  ros::NodeHandle node = robot.node();
  joints_ = node.advertise<sensor_msgs::JointState>("preview_joints", 1, true);
  markers_ = node.advertise<visualization_msgs::MarkerArray>("preview", 1, true);
  trail_topic_ = node.advertise<Marker>("driven_path", 1, true);
  robot.onTool([this] { followTool(); });
}

Preview::~Preview() {
  robot_.onTool(nullptr);
  hide();
}

void Preview::show(const Plan& plan) {
  hide();
  if (plan.offending) {
    const cobot_command::Transformation& p = *plan.offending;
    publishFault({p.x, p.y, p.z, p.rx, p.ry, p.rz}, plan.reason);
  } else if (!plan.path.points.empty()) {
    publishArm(plan.path.joint_names, plan.path.points.back().positions);
  }
}

void Preview::showArm(const std::array<double, 6>& joints) {
  std::vector<double> positions;
  positions.reserve(joints.size());
  for (const double joint : joints) positions.push_back(joint * kRadiansPerDegree);
  publishArm(robot_.jointNames(), positions);
  hideFault();
}

void Preview::showUnreachable(const std::array<double, 6>& target, const std::string& reason) {
  hide();
  publishFault(target, reason);
}

void Preview::hide() {
  publishArm({}, {});
  hideFault();
}

void Preview::publishArm(const std::vector<std::string>& names, const std::vector<double>& positions) {
  sensor_msgs::JointState message;
  message.header.stamp = ros::Time::now();
  message.name = names;
  message.position = positions;
  joints_.publish(message);
}

void Preview::publishFault(const std::array<double, 6>& place, const std::string& reason) {
  const std::string frame = robot_.activeBaseFrame();
  if (frame.empty()) return;
  Marker point = markerOf(frame, "offending", Marker::SPHERE);
  point.pose = ros_adapter::toPoseMessage(arm::toPose(place));
  point.scale.x = point.scale.y = point.scale.z = kSphere;
  point.color = colorOf(0.85F, 0.1F, 0.1F);
  Marker text = markerOf(frame, "reason", Marker::TEXT_VIEW_FACING);
  text.pose.position = point.pose.position;
  text.pose.position.z += kAbove;
  text.scale.z = kLetters;
  text.color = point.color;
  text.text = shortened(reason);
  visualization_msgs::MarkerArray markers;
  markers.markers = {point, text};
  markers_.publish(markers);
}

void Preview::hideFault() {
  visualization_msgs::MarkerArray markers;
  markers.markers.push_back(markerOf("", "", Marker::SPHERE));
  markers.markers.back().action = Marker::DELETEALL;
  markers_.publish(markers);
}

void Preview::followTool() {
  const auto status = robot_.robotStatus();
  const auto place = robot_.toolInBase();
  const bool moves = status && status->in_motion == cobot_command::RobotStatus::TRUE;
  if (place && trail_.add(place->translation(), moves, ros::WallTime::now().toSec())) has_grown_ = true;
}

void Preview::look() {
  if (!has_grown_) return;
  has_grown_ = false;
  Marker line = markerOf(robot_.baseFrame(), "driven_path", Marker::LINE_STRIP);
  line.scale.x = kLine;
  line.color = colorOf(0.9F, 0.5F, 0.1F);
  for (const Eigen::Vector3d& at : trail_.places()) {
    geometry_msgs::Point& point = line.points.emplace_back();
    point.x = at.x();
    point.y = at.y();
    point.z = at.z();
  }
  if (line.points.size() > 1) trail_topic_.publish(line);
}

}  // namespace cobot_command::rviz_plugin
