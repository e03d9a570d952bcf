// Stops the robot and empties its queue, whoever wants that: a cancel, a failed command, the stop block, a
// command that takes over (states of each stop: stop_run_states.h).
//
// It has a path of its own to the wire: the frame goes out in the same event, whatever waits or runs, also
// when another stop is under way. Each ends in its own time, so that who asks again and again takes no answer
// from those in front; a later one that is confirmed is good for all before it.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "stops/stop_run_states.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/robot/arrival.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

/// How a stop ended.
enum class StopEnd {
  Stopped,   ///< the robot was seen to stand
  AtTarget,  ///< it stands where the motion should end: there it would be without the stop, too
  Unseen,    ///< the controller accepted it, and no stream tells more
  Refused,   ///< the controller said no: what it had queued goes on
  Failed     ///< it is not certain that the robot stands
};

class StopRun {
 public:
  using Number = std::uint64_t;  ///< of a stop, increasing; 0: none

  struct Result {
    Number number = 0;
    StopEnd end = StopEnd::Failed;
    blocks::Failure failure;              ///< of one that failed(): why
    std::optional<robot::Target> target;  ///< of the motion that was to be stopped
    [[nodiscard]] bool failed() const { return end == StopEnd::Refused || end == StopEnd::Failed; }
    /// How the robot stands, for people. Precondition: not failed().
    [[nodiscard]] const char* words() const;
  };

  StopRun(const link::LinkSettings& settings, link::ScriptLink& link, link::TagLedger& tags,
          const robot::RobotWatch& robot, const arm::ArmModel* arm)
      : settings_(settings), link_(link), tags_(tags), robot_(robot), arm_(arm) {}

  /// Whatever the state of the link: a stop is worth a try. Does nothing without a connection: then nobody
  /// can be told. `target`: where the robot was to go, if that is known.
  void ask(const std::optional<robot::Target>& target, Instant now);
  /// The stop that was sent last, and when.
  [[nodiscard]] Number last() const { return last_; }
  [[nodiscard]] std::optional<Instant> lastAt() const { return last_at_; }
  [[nodiscard]] bool busy() const { return !stops_.empty(); }

  void answered(const link::ScriptAnswered& answer, Instant now);
  void linkLost(const std::string& reason);
  void robotChanged();
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  /// Once for each stop, in their order.
  [[nodiscard]] std::optional<Result> takeResult();

 private:
  struct Stop {
    std::string script_id;
    std::optional<Instant> deadline;  ///< behind its answer; for that the link gives it its time
    Instant accepted_at;
    std::optional<Instant> first_frame;  ///< behind its acceptance
    bool told = false;                   ///< the status stream has to show that the robot stands
    bool stands = false;                 ///< the robot was seen to stand behind it, or nobody can see that
    StopState state = StopState::Asked;
    Result result;  ///< as it will be
  };
  /// Whether a stop of now has to be confirmed by the status stream: it tells whether the robot moves, or did
  /// when one was asked that is still open.
  [[nodiscard]] bool hasToBeTold() const;
  /// By what the status stream has shown, at the end of its time.
  void judge(Stop& stop);
  void fire(Stop& stop, StopEvent event);
  void giveUp(Stop& stop, const blocks::Failure& failure);
  [[nodiscard]] StopEnd howItStands(const Stop& stop) const;
  [[nodiscard]] bool isAt(const std::optional<robot::Target>& target) const;
  /// What became of one is told to those in front of it, and what has ended is taken out.
  void settle();

  const link::LinkSettings& settings_;
  link::ScriptLink& link_;
  link::TagLedger& tags_;
  const robot::RobotWatch& robot_;
  const arm::ArmModel* arm_;  ///< nullptr: no model
  Number last_ = 0;
  std::optional<Instant> last_at_;
  std::deque<Stop> stops_;  ///< that have not ended, in the order of sending
  std::deque<Result> results_;
};

}  // namespace cobot_command::command
