#include "command/pick_and_place_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <locale>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "shared/regular_file.h"
#include <fmt/format.h>
#include <rospack/rospack.h>
#include <yaml-cpp/yaml.h>

#include "cobot_command/RobotPose.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::size_t kMaxFileSize = 1 << 20;  // a thousand times the steps of the thesis
constexpr double kDefaultDwell = 2;            // [s] as in the thesis

/// Leaves parsePickAndPlace() as its error.
struct Fault : std::runtime_error {
  Fault(const YAML::Mark& place, const std::string& what) : std::runtime_error(what), mark(place) {}
  YAML::Mark mark;
};

using Names = std::vector<std::pair<const char*, int>>;

const Names kMovements = {{"LINE", static_cast<int>(blocks::Movement::Line)},
                          {"PTP", static_cast<int>(blocks::Movement::Ptp)}};
const Names kFormats = {{"JPP", static_cast<int>(blocks::AbsoluteFormat::Jpp)},
                        {"CPP", static_cast<int>(blocks::AbsoluteFormat::Cpp)},
                        {"CPR", static_cast<int>(blocks::AbsoluteFormat::Cpr)},
                        {"CAP", static_cast<int>(blocks::AbsoluteFormat::Cap)},
                        {"CAR", static_cast<int>(blocks::AbsoluteFormat::Car)}};
const std::array<Names, 3> kPostures = {
    Names{{"RIGHTY", cobot_command::RobotPose::RIGHTY}, {"LEFTY", cobot_command::RobotPose::LEFTY}},
    Names{{"ABOVE", cobot_command::RobotPose::ABOVE}, {"BELOW", cobot_command::RobotPose::BELOW}},
    Names{{"NOFLIP", cobot_command::RobotPose::NOFLIP}, {"FLIP", cobot_command::RobotPose::FLIP}}};

std::string listed(const Names& names) {
  std::string text;
  for (const auto& [name, value] : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// What a value is called in errors: never what stands in the file, which may be any.
std::string found(const YAML::Node& node) {
  if (node.IsScalar()) return "something else";
  return node.IsSequence() ? "a list" : node.IsMap() ? "a map" : "nothing";
}

template <class Value>
bool decode(const YAML::Node& node, Value& value) {
  return YAML::convert<Value>::decode(node, value);
}

/// yaml-cpp reads numbers by the locale of the process: where people write a comma, 2.5 would be none,
/// and 2.500 be 2500.
template <class Number>
bool decodeNumber(const YAML::Node& node, Number& value) {
  std::istringstream stream(node.Scalar());
  stream.imbue(std::locale::classic());
  stream.unsetf(std::ios::dec);  // 0x10 is a whole number as well
  return stream >> std::noskipws >> value && stream.peek() == std::istringstream::traits_type::eof();
}
template <>
bool decode(const YAML::Node& node, double& value) {
  return decodeNumber(node, value);
}
template <>
bool decode(const YAML::Node& node, int& value) {
  return decodeNumber(node, value);
}

template <class Value>
Value convert(const YAML::Node& node, const std::string& key, const char* allowed) {
  Value value{};
  if (!node.IsScalar() || !decode(node, value)) {
    throw Fault(node.Mark(), fmt::format("{} is {}; it must be {}", key, found(node), allowed));
  }
  return value;
}

int named(const YAML::Node& node, const std::string& key, const Names& names) {
  const auto text = node.IsScalar() ? node.Scalar() : std::string();
  const auto entry = std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == text; });
  if (entry == names.end()) {
    throw Fault(node.Mark(), fmt::format("{} is {}; it must be one of: {}", key, found(node), listed(names)));
  }
  return entry->second;
}

