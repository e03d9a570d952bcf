#include "paths/path_markers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// [m]
constexpr double kLineWidth = 0.004;
constexpr double kPoint = 0.014;
constexpr double kActivePoint = 0.028;
constexpr double kRefusedPoint = 0.03;
constexpr double kLetter = 0.03;
constexpr double kFoot = 0.3;  // around the first axis
/// Characters of a line of text: more do not fit beside the arm.
constexpr std::size_t kMostLetters = 44;

struct Colour {
  float r, g, b, a;
};
constexpr Colour kBlue{0.06F, 0.45F, 0.95F, 1.0F};
constexpr Colour kDarkBlue{0.03F, 0.2F, 0.5F, 1.0F};
constexpr Colour kOrange{0.95F, 0.55F, 0.05F, 1.0F};
constexpr Colour kOrangeGlass{0.95F, 0.55F, 0.05F, 0.3F};
constexpr Colour kGreen{0.1F, 0.75F, 0.2F, 1.0F};
constexpr Colour kRed{0.9F, 0.05F, 0.05F, 1.0F};

Marker markerOf(const MarkerSite& site, const char* name, int type, const Colour& colour) {
  Marker marker;
  marker.header.stamp = site.stamp;
  marker.header.frame_id = site.base_frame;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose = toPoseMessage(arm::Pose::Identity());
  marker.color.r = colour.r;
  marker.color.g = colour.g;
  marker.color.b = colour.b;
  marker.color.a = colour.a;
  return marker;
}

void setSize(Marker& marker, double size) {
  marker.scale.x = marker.scale.y = marker.scale.z = size;
}

geometry_msgs::Point toPoint(const Eigen::Vector3d& place) {
  geometry_msgs::Point point;
  point.x = place.x();
  point.y = place.y();
  point.z = place.z();
  return point;
}

Marker lineOf(const MarkerSite& site, int type) {
  Marker line = markerOf(site, "planned_path", type, kBlue);
  line.scale.x = kLineWidth;
  return line;
}

/// RViz shows a text in one line, however long.
std::string inLines(const std::string& text, int& lines) {
  std::string broken;
  std::size_t width = 0;
  lines = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t word = end - at;
    if (width > 0 && width + 1 + word > kMostLetters) {
      broken += '\n';
      width = 0;
      ++lines;
    } else if (width > 0) {
      broken += ' ';
      ++width;
    }
    broken += text.substr(at, word);
    width += word;
    at = end + 1;
  }
  return broken;
}

/// Above its point; in the foot of the arm, where a posture with a joint outside its limits often ends,
/// nobody could read it: there it stands below the floor.
Eigen::Vector3d besidePoint(Eigen::Vector3d place, int lines) {
  const double away = kRefusedPoint + 0.6 * kLetter * lines;
  const bool in_foot = place.head<2>().norm() < kFoot;
  place.z() = in_foot ? std::min(place.z(), 0.0) - 2 * kRefusedPoint - away : place.z() + away;
  return place;
}

class Points {
 public:
  explicit Points(const MarkerSite& site)
      : site_(site),
        rests_(markerOf(site, "points", Marker::SPHERE_LIST, kDarkBlue)),
        corners_(markerOf(site, "corners", Marker::SPHERE_LIST, kOrange)) {
    setSize(rests_, kPoint);
    setSize(corners_, kPoint);
    Marker clear = markerOf(site, "", Marker::SPHERE, kBlue);
    clear.action = Marker::DELETEALL;
    array_.markers.push_back(std::move(clear));
  }

  void add(const path::PathPreview& path) {
    for (const auto& point : path.points) {
      const bool is_corner = point.blend > 0;
      (is_corner ? corners_ : rests_).points.push_back(toPoint(point.place));
      if (is_corner) addSphere("blends", point.place, 2 * point.blend, kOrangeGlass);
    }
    if (path.refusal) addRefusal(path);
  }

  [[nodiscard]] MarkerArray take() {
    for (Marker* const list : {&rests_, &corners_}) {
      if (!list->points.empty()) array_.markers.push_back(std::move(*list));
    }
    return std::move(array_);
  }

 private:
  void addSphere(const char* name, const Eigen::Vector3d& place, double size, const Colour& colour) {
    Marker sphere = markerOf(site_, name, Marker::SPHERE, colour);
    sphere.id = next_++;
    sphere.pose.position = toPoint(place);
    setSize(sphere, size);
    array_.markers.push_back(std::move(sphere));
  }

  /// Beside its target; where nobody knows that, beside the point in front of it.
  void addRefusal(const path::PathPreview& path) {
    const path::PathRefusal& refusal = *path.refusal;
    Eigen::Vector3d place;
    if (refusal.where) {
      place = refusal.where->translation();
      addSphere("refused", place, kRefusedPoint, kRed);
    } else if (!path.points.empty()) {
      place = path.points.back().place;
    } else {
      return;
    }
    int lines = 0;
    Marker text = markerOf(site_, "error", Marker::TEXT_VIEW_FACING, kRed);
    text.id = next_++;
    text.text = inLines(forPeople(fmt::format("point {}: {}", refusal.index, refusal.found)), lines);
    text.scale.z = kLetter;
    text.pose.position = toPoint(besidePoint(place, lines));
    array_.markers.push_back(std::move(text));
  }

  const MarkerSite& site_;
  Marker rests_;
  Marker corners_;
  MarkerArray array_;
  int next_ = 0;
};

}  // namespace

Marker toLine(const std::vector<arm::Pose>& tool_path, const MarkerSite& site) {
  Marker line = lineOf(site, Marker::LINE_STRIP);
  if (tool_path.size() < 2) line.action = Marker::DELETE;
  line.points.reserve(tool_path.size());
  for (const arm::Pose& pose : tool_path) line.points.push_back(toPoint(pose.translation()));
  return line;
}

Marker toLine(const std::vector<PathBoard::Shown>& paths, const MarkerSite& site) {
  Marker line = lineOf(site, Marker::LINE_LIST);
  for (const auto& path : paths) {
    for (const auto& part : path.preview.lines) {
      for (std::size_t i = 1; i < part.size(); ++i) {
        line.points.push_back(toPoint(part[i - 1]));
        line.points.push_back(toPoint(part[i]));
      }
    }
  }
  if (line.points.empty()) line.action = Marker::DELETE;
  return line;
}

MarkerArray toPoints(const std::vector<PathBoard::Shown>& paths, const MarkerSite& site) {
  Points points(site);
  for (const auto& path : paths) points.add(path.preview);
  return points.take();
}

Marker toActivePoint(const std::optional<Eigen::Vector3d>& place, const MarkerSite& site) {
  Marker point = markerOf(site, "active_point", Marker::SPHERE, kGreen);
  setSize(point, kActivePoint);
  if (place) {
    point.pose.position = toPoint(*place);
  } else {
    point.action = Marker::DELETE;
  }
  return point;
}

}  // namespace cobot_command::ros_adapter
