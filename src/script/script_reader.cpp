#include "cobot_command/script/script_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"
#include "cobot_command/script/robot_functions.h"
#include "cobot_command/tm_script/checker.h"
#include "cobot_command/tm_script/interpreter.h"

namespace cobot_command::script {
namespace {

using tm_script::Scalar;
using tm_script::Value;

constexpr tm_script::Version kNewest{1, 84};

const tm_script::FunctionTable& functions() {
  static const tm_script::FunctionTable kFunctions = [] {
    tm_script::FunctionTable all(kNewest);
    declareRobotFunctions(all);
    return all;
  }();
  return kFunctions;
}

bool isFinite(const Scalar& scalar) {
  return std::visit(
      Overloaded{[](float number) { return std::isfinite(number); },
                 [](double number) { return std::isfinite(number); }, [](const auto&) { return true; }},
      scalar);
}

bool isFinite(const Value& value) {
  if (const auto* scalar = std::get_if<Scalar>(&value)) return isFinite(*scalar);
  const auto& items = std::get<tm_script::Array>(value).items;
  return std::all_of(items.begin(), items.end(), [](const Scalar& item) { return isFinite(item); });
}

/// A robot that does nothing, and of which nothing is known but its outputs and functions.
class Notebook final : public tm_script::Environment {
 public:
  [[nodiscard]] Result<tm_script::AttributeShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<Scalar>>& keys,
      const std::string& name) const override {
    const auto module = object == "IO" && keys.size() == 1 ? moduleOf(keys.front()) : std::nullopt;
    if (module && (name == "DO" || name == "InstantDO")) {
      return tm_script::AttributeShape{
          {tm_script::ScalarType::Byte, true}, true, static_cast<std::size_t>(ioCount(*module)), 1};
    }
    if (module == IoModule::ControlBox && (name == "AO" || name == "InstantAO")) {
      return tm_script::AttributeShape{{tm_script::ScalarType::Float, true}, true, std::size_t{1}};
    }
    return refuse(fmt::format("{} {} is known to the robot only", object, name));
  }

  [[nodiscard]] std::optional<std::string> objectionTo(const std::string& function,
                                                       const KnownArguments& arguments) const override {
    return script::objectionTo(function, arguments);
  }

  [[nodiscard]] Result<Value, std::string> read(const tm_script::AttributeName& attribute) override {
    return refuse(
        fmt::format("the value of {} {} is known to the robot only", attribute.object, attribute.name));
  }

  [[nodiscard]] std::optional<std::string> write(const tm_script::AttributeName& attribute,
                                                 std::optional<std::size_t> index,
                                                 const Value& value) override {
    if (const auto* array = std::get_if<tm_script::Array>(&value)) {
      for (std::size_t i = 0; i < array->items.size(); ++i) {
        if (auto fault = writeOne(attribute, i, array->items[i])) return fault;
      }
      return std::nullopt;
    }
    return writeOne(attribute, index.value_or(0), std::get<Scalar>(value));
  }

  [[nodiscard]] tm_script::CallAnswer call(const std::string& function,
                                           const tm_script::Arguments& arguments) override {
    if (function == "ListenSend") return Value(Scalar(std::int32_t{0}));
    if (auto objection = script::objectionTo(function, knownArguments(arguments))) {
      return tm_script::CallFailure{std::move(*objection)};
    }
    if (!std::all_of(arguments.begin(), arguments.end(),
                     [](const Value& value) { return isFinite(value); })) {
      return tm_script::CallFailure{"an argument is not a finite number"};
    }
    const ScriptCommand& command = commands_.emplace_back(commandOf(function, arguments));
    if (std::holds_alternative<ScriptExit>(command)) return tm_script::EndScript{Scalar(true)};
    if (std::holds_alternative<WaitQueueTag>(command)) return Value(Scalar(std::int32_t{1}));
    return Value(Scalar(true));
  }

  /// Those since it was asked before.
  [[nodiscard]] std::vector<ScriptCommand> takeCommands() { return std::exchange(commands_, {}); }

 private:
  static std::optional<IoModule> moduleOf(const std::optional<Scalar>& key) {
    const auto* name = key ? std::get_if<std::string>(&*key) : nullptr;
    return name == nullptr ? std::nullopt : ioModule(*name);
  }

  std::optional<std::string> writeOne(const tm_script::AttributeName& attribute, std::size_t index,
                                      const Scalar& value) {
    if (const auto* volt = std::get_if<float>(&value)) {
      if (!(std::abs(*volt) <= kMostVolt)) {
        return fmt::format("an analog output is -10 to 10 V, not {}", *volt);
      }
      commands_.emplace_back(WriteAnalogOutput{*volt, attribute.name == "InstantAO"});
      return std::nullopt;
    }
    const auto* level = std::get_if<std::uint8_t>(&value);
    if (*level > 1) return fmt::format("an output is 0 or 1, not {}", *level);
    const IoModule module = *moduleOf(attribute.keys.front());
    commands_.emplace_back(
        WriteOutput{module, static_cast<int>(index), *level == 1, attribute.name == "InstantDO"});
    return std::nullopt;
  }

  std::vector<ScriptCommand> commands_;
};

}  // namespace

Result<std::vector<ReadCommand>, std::vector<tm_script::Fault>> readScript(std::string_view text) {
  tm_script::ParsedScript parsed = tm_script::parse(text);
  tm_script::Variables locals;
  tm_script::Variables project;
  const tm_script::Scope scope{locals, project};
  Notebook robot;
  auto findings = tm_script::check(parsed, functions(), scope, robot);
  if (!findings.errors.empty()) return refuse(std::move(findings.errors));
  tm_script::Interpreter script(std::move(parsed.statements), functions(), scope, robot);
  std::vector<ReadCommand> commands;
  for (int line = script.line(); script.progress() == tm_script::Progress::Ready; line = script.line()) {
    script.run(1);
    for (ScriptCommand& command : robot.takeCommands()) commands.push_back({line, std::move(command)});
  }
  if (script.fault()) return refuse(std::vector{*script.fault()});
  return commands;
}

}  // namespace cobot_command::script
