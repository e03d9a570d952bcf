// The settings of the simulated controller, a row each: parameters, options and pages are made of them.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "settings_text.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/joint_range.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/common/units.h"
#include "cobot_command/simulator/control_line.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

namespace {

using namespace setting_kinds;
using Six = std::array<double, 6>;
using Found = std::optional<std::string>;

constexpr double kLongestWait = 86400;     // [s]
constexpr double kLongestStopTime = 60;    // [s]
constexpr double kLongestLag = 10;         // [s]
constexpr std::size_t kLongestName = 128;  // as for the item Project_Name

SettingKind projectSpeed(int& percent) {
  SettingKind kind = whole(percent, 5, 100, "%");
  kind.range = "5 to 100 in steps of 5";
  kind.take = [take = std::move(kind.take)](const Given& given) -> Found {
    const auto* number = std::get_if<int>(&given.value);
    if (number != nullptr && *number % 5 != 0) return isFound(given);
    return take(given);
  };
  return kind;
}

SettingKind sixNumbers(const char* type, const char* unit, const std::function<void(const Six&)>& take) {
  SettingKind kind;
  kind.form = SettingKind::Form::Numbers;
  kind.type = type;
  kind.unit = unit;
  kind.take = [take](const Given& given) -> Found {
    const auto* list = std::get_if<GivenList>(&given.value);
    Six numbers{};
    if (list == nullptr || list->size() != numbers.size()) return isFound(given);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto number = finiteIn((*list)[i]);
      if (!number) return "holds " + describe((*list)[i]);
      numbers.at(i) = *number;
    }
    take(numbers);
    return std::nullopt;
  };
  return kind;
}

SettingKind posture(arm::JointVector& joints) {
  SettingKind kind = sixNumbers("a list of six joint angles", "[deg]",
                                [&joints](const Six& angles) { joints = arm::toJointVector(angles); });
  kind.show = [&joints] { return fmt::format("{:.6g}", fmt::join(arm::toControllerJoints(joints), ", ")); };
  return kind;
}

SettingKind frame(arm::Pose& pose) {
  SettingKind kind = sixNumbers("a list of X, Y, Z, RX, RY, RZ", "[mm, deg]",
                                [&pose](const Six& six) { pose = arm::toPose(six); });
  kind.show = [&pose] { return fmt::format("{:.6g}", fmt::join(arm::toControllerPose(pose), ", ")); };
  return kind;
}

/// Launch files and rosparam make a number of 1.80.
SettingKind version(std::string& text) {
  SettingKind kind = setting_kinds::text(text, oneOf(knownTmflowVersions()));
  kind.take = [take = std::move(kind.take)](const Given& given) {
    const auto* number = std::get_if<double>(&given.value);
    return take(number == nullptr ? given : Given{fmt::format("{:.2f}", *number)});
  };
  return kind;
}

/// Texts NAME=..., each of which `add` puts into a new value, which takes the place of the old one.
template <class Value, class Add>
SettingKind list(Value& value, const std::string& type, Add add) {
  SettingKind kind;
  kind.form = SettingKind::Form::Texts;
  kind.type = type;
  kind.take = [&value, add](const Given& given) -> Found {
    const auto texts = textsIn(given);
    if (!texts) return texts.error();
    Value made{};
    for (const std::string& text : *texts) {
      if (auto found = add(made, text)) return found;
    }
    value = std::move(made);
    return std::nullopt;
  };
  kind.show = [] { return std::string("none"); };
  return kind;
}

/// `built_in` is the name that no project can define.
template <class Value, class Convert>
SettingKind namedSixes(std::map<std::string, Value>& values, const std::string& type,
                       const std::string& built_in, Convert convert) {
  return list(values, type, [built_in, convert](std::map<std::string, Value>& made, const std::string& text) {
    const auto named = parseNamedNumbers(text);
    if (!named) return Found(named.error());
    if (named->first == built_in) return Found("names " + built_in + ", which every project has");
    const bool is_new = made.emplace(named->first, convert(named->second)).second;
    return is_new ? Found() : Found("names " + quoted(named->first) + " twice");
  });
}

