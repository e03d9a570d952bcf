#include "cobot_command/path/path_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

/// The times to top speed that a script may ask for [ms] (thesis table 5.3.2.3).
constexpr int kShortestRamp = 150;
constexpr int kLongestRamp = 9999;
/// A radius that no arm of the family has room for [mm].
constexpr double kMostRadius = 9999;
constexpr double kWholeNumber = 1e-9;

const char* nameOf(int profile_type) {
  constexpr std::array<const char*, 4> kNames{"S_CURVE", "POLY5", "MOD_SINE", "SINE2"};
  return kNames.at(static_cast<std::size_t>(profile_type));
}

/// What may be left out of the way of a point, as a share of it.
double toleranceOf(const PlannedPoint& point) {
  if (is(point.point.interpolation, Interpolation::Ptp)) return point.point.command_tolerance / 100.0;
  return mmToM(point.point.command_tolerance) / std::max(point.motion->tcpWay(), 1e-9);
}

bool isSame(const arm::Pose& a, const arm::Pose& b) {
  constexpr double kSame = 1e-6;  // [m and rotation entry]
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff() < kSame;
}

/// One point, by what it says and what was planned of it.
class PointWriter {
 public:
  PointWriter(const PlannedPoint& point, const PlannedPoint* next, const PathScene& scene)
      : point_(point), next_(next), scene_(scene) {}

  [[nodiscard]] PointScript write() {
    tellShape();
    if (is(point_.point.interpolation, Interpolation::Ptp)) {
      script_.lines.push_back(ptp());
    } else if (is(point_.point.interpolation, Interpolation::Circular)) {
      script_.lines.push_back(circle());
    } else {
      script_.lines.push_back(line());
    }
    return std::move(script_);
  }

 private:
  void tell(const std::string& what) {
    script_.approximations.push_back(fmt::format("point {}: {}", point_.index, what));
  }

  [[nodiscard]] const Dynamics& dynamics() const { return point_.dynamics; }
  [[nodiscard]] double acceleration() const {
    return std::min(dynamics().acceleration, dynamics().deceleration) * point_.feedrate * point_.feedrate;
  }
  /// As much slower as the longest ramp asks for.
  [[nodiscard]] double speed() const {
    return std::min(dynamics().speed * point_.feedrate, 1e-3 * kLongestRamp * acceleration());
  }

  /// What no motion of a script can say.
  void tellShape() {
    const double jerk = std::max(dynamics().acceleration_jerk, dynamics().deceleration_jerk);
    if (jerk > 0) {
      tell(fmt::format("profile {} with a jerk of {} %", nameOf(point_.point.profile_type), jerk));
    }
    if (dynamics().acceleration != dynamics().deceleration) {
      tell(fmt::format("deceleration {} with acceleration {}", dynamics().deceleration,
                       dynamics().acceleration));
    }
  }

  /// [ms]
  [[nodiscard]] int ramp() {
    if (speed() < dynamics().speed * point_.feedrate) {
      tell(fmt::format("a speed of {:.6g}, because a script allows at most {} ms to top speed", speed(),
                       kLongestRamp));
    }
    const double exact = 1e3 * speed() / acceleration();
    const double whole = std::ceil(exact * (1.0 - kWholeNumber));
    if (whole < kShortestRamp) {
      tell(fmt::format("{:.6g} ms to top speed, a script allows at least {}", exact, kShortestRamp));
    } else if (std::abs(exact - whole) > kWholeNumber * exact) {
      tell(fmt::format("{:.6g} ms to top speed, a script allows only whole numbers", exact));
    }
    return static_cast<int>(std::clamp(whole, 1.0 * kShortestRamp, 1.0 * kLongestRamp));
  }

