// The simulated robot as a script sees it: its items, and its functions as commands.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "project_data.h"
#include "robot_items.h"

#include "cobot_command/language/environment.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::simulator {

class ScriptEnvironment final : public language::Environment {
 public:
  /// What comes of a script.
  struct Effects {
    std::function<language::CallAnswer(const protocol::ScriptCommand&)> execute;
    std::function<language::CallAnswer(const SetAnalogOutput&, bool is_instant)> set;
    std::function<void(const protocol::ListenData&)> send;
  };

  ScriptEnvironment(RobotItems items, const ProjectData& project, bool velocity_licence, Effects effects)
      : items_(std::move(items)),
        project_(project),
        velocity_licence_(velocity_licence),
        effects_(std::move(effects)) {}

  [[nodiscard]] Result<language::ItemShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<language::Scalar>>& keys,
      const std::string& attribute) const override {
    return items_.shapeOf(object, keys, attribute);
  }
  [[nodiscard]] std::optional<std::string> objectionTo(
      const std::string& function,
      const std::vector<std::optional<language::Scalar>>& arguments) const override;
  [[nodiscard]] Result<language::Value, std::string> read(const language::ItemName& item) override {
    return items_.read(item);
  }
  /// Outputs go the way of commands: what is queued, is queued.
  [[nodiscard]] std::optional<std::string> write(const language::ItemName& item,
                                                 std::optional<std::size_t> index,
                                                 const language::Value& value) override;
  [[nodiscard]] language::CallAnswer call(const std::string& function,
                                          const language::Arguments& arguments) override;

 private:
  [[nodiscard]] language::CallAnswer writeOutput(const language::ItemName& item, std::size_t index,
                                                 const language::Scalar& value);
  [[nodiscard]] language::CallAnswer listenSend(const language::Arguments& arguments);

  RobotItems items_;
  const ProjectData& project_;
  bool velocity_licence_;
  Effects effects_;
};

}  // namespace cobot_command::simulator