SettingKind poses(std::map<std::string, arm::Pose>& values, const std::string& built_in) {
  return namedSixes(values, "a list of texts NAME=X,Y,Z,RX,RY,RZ [mm, deg]", built_in,
                    [](const Six& six) { return arm::toPose(six); });
}

SettingKind postures(std::map<std::string, arm::JointVector>& values) {
  return namedSixes(values, "a list of texts NAME=J1,J2,J3,J4,J5,J6 [deg]", "",
                    [](const Six& six) { return arm::toJointVector(six); });
}

/// Written so that NaN is refused as well.
bool isSane(const arm::JointRange& range) {
  return std::abs(range.lower) <= arm::kMaxCoordinate && std::abs(range.upper) <= arm::kMaxCoordinate &&
         range.lower < range.upper;
}

SettingKind safetyLimits(std::map<std::size_t, arm::JointLimit>& values) {
  using Limits = std::map<std::size_t, arm::JointLimit>;
  return list(values, arm::kJointRangesAllowed, [](Limits& made, const std::string& text) {
    const auto range = arm::parseJointRange(text);
    if (!range || !isSane(*range)) return Found("holds " + quoted(text));
    arm::JointLimit limit;
    limit.lower = degToRad(range->lower);
    limit.upper = degToRad(range->upper);
    const bool is_new = made.emplace(range->joint - 1, limit).second;
    return is_new ? Found() : Found(fmt::format("names joint {} twice", range->joint));
  });
}

SettingKind declarations(std::vector<std::string>& values) {
  return list(values, "a list of declarations", [](std::vector<std::string>& made, const std::string& text) {
    made.push_back(text);
    return Found();
  });
}

SettingKind switches(FaultSwitches& values) {
  return list(values, "a list of texts NAME [COUNT [VALUE]]",
              [](FaultSwitches& made, const std::string& text) {
                const auto order = parseFault(text);
                const OperatorReply reply = order ? set(made, *order) : OperatorReply{false, order.error()};
                return reply.done ? Found() : Found("holds " + quoted(text) + ": " + reply.text);
              });
}

SettingKind streamItems(std::vector<std::string>& names) {
  const auto read = [](const std::string& text) -> Result<std::vector<std::string>, std::string> {
    std::vector<std::string> found = parseNames(text);
    if (found.empty()) return refuse(std::string("names no item"));
    return found;
  };
  return written<std::vector<std::string>>(
      names, "names, separated by commas", read,
      [](const std::vector<std::string>&) { return std::string("see the status port"); });
}

SettingKind writeClients(WriteClients& clients) {
  return written<WriteClients>(clients, "all, none, or addresses such as 192.168.1.7, separated by commas",
                               parseWriteClients, [](const WriteClients& shown) {
                                 return shown ? fmt::format("{}", fmt::join(*shown, ","))
                                              : std::string("all");
                               });
}

SettingTable projectTable(Settings& s) {
  return {
      {"project_running", flag(s.project_running), "the project runs at the start"},
      {"project_name", text(s.project_name, name(kLongestName)),
       "name of the project; an item of the status port"},
      {"project_speed", projectSpeed(s.project_speed_percent), "project speed; slows every motion"},
      {"project_speed_live", flag(s.project_speed_live),
       "a change of the project speed also applies to the running motion"},
      {"start_posture_deg", posture(s.start_posture), "posture at the start, within the limits of the model"},
      {"start_tcp", frame(s.start_tcp), "TCP that is active when the project starts, relative to the flange"},
      {"listen_node", text(s.listen_node_message, name(kLongestName)), "entry message of the Listen node"},
      {"connection_timeout", seconds(s.connection_timeout, 0, kLongestWait),
       "the Listen node is left if no client connects for this time; 0: never"},
      {"data_timeout", seconds(s.data_timeout, 0, kLongestWait),
       "the Listen node is left if no client sends anything for this time; 0: never"},
      {"reentry_delay", secondsOrNever(s.reentry_delay, 0, kLongestWait),
       "time between leaving the Listen node and entering it again"},
      {"tmflow_version", version(s.tmflow_version), "determines the available functions and items"},
      {"bases", poses(s.bases, script::kRobotBase), "bases of the project, in addition to RobotBase", "base"},
      {"tcps", poses(s.tcps, script::kNoTool), "TCPs of the project, in addition to NOTOOL and HandCamera",
       "tcp"},
      {"points", postures(s.points), "points of the project, within the limits of the model", "point"},
      {"variables", declarations(s.variables),
       "variables of the project, as `int var_i = 5`: scripts can use all of them, the status port those in "
       "the stream; a variable whose name begins with g_ keeps its value when the project ends",
       "variable"},
  };
}

