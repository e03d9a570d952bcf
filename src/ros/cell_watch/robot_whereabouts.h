// In which namespace the command node of each robot of a cell is.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

/// The namespace that the file says, until nothing is heard there: then that of the node that reports for the
/// robot. A robot that is heard keeps its node, so that nobody takes it away by a report.
class RobotWhereabouts {
 public:
  /// Refused where the namespace of a robot is no name of ROS, or that of two.
  [[nodiscard]] static Result<RobotWhereabouts, std::string> of(const cell::Cell& cell);

  struct Robot {
    std::string name;
    std::string space;  ///< "/RA"
    std::optional<Instant> heard;
  };
  [[nodiscard]] const std::vector<Robot>& robots() const { return robots_; }

  /// Its joints came.
  void heard(std::size_t robot, Instant now) { robots_[robot].heard = now; }
  /// That node, "/RA/command_node", reports for the robot of that name. The index of the robot, where it is
  /// to be listened to in another namespace from now on; never in that of another robot.
  std::optional<std::size_t> reported(const std::string& robot, const std::string& node, Instant now);

 private:
  explicit RobotWhereabouts(std::vector<Robot> robots) : robots_(std::move(robots)) {}

  std::vector<Robot> robots_;
};

}  // namespace cobot_command::ros_adapter
