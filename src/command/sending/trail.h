// What went out for goals since the robot stood last, as it lies in the controller's queue, and how far the
// robot is on it: by the joints of the status stream, which only ever go on. So what is left can be sent
// again when it was taken from the controller, also of blended motions, whose goals have ended long before.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "forecast/command_order.h"
#include "sending/left.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/common/time.h"
#include "cobot_command/planning/script_rest.h"
#include "cobot_command/robot/active_frames.h"

namespace cobot_command::command {

class Trail {
 public:
  /// Behind all that is on it; `frames`: those that it is taken in.
  void sent(const blocks::Command& command, const CommandOrder& order, const robot::ActiveFrames& frames);
  /// It has ended for its goal. With a tag: so is all in front of it, and it itself, for the robot, too.
  void ended(blocks::GoalId goal, blocks::CommandKey key, bool with_tag);
  /// The robot stands, and there is nothing left in the controller's queue.
  void clear() { *this = Trail(); }
  [[nodiscard]] bool empty() const { return steps_.empty(); }

  /// A status frame of now. `moves`: only then time has gone on for what the robot is at.
  void see(const arm::JointVector& joints, bool moves, Instant now);

  /// Why it could not be taken up again; nothing: it can.
  [[nodiscard]] std::optional<std::string> objection() const;
  /// From where the robot was seen last. Precondition: objection() is nothing.
  [[nodiscard]] std::deque<Left> left(const arm::ArmModel& arm) const;

 private:
  struct Step {
    blocks::Command command;
    blocks::GoalId goal = 0;
    bool ended = false;
    bool has_own_flow = false;  ///< it leaves the node, pauses, or lets go, by its own lines
    planning::PlannedLines lines;
    Instant since{};
  };
  [[nodiscard]] static Left leftOf(const Step& step, const planning::PlaceOnLines& place,
                                   const arm::ArmModel& arm);
  /// Of all motions on it, in their order.
  struct Place {
    std::size_t step = 0;
    planning::PlaceOnLines on_lines;
  };
  /// A place in front of the robot, as far as it may have come.
  struct Sample {
    Place place;
    Duration ahead{};  ///< by the plan
    double away = 0;   ///< of the joint that is furthest from there [rad]
    double step = 0;   ///< of it, from the sample before
  };
  [[nodiscard]] std::vector<Sample> samplesAhead(const arm::JointVector& joints, Duration most) const;
  [[nodiscard]] const motion::Trajectory* motionAt(const Place& place) const;
  /// The first motion from there on; its own one too. False: there is none.
  [[nodiscard]] bool goToMotion(Place& place) const;
  void drop(std::size_t steps);

  std::vector<Step> steps_;
  Place place_;
  std::optional<Instant> seen_at_;
};

}  // namespace cobot_command::command
