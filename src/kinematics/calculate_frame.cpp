#include "cobot_command/kinematics/calculate_frame.h"

#include <string_view>

#include "question_checks.h"
#include "rounding.h"
#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::kinematics {
namespace {

using Eigen::Vector3d;

struct Points {
  Vector3d origin, on_x_axis, in_xy_plane;  ///< [m]
};

Result<Points, Refusal> pointsOf(const FrameQuestion& question) {
  const auto origin = poseInRange("the origin", question.origin);
  if (!origin) return refuse(origin.error());
  const auto on_x_axis = poseInRange("the point on the x axis", question.on_x_axis);
  if (!on_x_axis) return refuse(on_x_axis.error());
  const auto in_xy_plane = poseInRange("the point in the xy plane", question.in_xy_plane);
  if (!in_xy_plane) return refuse(in_xy_plane.error());
  return Points{origin->translation(), on_x_axis->translation(), in_xy_plane->translation()};
}

std::optional<Refusal> tooNear(const Points& points) {
  struct Pair {
    std::string_view names;
    double distance;  ///< [mm]
  };
  const Pair pairs[] = {
      {"the origin and the point on the x axis", mToMm((points.on_x_axis - points.origin).norm())},
      {"the origin and the point in the xy plane", mToMm((points.in_xy_plane - points.origin).norm())},
      {"the points on the x axis and in the xy plane",
       mToMm((points.in_xy_plane - points.on_x_axis).norm())}};
  for (const Pair& pair : pairs) {
    if (pair.distance >= kLeastDistance) continue;
    return Refusal{
        kinematics_error::kTooNear,
        fmt::format("{} are {:.3f} mm apart; allowed: {} mm and more. Touch points that are further "
                    "from each other",
                    pair.names, pair.distance, kLeastDistance)};
  }
  return std::nullopt;
}

Result<arm::Pose, Refusal> frameThrough(const Points& points) {
  const Vector3d x = (points.on_x_axis - points.origin).normalized();
  const Vector3d aside = points.in_xy_plane - points.origin;
  const Vector3d y = aside - aside.dot(x) * x;
  if (mToMm(y.norm()) < kLeastDistance) {
    return refuse(
        Refusal{kinematics_error::kOnOneLine,
                fmt::format("the point in the xy plane is {:.3f} mm from the x axis; allowed: {} mm and "
                            "more. Touch one that is further from the line of the others",
                            mToMm(y.norm()), kLeastDistance)});
  }
  arm::Pose frame = arm::Pose::Identity();
  frame.linear().col(0) = x;
  frame.linear().col(1) = y.normalized();
  frame.linear().col(2) = x.cross(y.normalized());
  frame.translation() = points.origin;
  return frame;
}

}  // namespace

Result<arm::ControllerPose, Refusal> calculateFrame(const tables::DataTables& tables,
                                                    const FrameQuestion& question) {
  const auto points = pointsOf(question);
  if (!points) return refuse(points.error());
  const auto touched_in = mountingOf(tables, {0, question.frame});
  if (!touched_in) return refuse(touched_in.error());
  const auto reference = mountingOf(tables, {0, question.reference});
  if (!reference) return refuse(reference.error());
  if (auto refusal = tooNear(*points)) return refuse(*std::move(refusal));
  const auto frame = frameThrough(*points);
  if (!frame) return refuse(frame.error());
  return shown(arm::toControllerPose(reference->frame.inverse() * touched_in->frame * *frame));
}

}  // namespace cobot_command::kinematics
