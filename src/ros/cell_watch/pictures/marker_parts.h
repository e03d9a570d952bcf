// What the markers of a cell are made of: colours, and the kinds that several pictures have, in the frame
// `world`.
#pragma once

#include <cstddef>
#include <string>

#include <Eigen/Core>
#include <geometry_msgs/Point.h>
#include <ros/time.h>
#include <std_msgs/ColorRGBA.h>
#include <visualization_msgs/MarkerArray.h>

namespace cobot_command::ros_adapter {

inline constexpr const char* kWorldFrame = "world";
/// Height of letters [m].
inline constexpr double kLetter = 0.07;

struct Tint {
  float r, g, b;
};
inline constexpr Tint kGrey{0.55F, 0.58F, 0.62F};
inline constexpr Tint kRed{0.9F, 0.05F, 0.05F};
inline constexpr Tint kDark{0.12F, 0.13F, 0.15F};
inline constexpr Tint kAmber{0.95F, 0.6F, 0.05F};
/// Of the robots of a cell, and then its mechanisms, in their order; none is grey or red.
[[nodiscard]] Tint tintOfRobot(std::size_t robot);

[[nodiscard]] std_msgs::ColorRGBA toColour(const Tint& tint, float alpha = 1.0F);
[[nodiscard]] geometry_msgs::Point toPoint(const Eigen::Vector3d& place);

/// Where nothing is turned or moved.
[[nodiscard]] visualization_msgs::Marker markerOf(const std::string& name, std::size_t id, int type,
                                                  const Tint& tint, const ros::Time& stamp);
[[nodiscard]] visualization_msgs::Marker textAt(const std::string& name, std::size_t id,
                                                const Eigen::Vector3d& place, std::string words,
                                                const Tint& tint, const ros::Time& stamp);
/// Takes away what was there before.
[[nodiscard]] visualization_msgs::MarkerArray cleared(const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
