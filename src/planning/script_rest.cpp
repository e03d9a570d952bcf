#include "cobot_command/planning/script_rest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/motion/way_left.h"

namespace cobot_command::planning {
namespace {

using script::DataFormat;
using script::ScriptCommand;

/// A circle through start, middle and end is well known as long as these do not meet [deg].
constexpr double kMostOfOneArc = 300;
constexpr double kPieceOfArc = 180;

template <class Command>
inline constexpr bool kMoves =
    std::is_same_v<Command, script::Ptp> || std::is_same_v<Command, script::Line> ||
    std::is_same_v<Command, script::Circle> || std::is_same_v<Command, script::MovePtp> ||
    std::is_same_v<Command, script::MoveLine> || std::is_same_v<Command, script::PLine> ||
    std::is_same_v<Command, script::MovePLine>;
template <class Command>
inline constexpr bool kWrites =
    std::is_same_v<Command, script::WriteOutput> || std::is_same_v<Command, script::WriteAnalogOutput>;
template <class Command>
inline constexpr bool kSets =
    std::is_same_v<Command, script::ChangeBase> || std::is_same_v<Command, script::ChangeTcp> ||
    std::is_same_v<Command, script::ChangeLoad>;

bool moves(const ScriptCommand& command) {
  return std::visit([](const auto& one) { return kMoves<std::decay_t<decltype(one)>>; }, command);
}

/// What is left of it is said as a target in the base, wherever it was.
bool needsFrames(const ScriptCommand& command) {
  return std::visit(
      Overloaded{
          [](const script::Circle&) { return true; }, [](const script::MoveLine&) { return true; },
          [](const script::MovePLine& move) { return move.format.target != DataFormat::Target::Joint; },
          [](const auto&) { return false; }},
      command);
}

bool mayBeResumed(const ScriptCommand& command, bool with_motions) {
  return std::visit(
      [with_motions](const auto& one) {
        using Command = std::decay_t<decltype(one)>;
        return kMoves<Command> || kWrites<Command> || (kSets<Command> && !with_motions);
      },
      command);
}

/// One motion that was planned, from a place on its way on.
class Rest {
 public:
  Rest(const motion::Trajectory& motion, Duration time, const ScriptPlanner::Start& frames,
       const arm::ArmModel& arm)
      : motion_(motion), time_(time), frames_(frames), arm_(arm) {}

  [[nodiscard]] std::vector<ScriptCommand> of(const ScriptCommand& command) const {
    return std::visit(Overloaded{[this](const script::Circle& circle) { return ofArc(circle); },
                                 [this](const auto& one) { return std::vector<ScriptCommand>{of(one)}; }},
                      command);
  }

 private:
  /// The posture that it would end in, whatever the one is that it begins in now.
  [[nodiscard]] ScriptCommand of(const script::Ptp& ptp) const { return toEnd(ptp.options); }
  [[nodiscard]] ScriptCommand of(const script::MovePtp& move) const { return toEnd(move.options); }
  [[nodiscard]] ScriptCommand of(const script::Line& line) const { return line; }
  [[nodiscard]] ScriptCommand of(const script::PLine& line) const { return line; }
  [[nodiscard]] ScriptCommand of(const script::MoveLine& move) const {
    return script::Line{absolute(move.format), poseAt(motion_.duration()), move.options};
  }
  [[nodiscard]] ScriptCommand of(const script::MovePLine& move) const {
    const bool by_joints = move.format.target == DataFormat::Target::Joint;
    const auto target =
        by_joints ? arm::toControllerJoints(motion_.end().position) : poseAt(motion_.duration());
    return script::PLine{by_joints ? move.format : absolute(move.format), target, move.options};
  }
  template <class Other>
  [[nodiscard]] ScriptCommand of(const Other& other) const {
    return other;
  }

