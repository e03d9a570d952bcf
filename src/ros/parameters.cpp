#include "cobot_command/ros/parameters.h"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/runtime/simulator_runtime.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr double kAnnouncementTimeout = 30;  // [s]; a node starts in far less

/// Reads parameters one after the other and keeps the first complaint.
class Reader {
 public:
  explicit Reader(const ros::NodeHandle& self) : self_(self) {}

  template <class Value>
  Value read(const std::string& name, Value fallback) {
    if (!self_.hasParam(name)) return fallback;
    Value value = fallback;
    if (!self_.getParam(name, value)) complain(name, "has the wrong type", "the type that README.md lists");
    return value;
  }

  template <class Number>
  Number readInRange(const std::string& name, Number fallback, Number lowest, Number highest) {
    const Number value = read(name, fallback);
    // Written so that NaN is refused as well.
    if (!(value >= lowest && value <= highest)) {
      complain(name, fmt::format("is {}", value), fmt::format("{} to {}", lowest, highest));
    }
    return value;
  }

  /// Launch files and rosparam make a number of 1.80.
  std::string readVersion(const std::string& name, const std::string& fallback) {
    double number = 0;
    if (self_.getParam(name, number)) return fmt::format("{:.2f}", number);
    return read(name, fallback);
  }

  Duration readSeconds(const std::string& name, Duration fallback, double lowest, double highest) {
    const double seconds = readInRange(name, toSeconds(fallback), lowest, highest);
    return error_ ? fallback : fromSeconds(seconds);
  }

  void complain(const std::string& name, const std::string& found, const std::string& allowed) {
    if (error_) return;
    error_ =
        ParameterError{fmt::format("parameter {} {}; allowed: {}", self_.resolveName(name), found, allowed)};
  }

  [[nodiscard]] const std::optional<ParameterError>& error() const { return error_; }

 private:
  const ros::NodeHandle& self_;
  std::optional<ParameterError> error_;
};

/// The model named by ~robot_model, else the one of robot_description.
std::optional<arm::ArmModel> readArm(const ros::NodeHandle& node, Reader& reader) {
  const auto name = reader.read<std::string>("robot_model", "");
  std::string urdf;
  if (!name.empty()) {
    auto model = arm::ArmModel::named(name);
    if (model) return std::move(*model);
    reader.complain("robot_model", "is not usable: " + model.error().message, "a known model, or empty");
  } else if (node.getParam("robot_description", urdf)) {
    auto model = arm::ArmModel::fromUrdf(urdf);
    if (model) return std::move(*model);
    reader.complain("robot_model", "is empty, and robot_description is not usable: " + model.error().message,
                    "a known model, or a robot_description of the TM family");
  }
  return std::nullopt;
}

link::LinkSettings readLink(Reader& reader) {
  link::LinkSettings link;
  link.status_port = reader.readInRange("status_port", link.status_port, 0, 65535);
  link.open_timeout = reader.readSeconds("open_timeout", link.open_timeout, 0.1, 60.0);
  link.retry_min = reader.readSeconds("retry_min", link.retry_min, 0.01, 60.0);
  link.retry_max = reader.readSeconds("retry_max", link.retry_max, 0.01, 60.0);
  link.reply_timeout = reader.readSeconds("reply_timeout", link.reply_timeout, 0.05, 60.0);
  link.supervision_period = reader.readSeconds("supervision_period", link.supervision_period, 0.05, 60.0);
  link.supervision_misses = reader.readInRange("supervision_misses", link.supervision_misses, 1, 100);
  link.status_timeout = reader.readSeconds("status_timeout", link.status_timeout, 0.1, 60.0);
  link.tag_deadline_factor = reader.readInRange("tag_deadline_factor", link.tag_deadline_factor, 1.0, 100.0);
  link.tag_deadline_margin = reader.readSeconds("tag_deadline_margin", link.tag_deadline_margin, 0.1, 3600.0);
  link.unplanned_motion_timeout =
      reader.readSeconds("unplanned_motion_timeout", link.unplanned_motion_timeout, 1.0, 86400.0);
  link.stop_timeout = reader.readSeconds("stop_timeout", link.stop_timeout, 0.1, 60.0);
  link.evidence_timeout = reader.readSeconds("evidence_timeout", link.evidence_timeout, 0.05, 10.0);
  link.position_tolerance = reader.readInRange("position_tolerance", link.position_tolerance, 1e-5, 1.0);
  link.angle_tolerance = reader.readInRange("angle_tolerance", link.angle_tolerance, 1e-5, 1.0);
  link.auto_reconnect = reader.read("auto_reconnect", link.auto_reconnect);
  link.stop_orphaned_motion = reader.read("stop_orphaned_motion", link.stop_orphaned_motion);
  return link;
}

