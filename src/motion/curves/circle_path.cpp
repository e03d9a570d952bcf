#include "curves/circle_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

using Eigen::Vector3d;

struct NamedPoint {
  const char* name;
  Vector3d position;
};

std::string coincidence(const NamedPoint& a, const NamedPoint& b) {
  const double distance = (a.position - b.position).norm();
  if (distance >= kMinCircleHeight) {
    return {};
  }
  return fmt::format(
      "{} and {} are {:.4f} mm apart, a circle needs three points at least {:.1f} mm apart: "
      "choose another point",
      a.name, b.name, mToMm(distance), mToMm(kMinCircleHeight));
}

std::string collinearity(double height) {
  return fmt::format(
      "start, arc point and end lie within {:.4f} mm of one line, at least {:.1f} mm are needed: "
      "choose another arc point, or a line",
      mToMm(height), mToMm(kMinCircleHeight));
}

std::string flatness(double radius) {
  return fmt::format(
      "start, arc point and end lie on a circle of radius {:.1f} m, at most {:.1f} m are allowed: "
      "choose another arc point, or a line",
      radius, kMaxCircleRadius);
}

/// The angle, 0..2 pi, by which `a` turns about the unit vector `normal` to point along `b`.
double angleAbout(const Vector3d& normal, const Vector3d& a, const Vector3d& b) {
  const double angle = std::atan2(normal.dot(a.cross(b)), a.dot(b));
  return angle < 0.0 ? angle + 2.0 * kPi : angle;
}

}  // namespace

Result<TcpPath, NoCircle> circlePath(const arm::Pose& start, const Circle& circle) {
  const NamedPoint points[] = {{"the start", start.translation()},
                               {"the arc point", circle.via.translation()},
                               {"the end", circle.end.translation()}};
  for (const auto& [one, other] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
    if (std::string message = coincidence(points[one], points[other]); !message.empty()) {
      return refuse(NoCircle{std::move(message)});
    }
  }
  const Vector3d to_via = points[1].position - points[0].position;
  const Vector3d to_end = points[2].position - points[0].position;
  const Vector3d area = to_via.cross(to_end);  // towards the side from which the travel is counterclockwise
  const double longest = std::max({to_via.norm(), to_end.norm(), (to_end - to_via).norm()});
  const double height = area.norm() / longest;
  if (height < kMinCircleHeight) {
    return refuse(NoCircle{collinearity(height)});
  }
  const Vector3d to_centre =
      (to_end.squaredNorm() * area.cross(to_via) + to_via.squaredNorm() * to_end.cross(area)) /
      (2.0 * area.squaredNorm());
  if (to_centre.norm() > kMaxCircleRadius) {
    return refuse(NoCircle{flatness(to_centre.norm())});
  }
  const Vector3d normal = area.normalized();
  const Vector3d centre = points[0].position + to_centre;
  if (circle.arc_angle) {
    return TcpPath::arc(start, centre, normal, *circle.arc_angle, start.linear());
  }
  return TcpPath::arc(start, centre, normal, angleAbout(normal, -to_centre, to_end - to_centre),
                      circle.end.linear());
}

}  // namespace cobot_command::motion
