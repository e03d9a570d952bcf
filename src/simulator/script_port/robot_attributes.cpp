#include "script_port/robot_attributes.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "robot/tool_twist.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::simulator {

namespace {

using tm_script::Array;
using tm_script::AttributeShape;
using tm_script::Scalar;
using tm_script::ScalarType;
using tm_script::Value;

struct Row {
  std::string_view object;
  std::string_view module;  ///< of IO
  std::string_view name;
  ScalarType type;
  std::size_t length = 0;  ///< 0: no array
  bool is_writable = false;
};

constexpr std::array<Row, 40> kRows{{
    {"IO", "ControlBox", "DI", ScalarType::Byte, 16},
    {"IO", "ControlBox", "DO", ScalarType::Byte, 16, true},
    {"IO", "ControlBox", "InstantDO", ScalarType::Byte, 16, true},
    {"IO", "ControlBox", "AI", ScalarType::Float, 2},
    {"IO", "ControlBox", "AO", ScalarType::Float, 1, true},
    {"IO", "ControlBox", "InstantAO", ScalarType::Float, 1, true},
    {"IO", "EndModule", "DI", ScalarType::Byte, 4},
    {"IO", "EndModule", "DO", ScalarType::Byte, 4, true},
    {"IO", "EndModule", "InstantDO", ScalarType::Byte, 4, true},
    {"IO", "EndModule", "AI", ScalarType::Float, 1},
    {"IO", "Safety", "SI", ScalarType::Byte, 5},
    {"IO", "Safety", "SO", ScalarType::Byte, 5},
    {"Robot", "", "CoordRobot", ScalarType::Float, 6},
    {"Robot", "", "CoordBase", ScalarType::Float, 6},
    {"Robot", "", "Joint", ScalarType::Float, 6},
    {"Robot", "", "BaseName", ScalarType::String},
    {"Robot", "", "TCPName", ScalarType::String},
    {"Robot", "", "TCPForce3D", ScalarType::Float},
    {"Robot", "", "TCPSpeed3D", ScalarType::Float},
    {"Robot", "", "CameraLight", ScalarType::Byte, 0, true},
    {"Base", "", "Value", ScalarType::Float, 6, true},
    {"Base", "", "Type", ScalarType::String},
    {"Base", "", "TeachValue", ScalarType::Float, 6},
    {"TCP", "", "Value", ScalarType::Float, 6, true},
    {"TCP", "", "Mass", ScalarType::Float, 0, true},
    {"TCP", "", "MOI", ScalarType::Float, 3, true},
    {"TCP", "", "MCF", ScalarType::Float, 6, true},
    {"TCP", "", "TeachValue", ScalarType::Float, 6},
    {"TCP", "", "TeachMass", ScalarType::Float},
    {"TCP", "", "TeachMOI", ScalarType::Float, 3},
    {"TCP", "", "TeachMCF", ScalarType::Float, 6},
    {"Point", "", "Value", ScalarType::Float, 6, true},
    {"Point", "", "Pose", ScalarType::Int, 3, true},
    {"Point", "", "Flange", ScalarType::Float, 6},
    {"Point", "", "BaseName", ScalarType::String},
    {"Point", "", "TCPName", ScalarType::String},
    {"Point", "", "TeachValue", ScalarType::Float, 6},
    {"Point", "", "TeachPose", ScalarType::Int, 3},
    // Known, but not simulated.
    {"VPoint", "", "", ScalarType::Float},
    {"FT", "", "", ScalarType::Float},
}};
constexpr std::size_t kSimulated = 38;

template <class Range>
Value arrayOf(ScalarType type, const Range& range) {
  Array array{type, {}};
  for (const auto& item : range) array.items.emplace_back(item);
  return array;
}

template <std::size_t N>
Value bytesOf(const std::array<bool, N>& bits) {
  Array array{ScalarType::Byte, {}};
  for (const bool bit : bits) array.items.emplace_back(static_cast<std::uint8_t>(bit ? 1 : 0));
  return array;
}

template <class T, std::size_t N>
std::array<T, N> fromArray(const Value& value) {
  std::array<T, N> all{};
  const auto& items = std::get<Array>(value).items;
  std::transform(items.begin(), items.end(), all.begin(),
                 [](const Scalar& item) { return std::get<T>(item); });
  return all;
}

/// Is a thing of this name fixed? The error names the things that there are.
template <class Map>
Result<bool, std::string> isFixed(const Map& map, const std::string& object, const Scalar& key) {
  const auto* name = std::get_if<std::string>(&key);
  const auto found = name == nullptr ? map.end() : map.find(*name);
  if (found == map.end()) {
    return refuse(fmt::format("the project has no such {}; it has {}", object, namesOf(map)));
  }
  return found->second.is_fixed;
}

Result<bool, std::string> isFixed(const ProjectData& project, const std::string& object, const Scalar& key) {
  if (object == "Base") return isFixed(project.bases, object, key);
  if (object == "TCP") return isFixed(project.tools, object, key);
  if (object == "Point") return isFixed(project.points, object, key);
  if (object == "Robot" && key != Scalar(std::uint8_t{0}) && key != Scalar(std::int32_t{0})) {
    return refuse(std::string("there is only Robot[0]"));
  }
  return false;
}

/// With a key that is not known before the run: any of the modules.
Result<const Row*, std::string> find(const std::string& object, const std::optional<Scalar>& key,
                                     const std::string& name) {
  const auto* module = key ? std::get_if<std::string>(&*key) : nullptr;
  const auto matches = [&](const Row& a) {
    if (a.object != object || (a.name != name && !a.name.empty())) return false;
    return object != "IO" || !key || a.module.empty() || (module != nullptr && *module == a.module);
  };
  const auto* const found = std::find_if(kRows.begin(), kRows.end(), matches);
  if (found == kRows.end()) {
    return refuse(
        fmt::format("there is no attribute {}[{}].{}", object, key ? tm_script::textOf(*key) : "", name));
  }
  if (found - kRows.begin() >= static_cast<std::ptrdiff_t>(kSimulated)) {
    return refuse(fmt::format("{}[..].{} is known, but not simulated", object, name));
  }
  return found;
}

}  // namespace

