#include "preview/preview.h"

#include <cmath>
#include <cstdint>

#include "own_topics.h"
#include "preview/first_words.h"
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

}  // namespace

Preview::Preview(Robot& robot) : robot_(robot) {
  ros::NodeHandle node;
  joints_ = node.advertise<sensor_msgs::JointState>(ownTopic(kPreviewJoints), 1, true);
  markers_ = node.advertise<visualization_msgs::MarkerArray>(ownTopic(kPreviewMarkers), 1, true);
  trail_topic_ = node.advertise<Marker>(ownTopic(kDrivenPath), 1, true);
  robot.onTool([this] { followTool(); });
}

Preview::~Preview() {
  robot_.onTool(nullptr);
}

void Preview::leave() {
  has_left_ = true;
  robot_.onTool(nullptr);
  hide();
  Marker trail = markerOf("", kDrivenPath, Marker::LINE_STRIP);
  trail.action = Marker::DELETE;
  trail_topic_.publish(trail);
}

void Preview::show(const Plan& plan) {
  hide();
  if (plan.offending) {
    const cobot_command::Transformation& p = *plan.offending;
    setFault({p.x, p.y, p.z, p.rx, p.ry, p.rz}, plan.reason);
  } else if (!plan.path.points.empty()) {
    publishArm(plan.path.joint_names, plan.path.points.back().positions);
  }
}

void Preview::showArm(const std::array<double, 6>& joints) {
  std::vector<double> positions;
  positions.reserve(joints.size());
  for (const double joint : joints) positions.push_back(joint * kRadiansPerDegree);
  publishArm(robot_.jointNames(), positions);
  clearFault();
}

void Preview::showUnreachable(const std::array<double, 6>& target, const std::string& reason) {
  hide();
  setFault(target, reason);
}

void Preview::hide() {
  publishArm({}, {});
  clearFault();
}

void Preview::publishArm(const std::vector<std::string>& names, const std::vector<double>& positions) {
  sensor_msgs::JointState message;
  message.header.stamp = ros::Time::now();
  message.name = names;
  message.position = positions;
  joints_.publish(message);
}

void Preview::setFault(const std::array<double, 6>& place, const std::string& reason) {
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
  text.text = firstWords(reason);
  fault_ = {point, text};
  publishMarkers();
}

void Preview::clearFault() {
  fault_.clear();
  publishMarkers();
}

void Preview::publishMarkers() {
  visualization_msgs::MarkerArray message;
  message.markers.push_back(markerOf("", "", Marker::SPHERE));
  message.markers.back().action = Marker::DELETEALL;
  for (const auto& shown : {names(), fault_}) {
    message.markers.insert(message.markers.end(), shown.begin(), shown.end());
  }
  markers_.publish(message);
}

std::vector<Marker> Preview::names() const {
  const cobot_command::ActiveFrames& frames = robot_.activeFrames();
  const std::string base = robot_.activeBaseFrame();
  if (has_left_ || base.empty() || !frames.base_known || !frames.tcp_known) return {};
  const std::string prefix = base.substr(0, base.rfind("active_base"));
  std::vector<Marker> markers;
  for (const auto& [frame, name] : {std::pair("active_base", "base"), std::pair("active_tool", "tool")}) {
    Marker& marker = markers.emplace_back(markerOf(prefix + frame, name, Marker::TEXT_VIEW_FACING));
    marker.text = name;
    marker.pose.position.z = -kAbove;
    marker.scale.z = kLetters;
    marker.color = colorOf(0.1F, 0.1F, 0.12F);
    marker.frame_locked = 1U;
  }
  return markers;
}

void Preview::followTool() {
  const auto status = robot_.robotStatus();
  const auto place = robot_.toolInBase();
  const bool moves = status && status->in_motion == cobot_command::RobotStatus::TRUE;
  if (place && trail_.add(place->translation(), moves, ros::WallTime::now().toSec())) has_grown_ = true;
}

void Preview::look() {
  if (const std::string base = robot_.activeBaseFrame(); base != named_) {
    named_ = base;
    publishMarkers();
  }
  if (has_grown_) publishTrail();
}

void Preview::publishTrail() {
  has_grown_ = false;
  Marker line = markerOf(robot_.baseFrame(), kDrivenPath, Marker::LINE_STRIP);
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