/// A YAML map, of which every key has to be known.
class Map {
 public:
  Map(const YAML::Node& node, const char* what, const std::vector<std::string>& keys) : node_(node) {
    if (!node_.IsMap()) {
      throw Fault(node_.Mark(), fmt::format("{} is {}; it must be a map", what, found(node_)));
    }
    std::vector<std::string> seen;
    for (const auto& entry : node_) {
      const auto key = entry.first.IsScalar() ? entry.first.Scalar() : std::string();
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        throw Fault(entry.first.Mark(),
                    fmt::format("unknown key in {}; known: {}", what, fmt::join(keys, ", ")));
      }
      if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
        throw Fault(entry.first.Mark(), fmt::format("{} stands twice in {}", key, what));
      }
      seen.push_back(key);
    }
  }

  [[nodiscard]] bool has(const char* key) const { return node_[key].IsDefined(); }
  [[nodiscard]] YAML::Node required(const char* key) const {
    const YAML::Node value = node_[key];
    if (!value.IsDefined()) throw Fault(node_.Mark(), fmt::format("{} is missing", key));
    return value;
  }
  [[nodiscard]] double number(const char* key) const {
    return convert<double>(required(key), key, "a number");
  }
  [[nodiscard]] int whole(const char* key) const {
    return convert<int>(required(key), key, "a whole number");
  }
  [[nodiscard]] bool truth(const char* key) const {
    return convert<bool>(required(key), key, "true or false");
  }
  [[nodiscard]] std::string text(const char* key) const {
    return convert<std::string>(required(key), key, "a text");
  }
  [[nodiscard]] int named(const char* key, const Names& names) const {
    return ros_adapter::named(required(key), key, names);
  }
  /// A list of `count` values.
  [[nodiscard]] YAML::Node list(const char* key, std::size_t count) const {
    const YAML::Node values = required(key);
    if (!values.IsSequence() || values.size() != count) {
      const auto is = values.IsSequence() ? fmt::format("a list of {}", values.size()) : found(values);
      throw Fault(values.Mark(), fmt::format("{} is {}; it must be a list of {}", key, is, count));
    }
    return values;
  }

 private:
  YAML::Node node_;
};

blocks::MoveAbsoluteGoal toMove(const Map& step) {
  blocks::MoveAbsoluteGoal move;
  move.movement_command = step.named("movement_command", kMovements);
  move.data_format = step.named("data_format", kFormats);
  const YAML::Node target = step.list("target_position", move.target.size());
  for (std::size_t i = 0; i < move.target.size(); ++i) {
    move.target[i] = convert<double>(target[i], fmt::format("target_position[{}]", i), "a number");
  }
  move.speed = step.whole("speed");
  move.accel_time = step.whole("accel_time");
  if (step.has("command_id")) move.command_id = step.whole("command_id");
  if (step.has("blending_enable")) move.blending_enable = step.truth("blending_enable");
  if (step.has("blending_value")) move.blending_value = step.whole("blending_value");
  if (step.has("exit_node")) move.exit_node = step.truth("exit_node");
  if (step.has("disable_precise_positioning")) {
    move.disable_precise_positioning = step.truth("disable_precise_positioning");
  }
  if (!step.has("robot_pose")) return move;
  move.robot_pose_enable = true;
  const YAML::Node posture = step.list("robot_pose", kPostures.size());
  for (std::size_t i = 0; i < kPostures.size(); ++i) {
    move.robot_pose[i] = named(posture[i], fmt::format("robot_pose[{}]", i), kPostures[i]);
  }
  return move;
}

/// true: `usual`; a number: that long [s].
double toDwell(const Map& step, double usual) {
  if (!step.has("dwell")) return 0;
  const YAML::Node node = step.required("dwell");
  bool wanted = false;
  if (YAML::convert<bool>::decode(node, wanted)) return wanted ? usual : 0;
  return convert<double>(node, "dwell", "true, false, or a number of seconds");
}

/// A file from before says the contrary with it.
void refuseRetiredKey(const YAML::Node& step) {
  if (!step.IsMap()) return;
  for (const auto& entry : step) {
    if (entry.first.IsScalar() && entry.first.Scalar() == "precise_positioning") {
      throw Fault(entry.first.Mark(),
                  "precise_positioning has become disable_precise_positioning, which says the contrary: "
                  "leave it out where it was true, write disable_precise_positioning: true where it was "
                  "false");
    }
  }
}

blocks::PickAndPlaceStep toStep(const YAML::Node& node, double usual_dwell) {
  refuseRetiredKey(node);
  const Map map(node, "a step",
                {"name", "command_id", "movement_command", "data_format", "target_position", "speed",
                 "accel_time", "blending_enable", "blending_value", "disable_precise_positioning",
                 "robot_pose", "exit_node", "output", "input", "dwell"});
  if (map.has("name")) static_cast<void>(map.text("name"));
  blocks::PickAndPlaceStep step;
  step.move = toMove(map);
  if (map.has("output")) {
    const Map output(map.required("output"), "output", {"module", "output", "value"});
    step.output.emplace();
    step.output->module = output.text("module");
    step.output->output = output.whole("output");
    step.output->value = output.truth("value") ? 1 : 0;
  }
  if (map.has("input")) {
    const Map input(map.required("input"), "input", {"module", "input", "value", "timeout"});
    step.input.emplace();
    step.input->module = input.text("module");
    step.input->input = input.whole("input");
    step.input->value = input.truth("value");
    if (input.has("timeout")) step.input->timeout = input.number("timeout");
  }
  step.dwell = toDwell(map, usual_dwell);
  return step;
}

