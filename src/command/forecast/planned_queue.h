// What the controller is still to do, as it was planned: where it will leave the robot, and when.
#pragma once

#include <optional>

#include "forecast/plan.h"

#include "cobot_command/common/time.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/robot/stall_watch.h"

namespace cobot_command::command {

class PlannedQueue {
 public:
  /// A blended command was sent: the next one blends with it, or starts at its end.
  void queue(const std::optional<Plan>& plan, Instant now);
  /// The queue tag of a planned motion came back: the next one starts at its end, until the stream, which is
  /// always a little behind, shows the robot standing. `arm`: that it was planned with, if it was.
  void arrive(const std::optional<Plan>& plan, const arm::ArmModel* arm, Instant now);
  /// With each status frame: a controller in error has emptied its queue, and so has one whose robot stands
  /// on its way for so long, with nothing that holds it.
  void see(const robot::RobotWatch& robot, Duration patience, Instant now);
  /// Nothing is queued any more, or nobody knows.
  void forget() { queued_.reset(); }

  /// The robot is not seen to have come to the end of it yet.
  [[nodiscard]] bool isUnderWay(const robot::RobotWatch& robot, Instant now) const;
  /// `origin`, but for what is known better by the plan of what is queued. Precondition: isUnderWay().
  [[nodiscard]] Origin endFrom(Origin origin, Instant now) const;

 private:
  struct Queued {
    planning::ScriptPlanner planner;
    Instant began;
    robot::StallWatch stall = {};
    /// When the robot comes to its end, if nothing holds it.
    [[nodiscard]] Instant end() const { return began + planner.duration(); }
  };
  std::optional<Queued> queued_;
};

}  // namespace cobot_command::command