Result<AttributeShape, std::string> RobotAttributes::shapeOf(const std::string& object,
                                                             const std::vector<std::optional<Scalar>>& keys,
                                                             const std::string& attribute) const {
  if (keys.size() > 1) return refuse(object + " has one name here: vision bases are not simulated");
  const auto found = find(object, keys.front(), attribute);
  if (!found) return refuse(found.error());
  const Row& known = **found;
  AttributeShape shape{{known.type, known.length > 0}, known.is_writable, std::nullopt};
  if (known.length > 0 && (keys.front() || object != "IO")) shape.length = known.length;
  if ((object == "IO" || object == "Robot") && known.type == ScalarType::Byte) shape.most = 1;
  if (!keys.front()) return shape;
  const auto fixed = isFixed(project_, object, *keys.front());
  if (!fixed) return refuse(fixed.error());
  shape.is_writable = shape.is_writable && !*fixed;
  return shape;
}

Result<Value, std::string> RobotAttributes::read(const tm_script::AttributeName& attribute) const {
  if (auto shape = shapeOf(attribute.object, {attribute.keys.begin(), attribute.keys.end()}, attribute.name);
      !shape) {
    return refuse(std::move(shape.error()));
  }
  if (attribute.object == "Robot") return ofRobot(attribute.name);
  const auto& name = std::get<std::string>(attribute.keys.front());
  return attribute.object == "IO" ? ofIo(name, attribute.name)
                                  : ofProject(attribute.object, name, attribute.name);
}

Value RobotAttributes::ofIo(const std::string& module, const std::string& attribute) const {
  const bool is_box = script::ioModule(module) == script::IoModule::ControlBox;
  if (attribute == "AI") return arrayOf(ScalarType::Float, std::vector<float>(is_box ? 2 : 1, 0.0F));
  if (attribute == "AO" || attribute == "InstantAO") {
    return arrayOf(ScalarType::Float, std::array<float, 1>{io_.analogOutput()});
  }
  if (attribute == "SI" || attribute == "SO") return bytesOf(std::array<bool, 5>{});
  const DigitalIo& digital = attribute == "DI" ? io_.inputs() : io_.outputs();
  return is_box ? bytesOf(digital.control_box) : bytesOf(digital.end_module);
}

