// Goals on their way from the action servers to the core.
//
// A goal with a target in a tf frame that tf does not know yet waits for it, one with a file until that is
// read, both for a short time; and the commands and checks that came behind it wait too, so that the order
// stays. What takes away the commands that wait in the core takes those that wait here, too: that is the
// core's to tell (CommandsFell), and it begins none of them even when it gets one before this is told. A goal
// that is cancelled while it waits has come to its end. No clock: the time is handed in.
//
// Threads: submit() and advance() are called by one, cancel() and fall() by any. Messages are made into goals
// without the lock, so that no cancel waits for that.
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

/// Makes the goal of a message, with what it names as that is known now.
using GoalReader = std::function<blocks::Goal(const Lookups&)>;
struct IncomingGoal {
  blocks::GoalId id = 0;
  GoalReader read;
  /// A cancel that was received already, before the goal was known to whom cancels go, covers it.
  std::function<bool()> is_cancelled;
};
/// How long a goal that comes now waits for its frame.
using FramePatience = std::function<Duration()>;

/// How long a goal waits for its file: for a share that hangs is long enough, and for 32 nodes that look for
/// their package at the same time, on two cores with cold disks, which was seen to take 1.4 s.
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
    /// Of a goal that ends before the core heard of it.
    std::function<void(blocks::Block, blocks::GoalId, blocks::Outcome)> end;
  };

  /// `world_frame`: see Lookups.
  GoalIntake(FrameLookup frames, FramePatience patience, FileSource files, Core core,
             std::string world_frame = "world");

  void submit(IncomingGoal goal, Instant now);
  /// `newest`: the newest goal that was received before the cancel.
  void cancel(blocks::GoalId id, blocks::GoalId newest);
  /// Ends the commands that wait and came until `newest`; checks wait on. Returns how many have ended.
  int fall(blocks::GoalId newest, const std::string& why);
  /// Hands on what need not wait any more. To be called every now and then while isWaiting().
  void advance(Instant now);
  [[nodiscard]] bool isWaiting() const;

 private:
  struct Reading {
    blocks::Goal goal;
    bool has_frames = true;  ///< every frame was found
    bool has_file = true;    ///< the file was read, or could not be
  };
  struct Waiting {
    blocks::Block block;
    blocks::GoalId id;
    GoalReader read;
    Instant frames_by;
    Instant file_by;
    bool falls;  ///< with the commands in front of it
  };

  struct Ended {
    blocks::Block block;
    blocks::GoalId id;
    blocks::Outcome outcome;
  };

  [[nodiscard]] Reading readNow(blocks::GoalId id, const GoalReader& read) const;
  [[nodiscard]] std::optional<Waiting> front() const;
  // With the lock.
  [[nodiscard]] std::optional<Ended> place(IncomingGoal& incoming, Reading& reading, Instant now);
  void handOn(blocks::GoalId id, blocks::Goal goal);
  [[nodiscard]] std::optional<Ended> takeCancelled(blocks::GoalId id);
  // Without it.
  void end(Ended ended);

  const FrameLookup frames_;
  const FramePatience patience_;
  const FileSource files_;
  const Core core_;
  const std::string world_frame_;
  mutable std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::optional<blocks::GoalId> incoming_;  ///< that is being read, and waits nowhere yet
  bool incoming_is_cancelled_ = false;
  blocks::GoalId fell_until_ = 0;  ///< the newest that has fallen
  std::string fell_why_;
};

}  // namespace cobot_command::ros_adapter
