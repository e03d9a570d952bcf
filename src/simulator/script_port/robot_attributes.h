// The attributes of objects in scripts: IO, Robot, Point, Base, TCP (TM 2.4).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/io_board.h"
#include "robot/project_data.h"

#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/tm_script/environment.h"

namespace cobot_command::simulator {

class RobotAttributes {
 public:
  RobotAttributes(const arm::ArmModel& model, IoBoard& io, ProjectData& project,
                  std::function<RobotState()> state)
      : model_(model), io_(io), project_(project), state_(std::move(state)) {}

  /// The error says what there is instead.
  [[nodiscard]] Result<tm_script::AttributeShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<tm_script::Scalar>>& keys,
      const std::string& attribute) const;
  [[nodiscard]] Result<tm_script::Value, std::string> read(const tm_script::AttributeName& attribute) const;
  /// Changes a base, a TCP, a point or the light. Precondition: a writable attribute of these, and a value of
  /// its type.
  void write(const tm_script::AttributeName& attribute, std::optional<std::size_t> index,
             const tm_script::Value& value);

 private:
  [[nodiscard]] tm_script::Value ofIo(const std::string& module, const std::string& attribute) const;
  [[nodiscard]] tm_script::Value ofRobot(const std::string& attribute) const;
  [[nodiscard]] tm_script::Value ofProject(const std::string& object, const std::string& name,
                                           const std::string& attribute) const;

  const arm::ArmModel& model_;
  IoBoard& io_;
  ProjectData& project_;
  std::function<RobotState()> state_;
};

/// IO, Robot, Base and the like.
[[nodiscard]] bool isObject(const std::string& name);

}  // namespace cobot_command::simulator