PickAndPlaceSteps toSteps(const YAML::Node& document) {
  const Map file(document, "the file", {"dwell", "steps"});
  const double usual_dwell = file.has("dwell") ? file.number("dwell") : kDefaultDwell;
  const YAML::Node list = file.required("steps");
  if (!list.IsSequence()) {
    throw Fault(list.Mark(), fmt::format("steps is {}; it must be a list", found(list)));
  }
  // Before any is read: aliases make long lists of short files.
  if (list.size() > blocks::PickAndPlaceGoal::kMostSteps) {
    throw Fault(list.Mark(), fmt::format("steps is a list of {}; it must have 1..{} steps", list.size(),
                                         blocks::PickAndPlaceGoal::kMostSteps));
  }
  PickAndPlaceSteps steps;
  for (const YAML::Node& node : list) steps.push_back(toStep(node, usual_dwell));
  return steps;
}

std::string describe(const std::string& name, const YAML::Mark& mark, const std::string& what) {
  return mark.is_null() ? fmt::format("{}: {}", name, what)
                        : fmt::format("{}:{}: {}", name, mark.line + 1, what);
}

/// What a library says of the text: its words, without what it found in it.
std::string wordsOf(const YAML::Exception& fault) {
  return "no YAML: " + fault.msg.substr(0, fault.msg.find(':'));
}

/// Empty when there is no such package. Not roslib's own way, which tells of it on standard error besides.
/// One at a time, as there: librospack is not made for threads (getpwuid(), for one, has one answer for all),
/// and files are read by several. Only the crawl waits here, for another crawl.
std::string folderOf(const std::string& package) {
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  rospack::Rospack packages;
  packages.setQuiet(true);
  std::vector<std::string> places;
  if (!packages.getSearchPathFromEnv(places)) return "";
  packages.crawl(places, false);
  std::string folder;
  return packages.find(package, folder) ? folder : "";
}

/// Leads it out of the folder in which it is looked for? Links in there lead where whoever made them wants.
bool leadsOut(const std::filesystem::path& path) {
  return path.is_absolute() || *path.lexically_normal().begin() == "..";
}

/// The path on this machine; its error says what is wrong with the location.
Result<std::filesystem::path, std::string> toPath(const std::string& location) {
  static const std::string kScheme = "package://";
  if (location.find('\0') != std::string::npos) {
    return refuse(fmt::format("steps_file is '{}'; a path has no NUL", foreignText(location)));
  }
  if (location.compare(0, kScheme.size(), kScheme) != 0) {
    if (std::filesystem::path(location).is_absolute()) return std::filesystem::path(location);
    return refuse(fmt::format("steps_file is '{}'; it must be an absolute path, or package://NAME/path",
                              foreignText(location)));
  }
  const std::size_t slash = std::min(location.find('/', kScheme.size()), location.size());
  const std::string package = location.substr(kScheme.size(), slash - kScheme.size());
  const std::string path = location.substr(std::min(slash + 1, location.size()));
  const std::string folder = folderOf(package);
  if (folder.empty()) {
    return refuse(fmt::format("{}: package '{}' is not found", foreignText(location),
                              foreignText(package, kQuoteLimit)));
  }
  if (path.empty()) return refuse(foreignText(location) + ": the path in the package is missing");
  if (leadsOut(path)) {
    return refuse(
        fmt::format("{}: the path leads out of the package; give an absolute path for what is elsewhere",
                    foreignText(location)));
  }
  return std::filesystem::path(folder) / path;
}

}  // namespace

Result<PickAndPlaceSteps, std::string> parsePickAndPlace(const std::string& text, const std::string& name) {
  try {
    return toSteps(YAML::Load(text));
  } catch (const Fault& fault) {
    return refuse(describe(name, fault.mark, fault.what()));
  } catch (const YAML::Exception& fault) {
    return refuse(describe(name, fault.mark, wordsOf(fault)));
  }
}

Result<PickAndPlaceSteps, std::string> readPickAndPlaceFile(const std::string& location) {
  const auto path = toPath(location);
  if (!path) return refuse(path.error());
  const auto text = readRegularFile(*path, kMaxFileSize);
  if (!text) return refuse(fmt::format("{}: {}", foreignText(path->string()), text.error()));
  return parsePickAndPlace(*text, foreignText(path->string()));
}

}  // namespace cobot_command::ros_adapter
