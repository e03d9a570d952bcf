#include "cobot_command/ros/command/command_parameters.h"

#include <utility>

#include "dynamics/limit_parameters.h"
#include <fmt/format.h>
#include <ros/console.h>
#include <ros/names.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/host_name.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/common/units.h"

namespace cobot_command::ros_adapter {
namespace {

using namespace setting_kinds;

constexpr double kAnnouncementTimeout = 30;  // [s]; a node starts in far less
constexpr double kAnnouncementRetry = 0.05;  // [s]

TextRule hostName() {
  return {fmt::format("a host without blanks, of at most {} characters", kMaxHostLength), isHostName};
}

TextRule frameName() {
  return {"a name of a tf frame, without a slash in front", [](const std::string& name) {
            return !name.empty() && name.front() != '/' && name.find(' ') == std::string::npos;
          }};
}

TextRule nodeName() {
  return {"the name of a node", [](const std::string& name) {
            std::string reason;
            return ros::names::validate(name, reason) && name.find('~') == std::string::npos;
          }};
}

/// What does not fit together.
std::optional<SettingFault> faultIn(const CommandParameters& p) {
  const bool has_ports = p.simulated_controller.empty();
  if (has_ports && p.script_port != 0 && p.script_port == p.link.status_port) {
    return SettingFault{"status_port", fmt::format("is {}, which script_port is, too", p.link.status_port),
                        "the port of the status stream, usually 5891, or 0 for none"};
  }
  if (p.link.retry_min > p.link.retry_max) {
    return SettingFault{"retry_min",
                        fmt::format("is {} s, more than retry_max, which is {} s",
                                    toSeconds(p.link.retry_min), toSeconds(p.link.retry_max)),
                        "at most retry_max"};
  }
  if (const auto fault = faultIn(p.cell)) return fault;
  if (!p.auto_connect) return std::nullopt;
  if (p.robot_ip.empty()) {
    return SettingFault{"robot_ip", "is empty", "the controller's address, as auto_connect is set"};
  }
  if (has_ports && p.script_port == 0) {
    return SettingFault{"script_port", "is 0", "the controller's port, as auto_connect is set"};
  }
  return std::nullopt;
}

/// What the node `controller` says of its ports, as soon as it has told of both.
std::optional<GivenValues> announcedPorts(const ros::NodeHandle& node, const std::string& controller) {
  GivenValues told;
  for (const char* name : {"script_port", "status_port"}) {
    XmlRpc::XmlRpcValue value;
    if (!node.getParam(controller + "/listening/" + name, value)) return std::nullopt;
    told.emplace(name, toGiven(value));
  }
  return told;
}

SettingFault untold(const std::string& controller, const std::string& how_long) {
  return {"simulated_controller", fmt::format("is {}, which has told no ports {}", controller, how_long),
          "the name of a running simulated_controller_node, or empty"};
}

/// The ports of ~simulated_controller, if that is given, in place of ~script_port and ~status_port.
std::optional<SettingFault> takeAnnouncedPorts(const ros::NodeHandle& node, CommandParameters& parameters,
                                               const std::function<bool()>& given_up) {
  const std::string& controller = parameters.simulated_controller;
  if (controller.empty()) return std::nullopt;
  const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(kAnnouncementTimeout);
  auto ports = announcedPorts(node, controller);
  if (!ports) ROS_INFO_STREAM("waiting for the ports of " << forPeople(controller));
  while (!ports) {
    if (given_up()) return untold(controller, "before the end was asked for");
    if (ros::SteadyTime::now() > deadline) {
      return untold(controller, fmt::format("within {} s", kAnnouncementTimeout));
    }
    ros::WallDuration(kAnnouncementRetry).sleep();
    ports = announcedPorts(node, controller);
  }
  return takeAnnounced(*ports, parameters);
}

SettingTable robotTable(CommandParameters& p) {
  return {
      {"robot_ip", text(p.robot_ip, orEmpty(hostName())), "host for Connect goals without one"},
      {"script_port", port(p.script_port), "port for Connect goals without one"},
      {"status_port", port(p.link.status_port), "port of the status stream; 0: none"},
      robotModelRow(p.robot_model),
      prefixRow(p.prefix),
      {"turn_speed", realIn(p.turn_speed, 1, 3600, "deg/s", radToDeg(1)),
       "of the TCP at 100 % on lines and circles, for planning"},
  };
}

SettingTable deadlineTable(link::LinkSettings& l) {
  return {
      {"open_timeout", seconds(l.open_timeout, 0.1, 60), "one try to connect"},
      {"retry_min", seconds(l.retry_min, 0.01, 60),
       "pause between the first two tries; it doubles from there"},
      {"retry_max", seconds(l.retry_max, 0.01, 60), "longest pause between two tries"},
      {"reply_timeout", seconds(l.reply_timeout, 0.05, 60), "for the controller's answers"},
      {"supervision_period", seconds(l.supervision_period, 0.05, 60), "between two lifesigns"},
      {"supervision_misses", whole(l.supervision_misses, 1, 100),
       "lifesigns without an answer until the link counts as lost"},
      {"status_timeout", seconds(l.status_timeout, 0.1, 60),
       "without a status frame the status link is opened again"},
      {"tag_deadline_factor", real(l.tag_deadline_factor, 1, 100),
       "a motion's tag is due after planned time x this + margin"},
      {"tag_deadline_margin", seconds(l.tag_deadline_margin, 0.1, 3600), "the margin"},
      {"unplanned_motion_timeout", seconds(l.unplanned_motion_timeout, 1, 86400),
       "the same, when the motion could not be planned"},
      {"planning_budget", seconds(l.planning_budget, 0.01, 3600),
       "for a plan: of a check, of a whole cycle, of a move or a script before it is sent, which ends with "
       "16#20C then; only other plans wait for it"},
      {"stop_timeout", seconds(l.stop_timeout, 0.1, 60), "from an accepted stop until the robot stands"},
      {"evidence_timeout", seconds(l.evidence_timeout, 0.05, 10),
       "behind a queue tag, until the status stream shows the robot standing at the target (16#226); and for "
       "the reason of a failure"},
      {"position_tolerance", real(l.position_tolerance, 1e-5, 1, "m"),
       "how far the tool may be from a Cartesian target then"},
      {"angle_tolerance", real(l.angle_tolerance, 1e-5, 1, "rad"),
       "the same for each joint, and for the orientation of the tool"},
  };
}

SettingTable pathTable(link::LinkSettings& l) {
  return {
      {"path_in_manual_mode", flag(l.path.in_manual_mode),
       "load_path takes goals also while the status stream shows the manual mode, which its manual refuses"},
      {"path_buffer", whole(l.path.buffer, 1, 14),
       "of load_path: places of the buffer beside the active point"},
      {"path_chain_wait", seconds(l.path.chain_wait, 0, 10),
       "so long a path that ends with a blend waits for the next one, before it is sent with a stop at its "
       "end"},
      {"pvt_segment", seconds(l.path.segment, 0.025, 0.1), "between two points of a PVT at least; whole ms"},
      {"pvt_block_points", whole(l.path.block_points, 100, 6000),
       "of one PVT at most: from stop to stop (16#277)"},
  };
}

SettingTable jogTable(link::LinkSettings& l) {
  using Line = VelocityModes::Line;
  const Words<Line> units{{"off", Line::Off}, {"mm", Line::Millimetres}, {"m", Line::Metres}};
  return {
      {"velocity_line", choice(l.velocities.line, units),
       "of `jog`: off: the TCP is jogged by short moves. mm, m: by velocities where the controller has a "
       "licence for them, which it is taken to read in mm/s and deg/s, or in m/s and rad/s. Sources do not "
       "agree on which: with the wrong one the arm is 1000 times too fast, or hardly moves; "
       "doc/actions/jog.md"},
      {"velocity_joints", flag(l.velocities.joints),
       "the same of joints, in deg/s. **When this node or its link dies, nobody stops them**"},
      {"jog_stop_time", seconds(l.jog_stop_time, 0.05, 0.2),
       "of `jog`: what the controller needs to bring the arm to rest from a velocity. The rest of 0.25 s, "
       "less "
       "0.02 s, is how late a keep-alive may be"},
  };
}

SettingTable behaviourTable(CommandParameters& p) {
  return {
      {"auto_connect", flag(p.auto_connect),
       "connects by itself and keeps the link. A connect goal takes it over: when that fails, or its link is "
       "lost, the node's own comes back; when it is cancelled, there is no link until the next connect goal. "
       "Nothing that was under way resumes"},
      {"auto_reconnect", flag(p.link.auto_reconnect),
       "a connect goal whose link is lost stays active and tries again"},
      {"stop_orphaned_motion", flag(p.link.stop_orphaned_motion),
       "a robot that still moves when a link is made, or that a pause or a safeguard holds, is stopped, also "
       "one that another command node moves: to start a second node stops the robot of the first. False: it "
       "is left alone, and nothing is sent before it stands; for several clients of one controller"},
      {"world_frame", text(p.world_frame, frameName()),
       "of tf, in which poses of `load_path` in WORLD are; looked up when a goal comes"},
      {"simulated_controller", text(p.simulated_controller, orEmpty(nodeName())),
       "node whose `~listening` ports are used, for ports that it was free to choose"},
      {"diagnostic_period", real(p.diagnostic_period, 0.1, 3600, "s"), "of `/diagnostics`"},
      {"tf_from_start", flag(p.tf_from_start),
       "false: listens to tf from the first goal with a frame on; for fleets, where everybody's tf goes to "
       "everybody"},
  };
}

SettingTable exchangeTable(command::ExchangeRules& rules) {
  SettingTable rows = {
      {"require_exchange_configuration", flag(rules.required),
       "motions are refused (16#8C05) while no `exchange_configuration` goal is enabled; the robot is "
       "stopped "
       "when it is disabled"},
      {"sync_period", seconds(rules.sync_period, 0.1, 60),
       "between two looks at the tools, frames and loads of the controller's project, while "
       "`exchange_configuration` is enabled"},
  };
  const auto add = [&rows](const std::string& set, command::SyncModes& modes) {
    rows.push_back({fmt::format("sync/{}/start", set), whole(modes.start, 0, 2),
                    fmt::format("who wins where {} differ when the interface is enabled: 0 nobody, 1 this "
                                "layer, 2 the controller",
                                set)});
    rows.push_back(
        {fmt::format("sync/{}/run", set), whole(modes.run, 0, 3), "and from then on; 3: who has changed it"});
  };
  add("tools", rules.sync.tools);
  add("frames", rules.sync.frames);
  add("loads", rules.sync.loads);
  return rows;
}

}  // namespace

SettingTable settingsTable(CommandParameters& parameters) {
  return joined({robotTable(parameters),
                 deadlineTable(parameters.link),
                 pathTable(parameters.link),
                 jogTable(parameters.link),
                 behaviourTable(parameters),
                 exchangeTable(parameters.exchange),
                 cellRows(parameters.cell),
                 tableRows(parameters.tables),
                 {limitsRow(parameters.limit_texts)}});
}

Result<CommandParameters, ParameterError> readCommandParameters(const GivenParameters& given) {
  CommandParameters parameters;
  const SettingTable table = settingsTable(parameters);
  auto fault = take(table, given.own);
  if (!fault) fault = faultIn(parameters);
  if (fault) return refuse(parameterError(given, *fault));
  parameters.warnings = warningsOfUnknown(given, table, {});
  auto arm = armOf({parameters.robot_model, parameters.prefix}, given.robot_description, parameters.warnings);
  if (!arm) return refuse(parameterError(given, arm.error()));
  if (*arm) parameters.arm = (*arm)->turning(parameters.turn_speed);
  fault = readTables(parameters.tables, parameters.arm ? &*parameters.arm : nullptr, parameters.warnings);
  const arm::ArmModel* const model = parameters.arm ? &*parameters.arm : nullptr;
  if (!fault) fault = readLimits(parameters.limit_texts, model, parameters.limits);
  if (fault) return refuse(parameterError(given, *fault));
  return parameters;
}

std::optional<SettingFault> takeAnnounced(const GivenValues& told, CommandParameters& parameters) {
  // Somebody listens there already: no 0 for any free one.
  const SettingTable table{{"script_port", whole(parameters.script_port, 1, 65535), ""},
                           {"status_port", whole(parameters.link.status_port, 1, 65535), ""}};
  auto fault = take(table, told);
  if (!fault && parameters.script_port == parameters.link.status_port) {
    fault =
        SettingFault{"status_port", fmt::format("is {}, which script_port is, too", parameters.script_port),
                     "a port of its own"};
  }
  if (!fault) return std::nullopt;
  return SettingFault{"simulated_controller",
                      fmt::format("is {}, whose listening/{} {}", parameters.simulated_controller,
                                  fault->setting, fault->found),
                      fault->allowed + "; delete what another node has left there"};
}

Result<CommandParameters, ParameterError> readCommandParameters(const ros::NodeHandle& node,
                                                                const ros::NodeHandle& self,
                                                                const std::function<bool()>& given_up) {
  const GivenParameters given = givenParameters(node, self);
  auto parameters = readCommandParameters(given);
  if (!parameters) return parameters;
  for (const std::string& warning : parameters->warnings) ROS_WARN_STREAM(forPeople(warning));
  if (const auto fault = takeAnnouncedPorts(node, *parameters, given_up)) {
    return refuse(parameterError(given, *fault));
  }
  return parameters;
}

}  // namespace cobot_command::ros_adapter
