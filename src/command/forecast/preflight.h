// Plans a command before a byte of it is sent: refused by name, or how long it will take.
#pragma once

#include <optional>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/robot/arrival.h"
#include "cobot_command/robot/frame_watch.h"
#include "cobot_command/robot/loose_motion.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/robot/stall_watch.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::command {

/// Where a command starts: what the robot and its frames will be then, as far as that is known.
struct Origin {
  planning::ScriptPlanner::Start start;
  std::optional<planning::ScriptPlanner> behind;  ///< of what is in front; it may blend into the command
  Duration arrival{};  ///< when the robot gets the command, by the time of `behind`
  /// Base and TCP were streamed or commanded, not only taken for those that a project starts with.
  bool frames_told = false;
};

struct Plan {
  Duration duration{};
  Duration start_delay{};                      ///< until its first motion begins, after it was sent
  Duration arrival{};                          ///< of the origin
  Origin end;                                  ///< where the next command starts
  std::optional<robot::Target> target;         ///< where its last motion leaves the robot, if that is certain
  arm::Pose tcp = arm::Pose::Identity();       ///< of the motions, in the flange [m]
  std::vector<motion::TrajectoryPtr> motions;  ///< of a command that moves: one, of a raw script: several
};

class Preflight {
 public:
  explicit Preflight(std::optional<arm::ArmModel> arm) : arm_(std::move(arm)) {}

  [[nodiscard]] const std::optional<arm::ArmModel>& arm() const { return arm_; }

  /// Where the robot stands, or where the blended motions in front will leave it; `loose`: also those that
  /// were not planned, which leave it nobody knows where.
  [[nodiscard]] Origin origin(const robot::RobotWatch& robot, const robot::FrameWatch& frames,
                              const robot::LooseMotion& loose, Instant now) const;

  /// No plan when the start or the effect of a command is not known.
  [[nodiscard]] static Result<std::optional<Plan>, blocks::Failure> planFor(
      const arm::ArmModel& arm, const std::vector<script::ScriptCommand>& commands, const Origin& origin);
  /// Nor without a model.
  [[nodiscard]] Result<std::optional<Plan>, blocks::Failure> plan(
      const std::vector<script::ScriptCommand>& commands, const Origin& origin) const;

  /// A blended command was sent: the next one blends with it, or starts at its end.
  void queue(const std::optional<Plan>& plan, Instant now);
  /// The queue tag of a planned motion came back: the next one starts at its end, until the stream, which is
  /// always a little behind, shows the robot standing.
  void arrive(const std::optional<Plan>& plan, Instant now);
  /// With each status frame: a controller in error has emptied its queue, and so has one whose robot stands
  /// on its way for so long, with nothing that holds it.
  void see(const robot::RobotWatch& robot, Duration patience, Instant now);
  /// Nothing is queued any more, or nobody knows.
  void forget() { queue_.reset(); }

 private:
  struct Queue {
    planning::ScriptPlanner planner;
    Instant began;
    robot::StallWatch stall = {};
    /// When the robot comes to its end, if nothing holds it.
    [[nodiscard]] Instant end() const { return began + planner.duration(); }
  };
  [[nodiscard]] bool isQueued(const robot::RobotWatch& robot, Instant now) const;
  [[nodiscard]] static std::optional<robot::Target> targetOf(
      const std::vector<script::ScriptCommand>& commands, const Plan& plan);

  std::optional<arm::ArmModel> arm_;
  std::optional<Queue> queue_;
};

/// Of a command that begins at `origin`, in the base `base`; no plan where either is not known, or the model
/// is not. Refused when it needs the base and that is not known.
[[nodiscard]] Result<std::optional<Plan>, blocks::Failure> planOfCommand(const blocks::Command& command,
                                                                         const arm::ArmModel* arm,
                                                                         const std::optional<arm::Pose>& base,
                                                                         const std::optional<Origin>& origin);

}  // namespace cobot_command::command
