// Goals on their way from the action servers to the core.
//
// A goal with a target in a tf frame that tf does not know yet waits for it, for a short time, and all that
// came behind it waits too, so that the order stays. A stop, or a cancel of one that waits, ends the waiting
// at once. Not thread-safe: ROS's spinner owns it. No clock: the time is handed in.
#pragma once

#include <deque>
#include <functional>

#include "cobot_command/blocks/goal.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/goal_messages.h"

namespace cobot_command::ros_adapter {

/// Makes the goal of a message, with the frames as they are known now.
using GoalReader = std::function<blocks::Goal(const FrameLookup&)>;
/// How long a goal that comes now waits for its frame.
using FramePatience = std::function<Duration()>;

class GoalIntake {
 public:
  struct Core {
    std::function<void(blocks::GoalId, blocks::Goal)> submit;
    std::function<void(blocks::GoalId)> cancel;
  };

  GoalIntake(FrameLookup frames, FramePatience patience, Core core);

  void submit(blocks::GoalId id, GoalReader read, Instant now);
  void cancel(blocks::GoalId id);
  /// Hands on what need not wait any more. To be called every now and then while isWaiting().
  void advance(Instant now);
  [[nodiscard]] bool isWaiting() const { return !waiting_.empty(); }

 private:
  struct Reading {
    blocks::Goal goal;
    bool complete = true;  ///< every frame was found
  };
  struct Waiting {
    blocks::GoalId id;
    GoalReader read;
    Instant deadline;
  };

  [[nodiscard]] Reading readNow(const GoalReader& read) const;
  /// Hands on all that wait, whether their frames are known or not: the core says what is missing.
  void flush();

  FrameLookup frames_;
  FramePatience patience_;
  Core core_;
  std::deque<Waiting> waiting_;
};

}  // namespace cobot_command::ros_adapter