  /// Rounded down to a whole number of 1..most.
  [[nodiscard]] int whole(double exact, double most, const char* unit) {
    const double below = std::clamp(std::floor(exact * (1.0 + kWholeNumber)), 1.0, most);
    if (std::abs(exact - below) > kWholeNumber * std::max(1.0, exact)) {
      tell(fmt::format("{:.6g} {}, a script allows whole numbers up to {}", exact, unit, most));
    }
    return static_cast<int>(below);
  }

  [[nodiscard]] script::MotionOptions options(int speed, int blending) {
    return {speed, ramp(), blending, false};
  }

  /// It is sent with a blend: the plan has one, or nothing is behind it yet.
  [[nodiscard]] bool blends() const {
    return point_.overlap > Duration::zero() || (next_ == nullptr && point_.losesBlend());
  }
  /// How long before its end it is left.
  [[nodiscard]] Duration leftBefore() const {
    if (next_ != nullptr) return point_.overlap;
    const motion::Trajectory& motion = *point_.motion;
    const double share = std::min(1.0, toleranceOf(point_));
    Duration left{};
    const Duration step = std::chrono::milliseconds(1);
    while (left < motion.timeDown() && motion.progress(motion.duration() - left - step) >= 1.0 - share) {
      left += step;
    }
    return left;
  }

  /// The share of the ramps for which the plan lets both motions overlap [%].
  [[nodiscard]] int blendShare() {
    if (!blends()) return 0;
    Duration most = std::min(point_.motion->timeDown(), point_.motion->duration() / 2);
    if (next_ != nullptr) most = std::min({most, next_->motion->timeUp(), next_->motion->duration() / 2});
    const double share = 100.0 * toSeconds(leftBefore()) / std::max(toSeconds(most), 1e-9);
    const int percent = static_cast<int>(std::clamp(std::floor(share), 1.0, 100.0));
    tell(fmt::format("a tolerance of {} {}, sent as {} % of the ramps", point_.point.command_tolerance,
                     is(point_.point.interpolation, Interpolation::Ptp) ? "% of the path" : "mm", percent));
    return percent;
  }

  /// [mm]; below one it is a stop.
  [[nodiscard]] int radius() {
    if (!blends()) return 0;
    const double tolerance = std::min(point_.point.command_tolerance, mToMm(point_.motion->tcpWay()));
    if (tolerance >= 1.0) return whole(tolerance, kMostRadius, "mm of tolerance");
    tell(fmt::format("a tolerance of {:.6g} mm, below 1 mm it is a stop", tolerance));
    return 0;
  }

  /// Of the rated speed, such that no joint is faster than asked: the arm may come from anywhere [%].
  [[nodiscard]] int percentFromAnywhere() const {
    const auto& limits = scene_.arm.limits();
    const auto fastest = std::max_element(
        limits.begin(), limits.end(),
        [](const auto& one, const auto& other) { return one.max_velocity < other.max_velocity; });
    return static_cast<int>(std::clamp(100.0 * degToRad(speed()) / fastest->max_velocity, 1.0, 100.0));
  }

