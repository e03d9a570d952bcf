// The bodies of a robot with each set of parts that it carries somewhere in its programs.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

class BodiesOfRobot {
 public:
  [[nodiscard]] static Result<BodiesOfRobot, std::string> of(const Cell& cell, const Robot& robot);
  /// Made once for each set.
  [[nodiscard]] std::shared_ptr<const RobotBodies> carrying(const std::set<std::string>& parts);

 private:
  BodiesOfRobot(RobotBodies bare, PartTree parts) : bare_(std::move(bare)), parts_(std::move(parts)) {}

  RobotBodies bare_;
  PartTree parts_;
  std::map<std::set<std::string>, std::shared_ptr<const RobotBodies>> known_;
};

}  // namespace cobot_command::cell
