#include "cell_watch/pictures/body_markers.h"

#include <algorithm>
#include <map>
#include <string>

#include "cell_watch/pictures/marker_parts.h"

#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// So much of white is in the colour of a link.
constexpr float kPale = 0.65F;
/// What is behind them can be seen.
constexpr float kObstacleAlpha = 0.3F;

Tint pale(const Tint& tint) {
  const auto mixed = [](float value) { return kPale + (1 - kPale) * value; };
  return {mixed(tint.r), mixed(tint.g), mixed(tint.b)};
}

bool isLink(const std::string& body) {
  return body.rfind("link_", 0) == 0;
}

arm::Pose alongCore(const cell::Capsule& capsule) {
  arm::Pose pose(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), capsule.to - capsule.from));
  pose.translation() = 0.5 * (capsule.from + capsule.to);
  return pose;
}

/// A capsule is a cylinder and two balls; balls of one size are one marker.
class Drawing {
 public:
  explicit Drawing(const ros::Time& stamp) : stamp_(stamp) {}

  void add(const cell::SeenBodies& seen, const Tint& tint, float alpha) {
    std::size_t id = 0;
    std::map<double, Marker> balls;
    for (std::size_t i = 0; i < seen.capsules.size(); ++i) {
      const cell::Capsule& capsule = seen.capsules[i];
      const Tint of_body = isLink(seen.body_names[i]) ? pale(tint) : tint;
      addCore(seen.name, id, capsule, toColour(of_body, alpha));
      Marker& same = balls[capsule.radius];
      for (const Eigen::Vector3d& end : {capsule.from, capsule.to}) {
        same.points.push_back(toPoint(end));
        same.colors.push_back(toColour(of_body, alpha));
      }
    }
    for (auto& [radius, same] : balls) {
      Marker marker = markerOf(seen.name, id++, Marker::SPHERE_LIST, tint, stamp_);
      marker.scale.x = marker.scale.y = marker.scale.z = 2 * radius;
      marker.points = std::move(same.points);
      marker.colors = std::move(same.colors);
      array_.markers.push_back(std::move(marker));
    }
    addName(seen, id);
  }

  [[nodiscard]] MarkerArray take() { return std::move(array_); }

 private:
  void addCore(const std::string& name, std::size_t& id, const cell::Capsule& capsule,
               const std_msgs::ColorRGBA& colour) {
    const double length = (capsule.to - capsule.from).norm();
    if (length <= 0) return;
    Marker core = markerOf(name, id++, Marker::CYLINDER, kGrey, stamp_);
    core.color = colour;
    core.pose = toPoseMessage(alongCore(capsule));
    core.scale.x = core.scale.y = 2 * capsule.radius;
    core.scale.z = length;
    array_.markers.push_back(std::move(core));
  }

  void addName(const cell::SeenBodies& seen, std::size_t id) {
    if (seen.capsules.empty()) return;
    Eigen::Vector3d lower = seen.capsules.front().from;
    Eigen::Vector3d upper = lower;
    for (const cell::Capsule& capsule : seen.capsules) {
      const Eigen::Vector3d radius = Eigen::Vector3d::Constant(capsule.radius);
      lower = lower.cwiseMin(capsule.from - radius).cwiseMin(capsule.to - radius);
      upper = upper.cwiseMax(capsule.from + radius).cwiseMax(capsule.to + radius);
    }
    Eigen::Vector3d place = 0.5 * (lower + upper);
    place.z() = upper.z() + kLetter;
    array_.markers.push_back(textAt(seen.name, id, place, seen.name, kDark, stamp_));
  }

  ros::Time stamp_;
  MarkerArray array_;
};

}  // namespace

MarkerArray toBodyMarkers(const std::vector<cell::SeenBodies>& bodies, std::size_t movers,
                          const ros::Time& stamp) {
  Drawing drawing(stamp);
  for (std::size_t thing = 0; thing < bodies.size(); ++thing) {
    const bool is_mover = thing < movers;
    drawing.add(bodies[thing], is_mover ? tintOfRobot(thing) : kGrey, is_mover ? 1.0F : kObstacleAlpha);
  }
  return drawing.take();
}

bool areSameMarkers(const MarkerArray& a, const MarkerArray& b) {
  return std::equal(a.markers.begin(), a.markers.end(), b.markers.begin(), b.markers.end(),
                    [](const Marker& one, const Marker& other) {
                      return one.ns == other.ns && one.id == other.id && one.type == other.type;
                    });
}

}  // namespace cobot_command::ros_adapter