Value RobotAttributes::ofRobot(const std::string& attribute) const {
  const RobotState state = state_();
  const arm::Pose tool = state.flange * state.tcp;
  if (attribute == "CoordRobot") return arrayOf(ScalarType::Float, toFloats(tool));
  if (attribute == "CoordBase") return arrayOf(ScalarType::Float, toFloats(state.base.inverse() * tool));
  if (attribute == "BaseName") return Scalar(state.base_name);
  if (attribute == "TCPName") return Scalar(state.tcp_name);
  if (attribute == "TCPSpeed3D") return Scalar(linearSpeed(toolTwist(model_, state)));
  if (attribute == "TCPForce3D") return Scalar(static_cast<float>(state.tcp_force.norm()));
  if (attribute == "CameraLight") return Scalar(std::uint8_t{state.camera_light});
  Array joints{ScalarType::Float, {}};
  for (const double joint : arm::toControllerJoints(state.joints)) {
    joints.items.emplace_back(static_cast<float>(joint));
  }
  return joints;
}

Value RobotAttributes::ofProject(const std::string& object, const std::string& name,
                                 const std::string& attribute) const {
  constexpr std::string_view kTeach = "Teach";
  const bool is_taught = attribute.substr(0, kTeach.size()) == kTeach;
  const std::string what = is_taught ? attribute.substr(kTeach.size()) : attribute;
  const auto of = [is_taught](const auto& entry) -> const auto& {
    return is_taught ? entry.taught : entry.now;
  };
  if (object == "Base") {
    if (what == "Type") return Scalar(std::string(name == script::kRobotBase ? "R" : "C"));
    return arrayOf(ScalarType::Float, of(project_.bases.at(name)).numbers);
  }
  if (object == "Point") {
    const Point& point = of(project_.points.at(name));
    if (what == "Pose") return arrayOf(ScalarType::Int, point.pose_bits);
    if (what == "BaseName") return Scalar(std::string(script::kRobotBase));
    if (what == "TCPName") return Scalar(std::string(script::kNoTool));
    return arrayOf(ScalarType::Float, what == "Flange" ? point.flange : point.frame.numbers);
  }
  const Tool& tool = of(project_.tools.at(name));
  if (what == "Mass") return Scalar(tool.mass);
  if (what == "MOI") return arrayOf(ScalarType::Float, tool.moment);
  return arrayOf(ScalarType::Float, what == "MCF" ? tool.mass_center : tool.frame.numbers);
}

void RobotAttributes::write(const tm_script::AttributeName& attribute, std::optional<std::size_t> index,
                            const Value& value) {
  if (attribute.object == "Robot") {
    return io_.write(SetCameraLight{std::get<std::uint8_t>(std::get<Scalar>(value)) == 1});
  }
  const auto& name = std::get<std::string>(attribute.keys.front());
  Value whole = index ? ofProject(attribute.object, name, attribute.name) : value;
  if (index) std::get<Array>(whole).items[*index] = std::get<Scalar>(value);
  if (attribute.object == "Base") {
    project_.bases.at(name).now = Frame(fromArray<float, 6>(whole));
  } else if (attribute.object == "Point") {
    Point& point = project_.points.at(name).now;
    if (attribute.name == "Pose") point.pose_bits = fromArray<int, 3>(whole);
    if (attribute.name == "Value") point.frame = Frame(fromArray<float, 6>(whole));
  } else {
    Tool& tool = project_.tools.at(name).now;
    if (attribute.name == "Value") tool.frame = Frame(fromArray<float, 6>(whole));
    if (attribute.name == "Mass") tool.mass = std::get<float>(std::get<Scalar>(whole));
    if (attribute.name == "MOI") tool.moment = fromArray<float, 3>(whole);
    if (attribute.name == "MCF") tool.mass_center = fromArray<float, 6>(whole);
  }
}

bool isObject(const std::string& name) {
  return std::any_of(kRows.begin(), kRows.end(),
                     [&](const Row& attribute) { return attribute.object == name; });
}

}  // namespace cobot_command::simulator
