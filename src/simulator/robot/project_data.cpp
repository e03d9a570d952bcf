#include "robot/project_data.h"

#include <algorithm>
#include <array>
#include <optional>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/pose_bits.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/checker.h"
#include "cobot_command/tm_script/interpreter.h"

namespace cobot_command::simulator {

namespace {

/// Where project variables are declared there is no robot.
class NoRobot final : public tm_script::Environment {
 public:
  Result<tm_script::AttributeShape, std::string> shapeOf(const std::string&,
                                                         const std::vector<std::optional<tm_script::Scalar>>&,
                                                         const std::string&) const override {
    return refuse(none_);
  }
  [[nodiscard]] std::optional<std::string> objectionTo(
      const std::string&, const std::vector<std::optional<tm_script::Scalar>>&) const override {
    return none_;
  }
  Result<tm_script::Value, std::string> read(const tm_script::AttributeName&) override {
    return refuse(none_);
  }
  std::optional<std::string> write(const tm_script::AttributeName&, std::optional<std::size_t>,
                                   const tm_script::Value&) override {
    return none_;
  }
  tm_script::CallAnswer call(const std::string&, const tm_script::Arguments&) override {
    return tm_script::CallFailure{none_};
  }

 private:
  const std::string none_ = "a declaration cannot use attributes or functions of a robot";
};

/// Beside the flange, looking along its axis [mm, deg]. Ours: the camera of each robot is calibrated.
constexpr std::array<double, 6> kHandCamera{0, 80, 40, 0, 0, 0};

template <class Map>
void forget(Map& map) {
  for (auto& entry : map) entry.second.now = entry.second.taught;
}

}  // namespace

Result<std::string, std::string> declare(tm_script::Variables& variables, const std::string& declaration) {
  const tm_script::FunctionTable functions;
  tm_script::Variables none;
  const tm_script::Scope scope{variables, none};
  NoRobot robot;
  const tm_script::ParsedScript script = tm_script::parse(declaration);
  const tm_script::Findings findings = tm_script::check(script, functions, scope, robot);
  const auto refused = [&](const std::string& reason) {
    return refuse("it declares no variable: " + reason);
  };
  if (!findings.errors.empty()) return refused(findings.errors.front().reason);
  const auto& lines = script.statements;
  const auto* declared =
      lines.size() == 1 ? std::get_if<tm_script::Declaration>(&lines.front().content) : nullptr;
  if (declared == nullptr) return refused("it is another kind of statement, or several statements");
  tm_script::Interpreter interpreter(lines, functions, scope, robot);
  interpreter.run(1);
  if (interpreter.fault()) return refused(interpreter.fault()->reason);
  return declared->name;
}

SixFloats toFloats(const arm::Pose& pose) {
  const arm::ControllerPose numbers = arm::toControllerPose(pose);
  SixFloats floats{};
  std::transform(numbers.begin(), numbers.end(), floats.begin(),
                 [](double number) { return static_cast<float>(number) + 0.0F; });  // no -0
  return floats;
}

Frame::Frame(const SixFloats& from) : numbers(from) {
  arm::ControllerPose wide{};
  std::copy(from.begin(), from.end(), wide.begin());
  pose = arm::toPose(wide);
}

ProjectData::ProjectData(const Settings& settings, const arm::ArmModel& model) {
  bases.emplace(script::kRobotBase, Taught<Frame>(Frame(arm::Pose::Identity()), true));
  for (const auto& [name, pose] : settings.bases) bases.emplace(name, Taught<Frame>(Frame(pose)));
  const auto add_tool = [this](const std::string& name, const arm::Pose& pose, bool is_fixed) {
    Tool tool;
    tool.frame = Frame(pose);
    tools.emplace(name, Taught<Tool>(tool, is_fixed));
  };
  add_tool(script::kNoTool, arm::Pose::Identity(), true);
  for (const auto& [name, pose] : settings.tcps) add_tool(name, pose, name == "HandCamera");
  add_tool("HandCamera", arm::toPose(kHandCamera), true);
  for (const auto& [name, joints] : settings.points) {
    Point point;
    point.frame = Frame(arm::forwardKinematics(model, joints));
    point.pose_bits = arm::poseBitsOf(model, joints).numbers();
    point.flange = point.frame.numbers;
    points.emplace(name, Taught<Point>(point));
  }
  for (const std::string& declaration : settings.variables) {
    const auto name = declare(variables, declaration);
    if (name) declared.emplace(*name, *variables.find(*name));
  }
}

void ProjectData::beginAnew() {
  forget(bases);
  forget(tools);
  forget(points);
  for (const auto& [name, value] : declared) {
    if (name.rfind("g_", 0) != 0) variables.set(name, value);
  }
}

}  // namespace cobot_command::simulator
