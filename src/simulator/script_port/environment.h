// The simulated robot as a script sees it: its items, and its functions as commands.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/project_data.h"
#include "script_port/robot_items.h"

#include "cobot_command/protocol/message.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/environment.h"

namespace cobot_command::simulator {

class ScriptEnvironment final : public tm_script::Environment {
 public:
  /// What comes of a script.
  struct Effects {
    std::function<tm_script::CallAnswer(const script::ScriptCommand&)> execute;
    std::function<void(const protocol::ListenData&)> send;
  };

  ScriptEnvironment(RobotItems items, const ProjectData& project, bool velocity_licence, Effects effects)
      : items_(std::move(items)),
        project_(project),
        velocity_licence_(velocity_licence),
        effects_(std::move(effects)) {}

  [[nodiscard]] Result<tm_script::ItemShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<tm_script::Scalar>>& keys,
      const std::string& attribute) const override {
    return items_.shapeOf(object, keys, attribute);
  }
  [[nodiscard]] std::optional<std::string> objectionTo(
      const std::string& function,
      const std::vector<std::optional<tm_script::Scalar>>& arguments) const override;
  [[nodiscard]] Result<tm_script::Value, std::string> read(const tm_script::ItemName& item) override {
    return items_.read(item);
  }
  /// Outputs go the way of commands: what is queued, is queued.
  [[nodiscard]] std::optional<std::string> write(const tm_script::ItemName& item,
                                                 std::optional<std::size_t> index,
                                                 const tm_script::Value& value) override;
  [[nodiscard]] tm_script::CallAnswer call(const std::string& function,
                                           const tm_script::Arguments& arguments) override;

 private:
  [[nodiscard]] tm_script::CallAnswer writeOutput(const tm_script::ItemName& item, std::size_t index,
                                                  const tm_script::Scalar& value);
  [[nodiscard]] tm_script::CallAnswer listenSend(const tm_script::Arguments& arguments);

  RobotItems items_;
  const ProjectData& project_;
  bool velocity_licence_;
  Effects effects_;
};

}  // namespace cobot_command::simulator
