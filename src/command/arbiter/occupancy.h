// What the robot is busy with: what a goal that comes has to wait for, what speaks against it, and where it
// would start.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arbiter/core_parts.h"
#include "arbiter/stop_desk.h"
#include "queue/goal_queue.h"
#include "runs/command_window.h"
#include "sending/set_aside.h"

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::command {

class Occupancy {
 public:
  /// `run`: whose turn it is. All have to live longer. `frames`: see CommandCore.
  Occupancy(const CoreParts& parts, const GoalQueue& queue, const StopDesk& stops,
            const CommandWindow& window, const SetAside& aside, const std::unique_ptr<blocks::Run>& run,
            blocks::FrameFinder frames)
      : parts_(parts),
        queue_(queue),
        stops_(stops),
        window_(window),
        aside_(aside),
        run_(run),
        frames_(std::move(frames)) {}

  /// What a command would have to wait for; nothing: it would not.
  [[nodiscard]] std::optional<blocks::Block> busyWith() const;
  /// The end of the chain that a goal of that block would join now; none: it would not.
  [[nodiscard]] blocks::Detail chainFor(blocks::Block block) const;
  /// What a goal of that block does while others are busy: behind another one of its kind it joins its chain.
  [[nodiscard]] blocks::BufferMode modeOf(blocks::Block block, const blocks::GoalTraits& traits) const;

  /// Why no command may be taken now, whatever it is; in the order of general ids. `needs_automatic`: as in
  /// its traits.
  [[nodiscard]] std::vector<blocks::Failure> objectionsToAny(blocks::BufferMode mode,
                                                             bool needs_automatic) const;
  /// As its turn has come.
  [[nodiscard]] std::vector<blocks::Failure> objectionsTo(const Waiting& next) const;
  [[nodiscard]] std::optional<blocks::Failure> objectionTo(const blocks::Command& command) const;

  /// Where the goal with that ticket starts: behind all that is on the wire, and waits with an earlier one;
  /// nothing when nobody knows.
  [[nodiscard]] std::optional<Origin> originBehind(Ticket ticket, Instant now) const;
  /// Of what goes out now, behind what is at the controller.
  [[nodiscard]] Origin originNow(Instant now) const;

  /// It has to wait, though it would be its turn: by the speed override, or by the interface.
  [[nodiscard]] bool isHeldBack(const Waiting& next) const;
  /// A blended motion in front of it has to come to its end first, which nothing tells of yet.
  [[nodiscard]] bool hasToAwaitRest(const Waiting& next) const;
  /// As far as that is known: nothing of ours moves it, and nothing else that can be seen.
  [[nodiscard]] bool robotStands() const;

  /// For who waits there.
  [[nodiscard]] std::string textOfPlace(int place) const;

 private:
  /// Goals that nothing was sent of yet.
  [[nodiscard]] std::size_t waiting() const;

  CoreParts parts_;
  const GoalQueue& queue_;
  const StopDesk& stops_;
  const CommandWindow& window_;
  const SetAside& aside_;
  const std::unique_ptr<blocks::Run>& run_;
  blocks::FrameFinder frames_;
};

}  // namespace cobot_command::command
