#include "cell_watch/pictures/cell_markers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "cell_watch/pictures/marker_parts.h"
#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;
using ZoneMessage = cobot_command::CellZone;

// [m]
constexpr double kEdgeWidth = 0.004;
constexpr double kWaitWidth = 0.012;
/// Of the edge of a voxel: neighbours do not flicker where they touch.
constexpr double kShownPart = 0.98;
constexpr float kZoneAlpha = 0.5F;
constexpr float kClaimAlpha = 0.12F;

Marker cubesOf(const char* name, std::size_t id, const VoxelHull& hull, const Tint& tint,
               const ros::Time& stamp) {
  Marker cubes = markerOf(name, id, Marker::CUBE_LIST, tint, stamp);
  cubes.scale.x = cubes.scale.y = cubes.scale.z = kShownPart * hull.edge;
  cubes.points = hull.centres;
  return cubes;
}

/// From each corner along each axis, if that leads to the other side.
void addEdges(Marker& lines, const cell::AlignedBox& box) {
  const auto corner = [&box](unsigned bits) {
    return Eigen::Vector3d((bits & 1U) != 0 ? box.upper.x() : box.lower.x(),
                           (bits & 2U) != 0 ? box.upper.y() : box.lower.y(),
                           (bits & 4U) != 0 ? box.upper.z() : box.lower.z());
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if ((from & axis) != 0) continue;
      lines.points.push_back(toPoint(corner(from)));
      lines.points.push_back(toPoint(corner(from | axis)));
    }
  }
}

template <class Things>
std::optional<std::size_t> indexOf(const Things& things, const std::string& name) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const auto& one) { return one.name == name; });
  if (found == things.end()) return std::nullopt;
  return static_cast<std::size_t>(found - things.begin());
}

class ZonePicture {
 public:
  ZonePicture(const CellScene& scene, const ros::Time& stamp)
      : scene_(scene), stamp_(stamp), array_(cleared(stamp)) {}

  void add(std::size_t index, const ZoneMessage& state) {
    const CellScene::Zone& zone = scene_.zones[index];
    const Tint tint = tintOf(state);
    Marker cubes = cubesOf("zones", index, zone.hull, tint, stamp_);
    cubes.color.a = kZoneAlpha;
    array_.markers.push_back(std::move(cubes));
    Marker edges = markerOf("edges", index, Marker::LINE_LIST, tint, stamp_);
    edges.scale.x = kEdgeWidth;
    addEdges(edges, zone.hull.box);
    array_.markers.push_back(std::move(edges));
    array_.markers.push_back(textAt("names", index, above(zone), wordsOf(zone, state), kDark, stamp_));
    for (const std::string& robot : state.waiting) addLine(robot, zone);
  }

  [[nodiscard]] MarkerArray take() { return std::move(array_); }

 private:
  [[nodiscard]] Tint tintOf(const ZoneMessage& state) const {
    if (state.state == ZoneMessage::QUARANTINED) return kRed;
    const auto owner = indexOf(scene_.robots, state.owner);
    return state.state == ZoneMessage::HELD && owner ? tintOfRobot(*owner) : kGrey;
  }

  [[nodiscard]] static std::string wordsOf(const CellScene::Zone& zone, const ZoneMessage& state) {
    std::string words = zone.name;
    if (!state.owner.empty()) words += ": " + state.owner;
    if (state.state == ZoneMessage::QUARANTINED) words += ", quarantined";
    return words;
  }

  [[nodiscard]] static Eigen::Vector3d above(const CellScene::Zone& zone) {
    Eigen::Vector3d place = middleOf(zone);
    place.z() = zone.hull.box.upper.z() + kLetter;
    return place;
  }

  [[nodiscard]] static Eigen::Vector3d middleOf(const CellScene::Zone& zone) {
    return 0.5 * (zone.hull.box.lower + zone.hull.box.upper);
  }