/// The port that the node `controller` says it listens on; waits for it until `deadline`.
std::optional<int> announcedPort(const ros::NodeHandle& node, const std::string& controller, const char* name,
                                 const ros::SteadyTime& deadline) {
  const std::string parameter = controller + "/listening/" + name;
  int port = 0;
  while (!node.getParam(parameter, port)) {
    if (!ros::ok() || ros::SteadyTime::now() > deadline) return std::nullopt;
    ros::WallDuration(0.05).sleep();
  }
  return port;
}

/// The ports of ~simulated_controller, if that is given, in place of ~script_port and ~status_port.
void readAnnouncedPorts(const ros::NodeHandle& node, Reader& reader, CommandParameters& parameters) {
  const auto controller = reader.read<std::string>("simulated_controller", "");
  if (controller.empty() || reader.error()) return;
  const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(kAnnouncementTimeout);
  const auto script = announcedPort(node, controller, "script_port", deadline);
  const auto status = announcedPort(node, controller, "status_port", deadline);
  if (!script || !status) {
    reader.complain(
        "simulated_controller",
        fmt::format("is {}, which has told no ports within {} s", controller, kAnnouncementTimeout),
        "the name of a running simulated_controller_node, or empty");
    return;
  }
  parameters.script_port = *script;
  parameters.link.status_port = *status;
}

/// A parameter that is written as text: `use` gets what `parse` makes of it, or the complaint is kept.
template <class Parse, class Use>
void readText(Reader& reader, const std::string& name, const Parse& parse, const Use& use) {
  const auto text = reader.read<std::string>(name, "");
  if (text.empty() || reader.error()) return;
  const auto value = parse(text);
  if (value) return use(*value);
  reader.complain(name, "is not usable: " + value.error(), "what README.md lists");
}

void readStatusPort(Reader& reader, simulator::Settings& settings) {
  settings.tmflow_version = reader.readVersion("tmflow_version", settings.tmflow_version);
  settings.status_period = reader.readSeconds("status_period", settings.status_period, 0.001, 1.0);
  readText(reader, "stream_format", simulator::parseStreamFormat,
           [&](auto format) { settings.stream_format = format; });
  const auto items = reader.read<std::string>("stream_items", "");
  if (!items.empty()) settings.stream_items = simulator::parseNames(items);
  readText(reader, "write_clients", simulator::parseWriteClients,
           [&](const auto& clients) { settings.write_clients = clients; });
  settings.variables = reader.read("variables", settings.variables);
  if (const auto fault = simulator::faultIn(settings)) {
    reader.complain("stream_items", "does not fit tmflow_version and variables: " + *fault,
                    "what README.md lists");
  }
}

/// A list of texts NAME=1,2,3,4,5,6.
template <class Use>
void readNamed(Reader& reader, const std::string& name, const Use& use) {
  for (const std::string& text : reader.read(name, std::vector<std::string>{})) {
    const auto named = simulator::parseNamedNumbers(text);
    if (!named)
      return reader.complain(name, "holds what is not usable: " + named.error(), "a list of such texts");
    use(named->first, named->second);
  }
}

void readProject(Reader& reader, simulator::Settings& settings) {
  readNamed(reader, "bases",
            [&](const auto& base, const auto& six) { settings.bases[base] = arm::toPose(six); });
  readNamed(reader, "tcps", [&](const auto& tcp, const auto& six) { settings.tcps[tcp] = arm::toPose(six); });
  readNamed(reader, "points",
            [&](const auto& point, const auto& six) { settings.points[point] = arm::toJointVector(six); });
}