SettingTable controllerTable(Settings& s) {
  const Words<MotionErrorPolicy> policies{{"report_false", MotionErrorPolicy::ReportFalse},
                                          {"stop_project", MotionErrorPolicy::StopProject}};
  return {
      {"stop_time", seconds(s.stop_time, 0, kLongestStopTime),
       "time to slow down from full speed to standstill on the path at a pause or stop, and to speed up "
       "again"},
      {"pvt_lag", seconds(s.pvt_lag, 0, kLongestLag),
       "delay of the arm during a PVT; the reported end and tags are not delayed"},
      {"safeguard_resets_itself", flag(s.safeguard_resets_itself),
       "true: the arm continues when the safeguard is closed; false: the project is then paused"},
      {"on_motion_error", choice(s.on_motion_error, policies),
       "reaction of the project to a motion that cannot be executed"},
      {"checks_payload", flag(s.checks_payload),
       "a motion fails if tool and load are heavier than the payload of the model", "any-payload"},
      {"accept_zero_ramp", flag(s.accept_zero_ramp),
       "true: a time to top speed of 0 means the shortest ramp of the arm; false: such a motion fails"},
      {"safety_limits", safetyLimits(s.safety_limits),
       "joint limits that Safety_Joint_Angle_Min and Safety_Joint_Angle_Max report; for other joints the "
       "limits of the model",
       "safety-limit"},
      {"turn_speed", realIn(s.turn_speed, 1, 3600, "deg/s", radToDeg(1)),
       "rotation speed of the TCP at 100 % on lines and circles; must be the same in the command node, "
       "otherwise the plans of the command node are wrong"},
      {"joint_noise", realIn(s.joint_noise, 0, 10, "deg", radToDeg(1)),
       "standard deviation of the reported joint angles"},
      {"speed_noise", realIn(s.speed_noise, 0, 100, "deg/s", radToDeg(1)),
       "standard deviation of the reported speeds"},
      {"torque_noise", real(s.torque_noise, 0, 1000, "Nm"), "standard deviation of the reported torques"},
      {"force_noise", real(s.force_noise, 0, 1000, "N"), "standard deviation of the reported forces"},
      {"noise_seed", whole(s.noise_seed, 0, 1000000), "the same seed gives the same noise in every run"},
      {"velocity_licence", flag(s.velocity_licence),
       "the functions of continuous velocities (ContinueVJog, ContinueVLine), which require a licence, are "
       "available"},
      {"accept_empty_length", flag(s.accept_empty_length),
       "frames without a length are accepted; some bridges send them"},
  };
}

SettingTable statusPortTable(Settings& s) {
  using protocol::ItemFormat;
  const Words<ItemFormat> formats{
      {"binary", ItemFormat::Binary}, {"string", ItemFormat::String}, {"json", ItemFormat::Json}};
  return {
      {"status_period", seconds(s.status_period, 0.001, 1), "period of the status stream"},
      {"stream_format", choice(s.stream_format, formats), "format of the status stream"},
      {"stream_items", streamItems(s.stream_items),
       "items and variables of the status stream, in this order"},
      {"write_clients", writeClients(s.write_clients), "clients that can write items"},
  };
}

SettingTable faultTable(Settings& s) {
  return {
      {"faults", switches(s.faults), "faults that are on from the start", "fault"},
  };
}

}  // namespace

SettingTable settingsTable(Settings& settings) {
  return joined(
      {projectTable(settings), controllerTable(settings), statusPortTable(settings), faultTable(settings)});
}

}  // namespace cobot_command::simulator