  [[nodiscard]] script::ScriptCommand ptp() {
    const arm::JointVector from = point_.motion->at(Duration::zero()).position;
    const arm::JointVector way = point_.motion->end().position - from;
    double share = 0.0;
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      const double joint = std::abs(way[static_cast<Eigen::Index>(i)]);
      share = std::max(share, joint / scene_.arm.limits()[i].max_velocity);
    }
    const double longest = way.cwiseAbs().maxCoeff();
    const double percent = 100.0 * degToRad(speed()) * share / longest;
    script::Ptp ptp;
    ptp.options = options(longest > 0.0 ? whole(percent, 100, "% of the rated speed") : percentFromAnywhere(),
                          blendShare());
    ptp.format.target = script::DataFormat::Target::Joint;
    if (is(point_.point.target_type, TargetType::Cartesian)) {
      ptp.format.target = script::DataFormat::Target::Cartesian;
      ptp.target = endPose();
      ptp.pose_bits = arm::poseBitsOf(scene_.arm, point_.motion->end().position).numbers();
    } else {
      ptp.target = arm::toControllerJoints(point_.motion->end().position);
    }
    return ptp;
  }

  [[nodiscard]] script::ScriptCommand line() {
    script::Line line;
    line.format.speed = script::DataFormat::Speed::Absolute;
    line.format.blending = script::DataFormat::Blending::Radius;
    line.target = endPose();
    tellTurn();
    line.options = options(whole(speed(), mToMm(motion::kMaxTcpSpeed), "mm/s"), radius());
    if (line.options.blending == 0) line.format.blending = script::DataFormat::Blending::Percent;
    return line;
  }

  [[nodiscard]] script::ScriptCommand circle() {
    const auto& arc = std::get<motion::ArcMove>(point_.command);
    script::Circle circle;
    circle.format.speed = script::DataFormat::Speed::Absolute;
    circle.via = arm::toControllerPose(arc.via);
    circle.end = endPose();
    tellTurn();
    circle.options = options(whole(speed(), mToMm(motion::kMaxTcpSpeed), "mm/s"), blendShare());
    return circle;
  }

  void tellTurn() {
    const arm::Pose from = poseAt(Duration::zero());
    const arm::Pose to = poseAt(point_.motion->duration());
    constexpr double kNoTurn = 1e-6;
    if (Eigen::AngleAxisd(from.linear().transpose() * to.linear()).angle() > kNoTurn) {
      tell("speed and acceleration of the turn");
    }
  }

  [[nodiscard]] arm::Pose poseAt(Duration time) const {
    return arm::forwardKinematics(scene_.arm, point_.motion->at(time).position) * point_.moved_frame;
  }
  [[nodiscard]] script::SixNumbers endPose() const {
    return arm::toControllerPose(poseAt(point_.motion->duration()));
  }

  const PlannedPoint& point_;
  const PlannedPoint* next_;
  const PathScene& scene_;
  PointScript script_;
};

bool sendsPose(const PlannedPoint& point) {
  return is(point.point.target_type, TargetType::Cartesian) ||
         !is(point.point.interpolation, Interpolation::Ptp);
}

/// What has to be set in front of a pose; `active` is what is set then.
std::vector<script::ScriptCommand> framesFor(const PlannedPoint& point, ScriptFrames& active) {
  std::vector<script::ScriptCommand> lines;
  if (!sendsPose(point)) return lines;
  if (!active.base || !isSame(*active.base, arm::Pose::Identity())) {
    lines.emplace_back(script::ChangeBase{script::kRobotBase});
    active.base = arm::Pose::Identity();
  }
  if (!active.tcp || !isSame(*active.tcp, point.moved_frame)) {
    lines.emplace_back(script::ChangeTcp{arm::toControllerPose(point.moved_frame), {}, {}});
    active.tcp = point.moved_frame;
  }
  return lines;
}

}  // namespace

Result<std::vector<PointScript>, PathRefusal> scriptOf(const PathPlan& plan, std::size_t first,
                                                       const PathScene& scene, const ScriptFrames& active) {
  ScriptFrames frames = active;
  std::vector<PointScript> scripts;
  for (std::size_t i = first; i < plan.points().size(); ++i) {
    const PlannedPoint& point = plan.points()[i];
    if (is(point.point.interpolation, Interpolation::Wrist)) {
      return refuse(PathRefusal{
          path_error::kNotInAScript, point.index, -1,
          "CP_WRIST: no script motion moves straight with the wrist alone; send the path as PVT"});
    }
    const PlannedPoint* next = i + 1 < plan.points().size() ? &plan.points()[i + 1] : nullptr;
    PointScript script = PointWriter(point, next, scene).write();
    const auto changes = framesFor(point, frames);
    script.lines.insert(script.lines.begin(), changes.begin(), changes.end());
    scripts.push_back(std::move(script));
  }
  return scripts;
}

}  // namespace cobot_command::path
