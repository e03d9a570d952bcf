// Goals on their way from the action servers to the core.
//
// A goal with a target in a tf frame that tf does not know yet waits for the frame. A goal with a file waits
// until the file is read. Both wait only for a short time. Commands and checks received after such a goal
// wait too, so that the order is kept. When the queued commands in the core end, those that wait here end
// too: the core reports this (CommandsFell). The core begins none of them, even one that it gets before the
// intake is notified. A goal that is cancelled while it waits has ended. No clock: the time is passed in.
//
// Threads: submit() and advance() are called on one thread, cancel() and fall() on any. Messages are
// converted into goals without the lock, so that no cancel waits for that.
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

/// Creates the goal of a message. Frames and files that it names are looked up at the time of the call.
using GoalReader = std::function<blocks::Goal(const Lookups&)>;
struct IncomingGoal {
  blocks::GoalId id = 0;
  GoalReader read;
  /// True: the goal is covered by a cancel that was received before the receiver of cancels knew the goal.
  std::function<bool()> is_cancelled;
};
/// Time that a goal received now may wait for its frame.
using FramePatience = std::function<Duration()>;

/// Time that a goal may wait for its file. It is long enough for a share that hangs, and for 32 nodes that
/// search for their package at the same time, on two cores with cold disks: 1.4 s was measured for that.
inline constexpr Duration kFilePatience = std::chrono::seconds(5);

/// The files of goals; see GoalFiles.
struct FileSource {
  std::function<std::optional<FileAnswer>(blocks::GoalId, FileKind, const std::string& location)> find;
  std::function<void(blocks::GoalId)> forget;
};

class GoalIntake {
 public:
  struct Core {
    std::function<void(blocks::GoalId, blocks::Goal)> submit;
    std::function<void(blocks::GoalId id, blocks::GoalId newest)> cancel;
    /// Ends a goal that has not reached the core.
    std::function<void(blocks::Block, blocks::GoalId, blocks::Outcome)> end;
  };

  /// `world_frame`: see Lookups.
  GoalIntake(FrameLookup frames, FramePatience patience, FileSource files, Core core,
             std::string world_frame = "world");

  void submit(IncomingGoal goal, Instant now);
  /// `newest`: the newest goal that was received before the cancel.
  void cancel(blocks::GoalId id, blocks::GoalId newest);
  /// Ends the waiting commands that were received up to `newest`; checks continue to wait. Returns the number
  /// of ended goals.
  int fall(blocks::GoalId newest, const std::string& why);
  /// Submits the goals that need not wait any more. Call it regularly while isWaiting().
  void advance(Instant now);
  [[nodiscard]] bool isWaiting() const;

 private:
  struct Reading {
    blocks::Goal goal;
    bool has_frames = true;  ///< every frame was found
    bool has_file = true;    ///< the file was read, or is unreadable
  };
  struct Waiting {
    blocks::Block block;
    blocks::GoalId id;
    GoalReader read;
    Instant frames_by;
    Instant file_by;
    bool falls;  ///< ends together with the commands before it
  };

  struct Ended {
    blocks::Block block;
    blocks::GoalId id;
    blocks::Outcome outcome;
  };

  [[nodiscard]] Reading readNow(blocks::GoalId id, const GoalReader& read) const;
  [[nodiscard]] std::optional<Waiting> front() const;
  // Call these with the lock.
  [[nodiscard]] std::optional<Ended> place(IncomingGoal& incoming, Reading& reading, Instant now);
  void handOn(blocks::GoalId id, blocks::Goal goal);
  [[nodiscard]] std::optional<Ended> takeCancelled(blocks::GoalId id);
  // Call it without the lock.
  void end(Ended ended);

  const FrameLookup frames_;
  const FramePatience patience_;
  const FileSource files_;
  const Core core_;
  const std::string world_frame_;
  mutable std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::optional<blocks::GoalId> incoming_;  ///< goal that is being read, and is in no queue yet
  bool incoming_is_cancelled_ = false;
  blocks::GoalId fell_until_ = 0;  ///< the newest goal that has ended with others
  std::string fell_why_;
};

}  // namespace cobot_command::ros_adapter
