#include "agent/frame_gate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

using blocks::Failure;
namespace own_error = blocks::own_error;

namespace {

constexpr Duration kOldestStatus = std::chrono::milliseconds(200);
constexpr double kSamePlace = 1e-4;       ///< of bases and TCPs [m]
const double kSameTurn = degToRad(0.01);  ///< of bases and TCPs [rad]

bool isSame(const arm::Pose& a, const arm::Pose& b) {
  const double turn = Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
  return (a.translation() - b.translation()).norm() <= kSamePlace && std::abs(turn) <= kSameTurn;
}

std::string anotherThanInTheProgram(const char* what, const arm::Pose& is, const arm::Pose& has) {
  const auto shown = [](const arm::Pose& pose) {
    return fmt::format("[{:.6g}]", fmt::join(arm::toControllerPose(pose), ", "));
  };
  return fmt::format("the {} differs from the one in the cell's program: {}, expected {}", what, shown(is),
                     shown(has));
}

}  // namespace

std::optional<std::string> objectionOf(const StateWatch& states, bool is_joined) {
  const RobotStatus* const mine = states.mine();
  if (mine == nullptr || !is_joined) return "the supervisor has not admitted the robot";
  if (states.mode() != SupervisorMode::Running) {
    return fmt::format("the supervisor is {}", toString(states.mode()));
  }
  const bool is_well = mine->state == RobotState::Ready || mine->state == RobotState::Moving ||
                       mine->state == RobotState::Waiting;
  if (!is_well) return fmt::format("the robot is {}: {}", toString(mine->state), mine->text);
  return std::nullopt;
}

std::optional<Failure> FrameGate::objectionTo(const command::Departure& departure, Instant now) const {
  const bool does_nothing = departure.lines.empty() && !departure.leaves_node;
  if (!departure.asks_permit) {
    if (does_nothing) return std::nullopt;
    return Failure{own_error::kOnlyPrograms,
                   fmt::format("this is robot {} of cell {}", artifact.program.robots[robot].name,
                               artifact.program.name),
                   ""};
  }
  if (const auto silent = states.objection(now)) return Failure{own_error::kSupervisorSilent, *silent, ""};
  if (const auto why = objectionOfState()) return Failure{own_error::kNotPermitted, *why, ""};
  const ArtifactFrame& frame = *permitted;
  if (departure.lines != frame.lines || departure.leaves_node) {
    return Failure{own_error::kNotInArtifact,
                   fmt::format("\"{}\" was about to be sent, but \"{}\" is permitted",
                               fmt::join(departure.lines, " "), fmt::join(frame.lines, " ")),
                   ""};
  }
  if (auto setting = objectionToSetting(departure, now)) return setting;
  return objectionToStart(departure);
}

std::optional<std::string> FrameGate::objectionOfState() const {
  if (permitted == nullptr || tracker == nullptr) return "no permit is open";
  return objectionOf(states, is_joined);
}

std::optional<Failure> FrameGate::objectionToSetting(const command::Departure& departure, Instant now) const {
  const auto differs = [](std::string what) {
    return Failure{own_error::kSettingDiffers, std::move(what), ""};
  };
  if (!measured_at || now - *measured_at > kOldestStatus) {
    return differs(measured_at
                       ? fmt::format("the robot's status is {:.1f} s old", toSeconds(now - *measured_at))
                       : "there is no status of the robot");
  }
  if (!watch.tellsTrouble()) {
    return differs(
        "the robot's status does not contain MA_Mode, Robot_Error and ESTOP: add them to its Ethernet Slave");
  }
  if (watch.manualMode()) return differs("the robot is in manual mode");
  if (watch.showsError() || watch.emergencyStop()) return differs("the robot has an error");
  const double allowed = artifact.parameters.speed_override;
  if (watch.speedOverride() > allowed + 1e-9) {
    return differs(
        fmt::format("the project speed is {:.0f} %, but the cell was verified for at most {:.0f} %",
                    100 * watch.speedOverride(), 100 * allowed));
  }
  const ArtifactFrame& frame = *permitted;
  if (!frame.start) return std::nullopt;
  if (!isSame(departure.tcp, frame.tcp)) {
    return differs(anotherThanInTheProgram("TCP", departure.tcp, frame.tcp));
  }
  if (departure.base && !isSame(*departure.base, frame.base)) {
    return differs(anotherThanInTheProgram("base", *departure.base, frame.base));
  }
  return std::nullopt;
}

std::optional<Failure> FrameGate::objectionToStart(const command::Departure& departure) const {
  const ArtifactFrame& frame = *permitted;
  if (!frame.start) return std::nullopt;
  const auto elsewhere = [](std::string what) {
    return Failure{own_error::kNotAtStepStart, std::move(what), ""};
  };
  if (!departure.planned || !departure.start) return elsewhere("the start position is unknown");
  const arm::JointVector& start = *departure.start;
  const motion::JointRange planned = tracker->resumesWithin().value_or(motion::JointRange::of(*frame.start));
  const arm::JointVector nearest = start.cwiseMax(planned.lower).cwiseMin(planned.upper);
  Eigen::Index joint = 0;
  const double off = (start - nearest).cwiseAbs().maxCoeff(&joint);
  if (off <= artifact.parameters.tracking) return std::nullopt;
  return elsewhere(fmt::format("joint {} would start {:.2f} deg off; allowed: {:.2f} deg", joint + 1,
                               radToDeg(off), radToDeg(artifact.parameters.tracking)));
}

}  // namespace cobot_command::cell