  void addLine(const std::string& name, const CellScene::Zone& zone) {
    const auto robot = indexOf(scene_.robots, name);
    if (!robot || !scene_.robots[*robot].base) return;
    Marker line = markerOf("waiting", lines_++, Marker::LINE_LIST, tintOfRobot(*robot), stamp_);
    line.scale.x = kWaitWidth;
    line.points = {toPoint(*scene_.robots[*robot].base), toPoint(middleOf(zone))};
    array_.markers.push_back(std::move(line));
  }

  const CellScene& scene_;
  ros::Time stamp_;
  MarkerArray array_;
  std::size_t lines_ = 0;
};

}  // namespace

VoxelHull hullOf(const cell::VoxelSet& voxels, double edge) {
  VoxelHull hull;
  hull.edge = edge;
  for (const cell::Voxel& voxel : voxels.sorted()) {
    bool is_seen = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::int32_t side : {-1, 1}) {
        cell::Voxel neighbour = voxel;
        neighbour[axis] += side;
        is_seen = is_seen || !voxels.contains(neighbour);
      }
    }
    if (!is_seen) continue;
    const cell::AlignedBox cube = cell::cubeOf(voxel, edge);
    hull.centres.push_back(toPoint(0.5 * (cube.lower + cube.upper)));
  }
  if (const auto bounds = voxels.bounds()) {
    hull.box = {cell::cubeOf(bounds->lower, edge).lower, cell::cubeOf(bounds->upper, edge).upper};
  }
  return hull;
}

CellScene sceneOf(const cell::Artifact& artifact) {
  CellScene scene;
  scene.hash = artifact.digest;
  for (std::size_t user = 0; user < artifact.program.robots.size(); ++user) {
    CellScene::Robot robot{artifact.program.robots[user].name, std::nullopt};
    if (user < artifact.robots.size()) robot.base = artifact.robots[user].base.translation();
    scene.robots.push_back(std::move(robot));
  }
  for (const cell::Zone& zone : artifact.zones) {
    scene.zones.push_back({zone.name, hullOf(zone.voxels, artifact.parameters.voxel)});
  }
  return scene;
}

MarkerArray toZoneMarkers(const CellScene& scene, const cobot_command::CellState& state,
                          const ros::Time& stamp) {
  ZonePicture picture(scene, stamp);
  for (std::size_t zone = 0; zone < scene.zones.size(); ++zone) {
    const auto known = indexOf(state.zones, scene.zones[zone].name);
    picture.add(zone, known ? state.zones[*known] : ZoneMessage());
  }
  return picture.take();
}

MarkerArray toClaimMarkers(const std::vector<cell::RobotClaim>& claims, double edge, const ros::Time& stamp) {
  MarkerArray array = cleared(stamp);
  for (std::size_t robot = 0; robot < claims.size(); ++robot) {
    Marker cubes = cubesOf("claims", robot, hullOf(claims[robot].all, edge), tintOfRobot(robot), stamp);
    cubes.color.a = kClaimAlpha;
    array.markers.push_back(std::move(cubes));
  }
  return array;
}

MarkerArray toDistanceMarkers(const std::optional<ShortestWay>& way, const ros::Time& stamp) {
  MarkerArray array = cleared(stamp);
  if (!way) return array;
  const Tint tint = way->breached ? kRed : kAmber;
  Marker line = markerOf("way", 0, Marker::LINE_LIST, tint, stamp);
  line.scale.x = 2 * kEdgeWidth;
  line.points = {toPoint(way->from), toPoint(way->to)};
  array.markers.push_back(std::move(line));
  Eigen::Vector3d place = 0.5 * (way->from + way->to);
  place.z() += kLetter;
  array.markers.push_back(textAt("distance", 0, place, fmt::format("{:.0f} mm", mToMm(way->distance)),
                                 way->breached ? kRed : kDark, stamp));
  return array;
}

}  // namespace cobot_command::ros_adapter
