#include "cell_watch/pictures/marker_parts.h"

#include <array>
#include <utility>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr std::array<Tint, 8> kOfRobots{{{0.06F, 0.45F, 0.95F},
                                         {0.98F, 0.62F, 0.05F},
                                         {0.1F, 0.7F, 0.25F},
                                         {0.6F, 0.25F, 0.8F},
                                         {0.0F, 0.72F, 0.72F},
                                         {0.95F, 0.45F, 0.7F},
                                         {0.6F, 0.5F, 0.1F},
                                         {0.45F, 0.3F, 0.2F}}};

}  // namespace

Tint tintOfRobot(std::size_t robot) {
  return kOfRobots[robot % kOfRobots.size()];
}

std_msgs::ColorRGBA toColour(const Tint& tint, float alpha) {
  std_msgs::ColorRGBA colour;
  colour.r = tint.r;
  colour.g = tint.g;
  colour.b = tint.b;
  colour.a = alpha;
  return colour;
}

geometry_msgs::Point toPoint(const Eigen::Vector3d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  point.z = place.z();
  return point;
}

Marker markerOf(const std::string& name, std::size_t id, int type, const Tint& tint, const ros::Time& stamp) {
  Marker marker;
  marker.header.stamp = stamp;
  marker.header.frame_id = kWorldFrame;
  marker.ns = name;
  marker.id = static_cast<int>(id);
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose = toPoseMessage(arm::Pose::Identity());
  marker.color = toColour(tint);
  return marker;
}

Marker textAt(const std::string& name, std::size_t id, const Eigen::Vector3d& place, std::string words,
              const Tint& tint, const ros::Time& stamp) {
  Marker text = markerOf(name, id, Marker::TEXT_VIEW_FACING, tint, stamp);
  text.scale.z = kLetter;
  text.pose.position = toPoint(place);
  text.text = forPeople(std::move(words));
  return text;
}

MarkerArray cleared(const ros::Time& stamp) {
  MarkerArray array;
  array.markers.push_back(markerOf("", 0, Marker::CUBE, kGrey, stamp));
  array.markers.back().action = Marker::DELETEALL;
  return array;
}

}  // namespace cobot_command::ros_adapter
