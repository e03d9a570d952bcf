// The life of one command on the wire, as a table: from its frame to its one end.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::command {

enum class CommandRunState {
  Sent,        ///< the script was sent, no reply yet
  Executing,   ///< accepted; its tag is awaited
  Confirming,  ///< overdue, or stalled; TMSTA 01 was asked
  Verifying,   ///< its tag came; the status stream has to show the robot standing at the target
  Explaining,  ///< failed; the status stream may tell why
  Stopping,    ///< cancelled; the robot is being stopped (stop_run_states.h)
  Ended
};

enum class CommandRunEvent {
  Accepted,           ///< OK, and the tag is still to come
  AcceptedLast,       ///< OK, and nothing more to wait for: there is no tag
  AcceptedBehindTag,  ///< OK, and the tag came before it
  TagComplete,
  Verified,     ///< the robot is where it should be, or nobody can tell where it is
  Failed,       ///< whatever ends the command with an error; the cause comes with it
  Unexplained,  ///< the same, where the status stream may soon tell more
  Overdue,
  Stalled,     ///< the robot has come to rest away from the target, and nothing is seen to hold it
  StillGoing,  ///< asked: not complete, but the robot moves, or is paused, or nobody can tell
  Cancel,
  Stopped  ///< the robot stands
};

enum class CommandRunAction {
  None,
  RememberTag,
  AwaitTag,
  AskTag,
  AskTagEarly,  ///< the deadline stands
  Extend,
  Verify,
  Judge,  ///< what was seen until now has to do
  AwaitReason,
  AskForStop,
  EndDone,
  EndError,
  EndAborted  ///< CommandAborted
};

struct CommandRunTable {
  using S = CommandRunState;
  using E = CommandRunEvent;
  using A = CommandRunAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event                  to             action
    {S::Sent,       E::Accepted,          S::Executing,  A::AwaitTag},
    {S::Sent,       E::AcceptedLast,      S::Ended,      A::EndDone},
    {S::Sent,       E::AcceptedBehindTag, S::Verifying,  A::Verify},
    {S::Sent,       E::TagComplete,       S::Sent,       A::RememberTag},
    {S::Sent,       E::Failed,            S::Ended,      A::EndError},
    {S::Sent,       E::Unexplained,       S::Explaining, A::AwaitReason},
    {S::Sent,       E::Cancel,            S::Stopping,   A::AskForStop},

    {S::Executing,  E::TagComplete,       S::Verifying,  A::Verify},
    {S::Executing,  E::Failed,            S::Ended,      A::EndError},
    {S::Executing,  E::Unexplained,       S::Explaining, A::AwaitReason},
    {S::Executing,  E::Overdue,           S::Confirming, A::AskTag},
    {S::Executing,  E::Stalled,           S::Confirming, A::AskTagEarly},
    {S::Executing,  E::Cancel,            S::Stopping,   A::AskForStop},

    {S::Confirming, E::TagComplete,       S::Verifying,  A::Verify},
    {S::Confirming, E::Failed,            S::Ended,      A::EndError},
    {S::Confirming, E::Unexplained,       S::Explaining, A::AwaitReason},
    {S::Confirming, E::StillGoing,        S::Executing,  A::Extend},
    {S::Confirming, E::Cancel,            S::Stopping,   A::AskForStop},

    {S::Verifying,  E::Verified,          S::Ended,      A::EndDone},
    {S::Verifying,  E::Overdue,           S::Verifying,  A::Judge},
    {S::Verifying,  E::Failed,            S::Ended,      A::EndError},
    {S::Verifying,  E::Unexplained,       S::Explaining, A::AwaitReason},
    {S::Verifying,  E::Cancel,            S::Stopping,   A::AskForStop},

    // It has failed: a cancel is too late, and the robot was told to stop if that could help.
    {S::Explaining, E::Failed,            S::Ended,      A::EndError},
    {S::Explaining, E::Overdue,           S::Ended,      A::EndError},

    {S::Stopping,   E::Stopped,           S::Ended,      A::EndAborted},
    {S::Stopping,   E::Failed,            S::Ended,      A::EndError},
    {S::Stopping,   E::Unexplained,       S::Explaining, A::AwaitReason},
  };
  // clang-format on
};

}  // namespace cobot_command::command