  [[nodiscard]] std::vector<ScriptCommand> ofArc(const script::Circle& circle) const {
    const double angle = std::abs(circle.arc_angle) * (1.0 - motion_.progress(time_));
    if (angle < kPieceOfArc && isFlat()) {
      return {script::Line{circle.format, poseAt(motion_.duration()), circle.options}};
    }
    const int pieces = angle <= kMostOfOneArc ? 1 : static_cast<int>(std::ceil(angle / kPieceOfArc));
    std::vector<ScriptCommand> arcs;
    for (int i = 0; i < pieces; ++i) {
      script::Circle arc = circle;
      arc.arc_angle = 0;
      arc.via = poseAt(timeOf((2 * i + 1) / (2.0 * pieces)));
      arc.end = poseAt(timeOf((i + 1.0) / pieces));
      if (i + 1 < pieces) arc.options.blending = 0;
      arcs.emplace_back(arc);
    }
    return arcs;
  }

  [[nodiscard]] bool isFlat() const {
    return motion::isNextToStraight(tcpAt(time_).translation(), tcpAt(timeOf(0.5)).translation(),
                                    tcpAt(motion_.duration()).translation());
  }

  [[nodiscard]] ScriptCommand toEnd(const script::MotionOptions& options) const {
    script::Ptp ptp;
    ptp.format = {DataFormat::Target::Joint, DataFormat::Speed::Percent, DataFormat::Blending::Percent};
    ptp.target = arm::toControllerJoints(motion_.end().position);
    ptp.options = options;
    return ptp;
  }

  [[nodiscard]] static DataFormat absolute(DataFormat format) {
    format.target = DataFormat::Target::Cartesian;
    return format;
  }

  /// The TCP in the robot base.
  [[nodiscard]] arm::Pose tcpAt(Duration time) const {
    return arm::forwardKinematics(arm_, motion_.at(time).position) * *frames_.tcp;
  }
  /// The same in the active base.
  [[nodiscard]] script::SixNumbers poseAt(Duration time) const {
    return arm::toControllerPose(frames_.base->inverse() * tcpAt(time));
  }

  /// When that share of the way is done that is left.
  [[nodiscard]] Duration timeOf(double share) const { return motion::timeOfShareLeft(motion_, time_, share); }

  const motion::Trajectory& motion_;
  Duration time_;
  const ScriptPlanner::Start& frames_;
  const arm::ArmModel& arm_;
};

}  // namespace

std::optional<std::string> whyNotResumable(const PlannedLines& lines) {
  const auto& commands = lines.commands;
  const bool with_motions = std::any_of(commands.begin(), commands.end(), moves);
  for (const ScriptCommand& command : commands) {
    if (mayBeResumed(command, with_motions)) continue;
    return fmt::format("{} cannot be resumed on its path", script::toText(command));
  }
  const auto motions = std::count_if(commands.begin(), commands.end(), moves);
  if (static_cast<std::size_t>(motions) != lines.motions.size()) return "its path was not planned";
  const bool needs_frames = std::any_of(commands.begin(), commands.end(), needsFrames);
  if (needs_frames && !(lines.start.base && lines.start.tcp)) {
    return "its base or TCP is defined in the project, and its value is unknown";
  }
  return std::nullopt;
}

std::vector<ScriptCommand> restOf(const PlannedLines& lines, const PlaceOnLines& place,
                                  const arm::ArmModel& arm) {
  std::vector<ScriptCommand> rest;
  std::size_t motion = 0;
  bool is_reached = lines.motions.empty();
  for (const ScriptCommand& command : lines.commands) {
    const bool is_motion = moves(command);
    if (is_motion && motion++ == place.motion) {
      is_reached = true;
      const motion::Trajectory& made = *lines.motions[place.motion];
      if (place.time >= made.duration()) continue;
      for (ScriptCommand& left : Rest(made, place.time, lines.start, arm).of(command)) {
        rest.push_back(std::move(left));
      }
    } else if (is_reached) {
      rest.push_back(command);
    }
  }
  return rest;
}

}  // namespace cobot_command::planning
