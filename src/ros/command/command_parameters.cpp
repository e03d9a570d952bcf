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
  return {fmt::format("a host name or address without blanks, of at most {} characters", kMaxHostLength),
          isHostName};
}

TextRule frameName() {
  return {"the name of a tf frame, without a leading slash", [](const std::string& name) {
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
    return SettingFault{"status_port", fmt::format("is {}, the same as script_port", p.link.status_port),
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
    return SettingFault{"robot_ip", "is empty", "the controller's address, because auto_connect is set"};
  }
  if (has_ports && p.script_port == 0) {
    return SettingFault{"script_port", "is 0", "the controller's port, because auto_connect is set"};
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
  return {"simulated_controller", fmt::format("is {}, which published no ports {}", controller, how_long),
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
    if (given_up()) return untold(controller, "before the shutdown");
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
      {"robot_ip", text(p.robot_ip, orEmpty(hostName())), "host for connect goals that name none"},
      {"script_port", port(p.script_port), "port for connect goals that name none"},
      {"status_port", port(p.link.status_port), "port of the status stream; 0: none"},
      robotModelRow(p.robot_model),
      prefixRow(p.prefix),
      {"turn_speed", realIn(p.turn_speed, 1, 3600, "deg/s", radToDeg(1)),
       "rotation speed of the TCP at 100 % on lines and circles; used for planning"},
  };
}

SettingTable deadlineTable(link::LinkSettings& l) {
  return {
      {"open_timeout", seconds(l.open_timeout, 0.1, 60), "timeout of one connection attempt"},
      {"retry_min", seconds(l.retry_min, 0.01, 60),
       "pause between the first two attempts; it doubles after each attempt"},
      {"retry_max", seconds(l.retry_max, 0.01, 60), "longest pause between two attempts"},
      {"reply_timeout", seconds(l.reply_timeout, 0.05, 60), "timeout of the controller's answers"},
      {"supervision_period", seconds(l.supervision_period, 0.05, 60), "interval of the heartbeats"},
      {"supervision_misses", whole(l.supervision_misses, 1, 100),
       "number of unanswered heartbeats after which the link counts as lost"},
      {"status_timeout", seconds(l.status_timeout, 0.1, 60),
       "the status link is opened again after this time without a status frame"},
      {"tag_deadline_factor", real(l.tag_deadline_factor, 1, 100),
       "a motion's queue tag is due after planned time x this + margin"},
      {"tag_deadline_margin", seconds(l.tag_deadline_margin, 0.1, 3600),
       "margin in the deadline of a motion's queue tag"},
      {"unplanned_motion_timeout", seconds(l.unplanned_motion_timeout, 1, 86400),
       "deadline of the queue tag of a motion that could not be planned"},
      {"planning_budget", seconds(l.planning_budget, 0.01, 3600),
       "time limit of planning (a check, a whole cycle, a move or a script before it is sent); the goal ends "
       "with 16#20C when it is exceeded; only other plans wait meanwhile"},
      {"stop_timeout", seconds(l.stop_timeout, 0.1, 60), "time limit from an accepted stop to standstill"},
      {"evidence_timeout", seconds(l.evidence_timeout, 0.05, 10),
       "from a queue tag until the status stream shows the robot at standstill at the target (16#226); also "
       "the time to wait for the reason of a failure"},
      {"position_tolerance", real(l.position_tolerance, 1e-5, 1, "m"),
       "allowed distance of the tool from a Cartesian target when the status stream is compared with it "
       "(`~evidence_timeout`)"},
      {"angle_tolerance", real(l.angle_tolerance, 1e-5, 1, "rad"),
       "allowed difference of each joint angle, and of the orientation of the tool, from the target"},
  };
}

SettingTable pathTable(link::LinkSettings& l) {
  return {
      {"path_in_manual_mode", flag(l.path.in_manual_mode),
       "load_path also accepts goals while the status stream shows manual mode, which the LoadPath manual "
       "does not allow"},
      {"path_buffer", whole(l.path.buffer, 1, 14),
       "load_path: number of buffered points in addition to the active point"},
      {"path_chain_wait", seconds(l.path.chain_wait, 0, 10),
       "waiting time for the next path after a path that ends with a blend; then the path is sent with a "
       "stop at its end"},
      {"pvt_segment", seconds(l.path.segment, 0.025, 0.1),
       "shortest time between two points of a PVT; whole ms"},
      {"pvt_block_points", whole(l.path.block_points, 100, 6000),
       "maximum number of points of one PVT, from stop to stop (16#277)"},
  };
}

SettingTable jogTable(link::LinkSettings& l) {
  using Line = VelocityModes::Line;
  const Words<Line> units{{"off", Line::Off}, {"mm", Line::Millimetres}, {"m", Line::Metres}};
  return {
      {"velocity_line", choice(l.velocities.line, units),
       "`jog`: how the TCP is jogged. off: by short moves. mm, m: by velocities, if the controller has the "
       "licence for them; it is assumed to read them in mm/s and deg/s, or in m/s and rad/s. Sources "
       "disagree on the unit: with the wrong one the arm is 1000 times too fast, or hardly moves; "
       "doc/actions/jog.md"},
      {"velocity_joints", flag(l.velocities.joints),
       "`jog`: true: joints are jogged by velocities, in deg/s. **If this node or its link fails, nothing "
       "stops them**"},
      {"jog_stop_time", seconds(l.jog_stop_time, 0.05, 0.2),
       "`jog`: time that the controller needs to stop the arm from a velocity. A keep-alive can be late by "
       "0.25 s - 0.02 s - this time"},
  };
}

SettingTable behaviourTable(CommandParameters& p) {
  return {
      {"auto_connect", flag(p.auto_connect),
       "connects automatically and keeps the link. A connect goal takes the link over. If that goal fails or "
       "loses its link, the node's own connection is restored; if it is cancelled, there is no link until "
       "the next connect goal. Commands that were running are not resumed"},
      {"auto_reconnect", flag(p.link.auto_reconnect),
       "a connect goal whose link is lost stays active and reconnects"},
      {"stop_orphaned_motion", flag(p.link.stop_orphaned_motion),
       "when a link is established, the robot is stopped if it still moves or is paused by a pause or a "
       "safeguard, even if another command node moves it: starting a second node stops the robot of the "
       "first. False: the robot is not stopped, and nothing is sent until it is at standstill; for several "
       "clients of one controller"},
      {"world_frame", text(p.world_frame, frameName()),
       "tf frame of `load_path` poses in WORLD; looked up when a goal is received"},
      {"simulated_controller", text(p.simulated_controller, orEmpty(nodeName())),
       "node whose `~listening` ports are used; for ports that the simulator chose itself"},
      {"diagnostic_period", real(p.diagnostic_period, 0.1, 3600, "s"), "period of `/diagnostics`"},
      {"tf_from_start", flag(p.tf_from_start),
       "false: subscribes to tf only from the first goal with a frame; for fleets, where every robot's tf "
       "reaches every node"},
  };
}

SettingTable exchangeTable(command::ExchangeRules& rules) {
  SettingTable rows = {
      {"require_exchange_configuration", flag(rules.required),
       "motions are refused (16#8C05) while no `exchange_configuration` goal is enabled; the robot is "
       "stopped "
       "when it is disabled"},
      {"sync_period", seconds(rules.sync_period, 0.1, 60),
       "interval at which the tools, frames and loads of the controller's project are compared while "
       "`exchange_configuration` is enabled"},
  };
  const auto add = [&rows](const std::string& set, command::SyncModes& modes) {
    rows.push_back({fmt::format("sync/{}/start", set), whole(modes.start, 0, 2),
                    fmt::format("which {} take precedence if they differ when the interface is enabled: 0 "
                                "neither, 1 those of this layer, 2 those of the controller",
                                set)});
    rows.push_back(
        {fmt::format("sync/{}/run", set), whole(modes.run, 0, 3),
         fmt::format(
             "which {} take precedence after the start: 0 to 2 as for the start, 3 those that changed last",
             set)});
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
    fault = SettingFault{"status_port", fmt::format("is {}, the same as script_port", parameters.script_port),
                         "another port"};
  }
  if (!fault) return std::nullopt;
  return SettingFault{"simulated_controller",
                      fmt::format("is {}, whose listening/{} {}", parameters.simulated_controller,
                                  fault->setting, fault->found),
                      fault->allowed + "; delete the parameters that another node has left there"};
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
