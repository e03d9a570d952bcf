#include <algorithm>
#include <cmath>

#include "move_absolute.h"
#include <fmt/format.h>

#include "cobot_command/blocks/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr double kMaxSpeedPercent = 100;
constexpr double kMaxSpeedMmPerSecond = 4500;
constexpr double kMinAccelTime = 150;
constexpr double kMaxAccelTime = 9999;
constexpr double kMaxBlendingPercent = 100;
constexpr double kMaxBlendingMm = 2000;
constexpr double kMaxCoordinate = 100000;

/// False for NaN too.
bool isWithin(double value, double lowest, double highest) {
  return value >= lowest && value <= highest;
}

class Checks {
 public:
  explicit Checks(const MoveAbsoluteGoal& goal) : goal_(goal) {}

  std::vector<Failure> run() {
    checkSpeed();
    require(isWithin(goal_.accel_time, kMinAccelTime, kMaxAccelTime), motion_error::kAccelTimeRange,
            fmt::format("accel_time is {}", goal_.accel_time));
    require(goal_.command_id == 0 || (goal_.command_id >= 2 && goal_.command_id <= 9),
            motion_error::kCommandIdRange,
            fmt::format("command_id is {}; 0 lets the layer choose", goal_.command_id));
    checkRobotPose();
    checkFormat();
    checkTarget();
    checkOwnRanges();
    std::stable_sort(failures_.begin(), failures_.end(),
                     [](const Failure& a, const Failure& b) { return a.error_id < b.error_id; });
    return std::move(failures_);
  }

 private:
  void require(bool satisfied, int id, std::string found) {
    if (!satisfied) failures_.push_back({id, std::move(found), ""});
  }
  bool isLine() const { return goal_.movement_command == static_cast<int>(Movement::Line); }
  bool isPtp() const { return goal_.movement_command == static_cast<int>(Movement::Ptp); }
  bool hasFormat(AbsoluteFormat format) const { return goal_.data_format == static_cast<int>(format); }
  bool isSpeedAbsolute() const { return hasFormat(AbsoluteFormat::Cap) || hasFormat(AbsoluteFormat::Car); }
  bool isBlendingRadius() const { return hasFormat(AbsoluteFormat::Cpr) || hasFormat(AbsoluteFormat::Car); }

  /// 0 is refused too, though the table has it in the range: such a motion never ends.
  void checkSpeed() {
    const double highest = isSpeedAbsolute() ? kMaxSpeedMmPerSecond : kMaxSpeedPercent;
    require(goal_.speed > 0 && goal_.speed <= highest,
            isSpeedAbsolute() ? motion_error::kSpeedRangeAbsolute : motion_error::kSpeedRangePercent,
            fmt::format("speed is {} {}, it must be above 0 and at most {}", goal_.speed,
                        isSpeedAbsolute() ? "mm/s" : "%", highest));
  }

  void checkRobotPose() {
    if (!goal_.robot_pose_enable) return;
    const auto& [config1, config2, config3] = goal_.robot_pose;
    require(!isLine(), motion_error::kPoseWithLine, "");
    require(config1 == 0 || config1 == 1, motion_error::kPose1Range, fmt::format("config1 is {}", config1));
    require(config2 == 2 || config2 == 3, motion_error::kPose2Range, fmt::format("config2 is {}", config2));
    require(config3 == 4 || config3 == 5, motion_error::kPose3Range, fmt::format("config3 is {}", config3));
    require(!(isPtp() && hasFormat(AbsoluteFormat::Jpp)), own_error::kPoseWithJoints, "");
  }

  void checkFormat() {
    const std::string found =
        fmt::format("data_format is {} (JPP 0, CPP 1, CPR 2, CAP 3, CAR 4)", goal_.data_format);
    require(!isPtp() || hasFormat(AbsoluteFormat::Jpp) || hasFormat(AbsoluteFormat::Cpp),
            motion_error::kFormatForPtp, found);
    require(!isLine() || hasFormat(AbsoluteFormat::Cpp) || hasFormat(AbsoluteFormat::Cpr) ||
                hasFormat(AbsoluteFormat::Cap) || hasFormat(AbsoluteFormat::Car),
            motion_error::kFormatForLine, found);
    require(isLine() || isPtp(), own_error::kMovementUnknown,
            fmt::format("movement_command is {}", goal_.movement_command));
  }

  void checkTarget() {
    const auto bad = std::find_if(goal_.target.begin(), goal_.target.end(),
                                  [](double v) { return !isWithin(v, -kMaxCoordinate, kMaxCoordinate); });
    if (bad == goal_.target.end()) return;
    const bool finite =
        std::all_of(goal_.target.begin(), goal_.target.end(), [](double v) { return std::isfinite(v); });
    require(false, finite ? own_error::kCoordinateRange : own_error::kNotFinite,
            fmt::format("coordinate {} is {}", bad - goal_.target.begin() + 1, *bad));
  }

  void checkOwnRanges() {
    if (!goal_.blending_enable) return;
    const double highest = isBlendingRadius() ? kMaxBlendingMm : kMaxBlendingPercent;
    require(isWithin(goal_.blending_value, 0, highest), own_error::kBlendingRange,
            fmt::format("blending_value is {} {}", goal_.blending_value, isBlendingRadius() ? "mm" : "%"));
  }

  const MoveAbsoluteGoal& goal_;
  std::vector<Failure> failures_;
};

}  // namespace

std::vector<Failure> checkMoveAbsolute(const MoveAbsoluteGoal& goal) {
  return Checks(goal).run();
}

}  // namespace cobot_command::blocks
