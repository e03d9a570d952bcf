// The simulated robot as a script sees it: the attributes of its objects, and its functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/project_data.h"
#include "robot/tmflow_version.h"
#include "script_port/robot_attributes.h"
#include "script_port/script_clients.h"
#include "script_port/script_commands.h"

#include "cobot_command/simulator/settings.h"
#include "cobot_command/tm_script/environment.h"

namespace cobot_command::simulator {

class ScriptEnvironment final : public tm_script::Environment {
 public:
  ScriptEnvironment(const ScriptedRobot& robot, const Settings& settings, TagTable& tags,
                    FaultSwitches& faults, ScriptClients& clients)
      : attributes_(robot.model, robot.io, robot.project, robot.state),
        project_(robot.project),
        velocity_licence_(settings.velocity_licence),
        clients_(clients),
        commands_(robot, tags, faults, clients, tmflowVersion(settings.tmflow_version)) {}

  [[nodiscard]] ScriptCommands& commands() { return commands_; }

  [[nodiscard]] Result<tm_script::AttributeShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<tm_script::Scalar>>& keys,
      const std::string& name) const override {
    return attributes_.shapeOf(object, keys, name);
  }
  [[nodiscard]] std::optional<std::string> objectionTo(
      const std::string& function,
      const std::vector<std::optional<tm_script::Scalar>>& arguments) const override;
  [[nodiscard]] Result<tm_script::Value, std::string> read(
      const tm_script::AttributeName& attribute) override {
    return attributes_.read(attribute);
  }
  /// Outputs go the way of commands: what is queued, is queued.
  [[nodiscard]] std::optional<std::string> write(const tm_script::AttributeName& attribute,
                                                 std::optional<std::size_t> index,
                                                 const tm_script::Value& value) override;
  [[nodiscard]] tm_script::CallAnswer call(const std::string& function,
                                           const tm_script::Arguments& arguments) override;

 private:
  [[nodiscard]] tm_script::CallAnswer writeOutput(const tm_script::AttributeName& attribute,
                                                  std::size_t index, const tm_script::Scalar& value);
  [[nodiscard]] tm_script::CallAnswer listenSend(const tm_script::Arguments& arguments);

  RobotAttributes attributes_;
  const ProjectData& project_;
  bool velocity_licence_;
  ScriptClients& clients_;
  ScriptCommands commands_;
};

}  // namespace cobot_command::simulator