simulator::Settings readSettings(Reader& reader) {
  constexpr double kLongestWait = 86400.0;  // [s]
  simulator::Settings settings;
  settings.listen_node_message = reader.read<std::string>("listen_node", settings.listen_node_message);
  settings.connection_timeout =
      reader.readSeconds("connection_timeout", settings.connection_timeout, 0, kLongestWait);
  settings.data_timeout = reader.readSeconds("data_timeout", settings.data_timeout, 0, kLongestWait);
  const Duration reentry = reader.readSeconds("reentry_delay", *settings.reentry_delay, -1, kLongestWait);
  settings.reentry_delay = reentry < Duration::zero() ? std::nullopt : std::optional(reentry);
  settings.project_running = reader.read("project_running", settings.project_running);
  settings.project_speed_percent =
      reader.readInRange("project_speed", settings.project_speed_percent, 5, 100);
  settings.checks_payload = reader.read("checks_payload", settings.checks_payload);
  settings.velocity_licence = reader.read("velocity_licence", settings.velocity_licence);
  settings.faults.stale_tag.on = reader.read("reports_stale_tags", false);
  readProject(reader, settings);
  readStatusPort(reader, settings);
  const auto start = reader.read("start_posture_deg", std::vector<double>{});
  if (start.size() == arm::kJointCount) {
    arm::ControllerJoints joints{};
    std::copy(start.begin(), start.end(), joints.begin());
    settings.start_posture = arm::toJointVector(joints);
  } else if (!start.empty()) {
    reader.complain("start_posture_deg", fmt::format("has {} values", start.size()),
                    "six joint angles [deg]");
  }
  return settings;
}

}  // namespace

Result<CommandParameters, ParameterError> readCommandParameters(const ros::NodeHandle& node,
                                                                const ros::NodeHandle& self) {
  Reader reader(self);
  CommandParameters parameters;
  parameters.arm = readArm(node, reader);
  parameters.prefix = reader.read<std::string>("prefix", "");
  parameters.robot_ip = reader.read<std::string>("robot_ip", "");
  parameters.script_port = reader.readInRange("script_port", parameters.script_port, 0, 65535);
  parameters.link = readLink(reader);
  readAnnouncedPorts(node, reader, parameters);
  parameters.auto_connect = reader.read("auto_connect", parameters.auto_connect);
  parameters.tf_from_start = reader.read("tf_from_start", parameters.tf_from_start);
  if (parameters.auto_connect && parameters.robot_ip.empty())
    reader.complain("robot_ip", "is empty", "the controller's address, as auto_connect is set");
  if (reader.error()) return refuse(*reader.error());
  return parameters;
}

Result<SimulatorParameters, ParameterError> readSimulatorParameters(const ros::NodeHandle& node,
                                                                    const ros::NodeHandle& self) {
  Reader reader(self);
  auto arm = readArm(node, reader);
  if (!arm)
    reader.complain("robot_model", "is missing", "a known model, or a robot_description to take it from");
  if (reader.error()) return refuse(*reader.error());
  SimulatorParameters parameters(std::move(*arm));
  parameters.prefix = reader.read<std::string>("prefix", "");
  parameters.settings = readSettings(reader);
  parameters.bind_address = reader.read("bind_address", parameters.bind_address);
  parameters.script_port = reader.readInRange("script_port", parameters.script_port, 0, 65535);
  parameters.status_port = reader.readInRange("status_port", parameters.status_port, 0, 65535);
  parameters.time_scale = reader.readInRange("time_scale", parameters.time_scale, runtime::kSlowestTimeScale,
                                             runtime::kFastestTimeScale);
  parameters.log_traffic = reader.read("log_traffic", parameters.log_traffic);
  parameters.publish_rate = reader.readInRange("publish_rate", parameters.publish_rate, 0.1, 1000.0);
  if (const int outside = parameters.arm.firstJointOutsideLimits(parameters.settings.start_posture);
      outside >= 0) {
    reader.complain("start_posture_deg", fmt::format("puts joint {} outside its limits", outside + 1),
                    "a posture of " + parameters.arm.name());
  }
  if (reader.error()) return refuse(*reader.error());
  return parameters;
}

}  // namespace cobot_command::ros_adapter
