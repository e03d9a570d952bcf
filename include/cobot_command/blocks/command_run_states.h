// The life of one command on the wire, as a table: from its frame to its one end.
//
// An unlisted pair changes nothing (link/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/link/transition_table.h"

namespace cobot_command::blocks {

enum class CommandRunState {
  Sent,        ///< the script was sent, no reply yet
  Executing,   ///< accepted; its tag is awaited
  Confirming,  ///< overdue; TMSTA 01 was asked
  Stopping,    ///< cancelled; the robot is being stopped (stop_run_states.h)
  Ended
};

enum class CommandRunEvent {
  Accepted,      ///< OK, and the tag is still to come
  AcceptedLast,  ///< OK, and nothing more to wait for: blended, or the tag came before the reply
  TagComplete,
  Failed,  ///< whatever ends the command with an error; the cause comes with it
  Overdue,
  StillGoing,  ///< asked: not complete, but the robot moves, or is paused, or nobody can tell
  Cancel,
  Stopped  ///< the robot stands
};

enum class CommandRunAction {
  None,
  RememberTag,
  AwaitTag,
  AskTag,
  Extend,
  AskForStop,
  EndDone,
  EndError,
  EndAborted  ///< CommandAborted
};

struct CommandRunTable {
  using S = CommandRunState;
  using E = CommandRunEvent;
  using A = CommandRunAction;
  using Row = link::Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event            to             action
    {S::Sent,       E::Accepted,     S::Executing,  A::AwaitTag},
    {S::Sent,       E::AcceptedLast, S::Ended,      A::EndDone},
    {S::Sent,       E::TagComplete,  S::Sent,       A::RememberTag},
    {S::Sent,       E::Failed,       S::Ended,      A::EndError},
    {S::Sent,       E::Cancel,       S::Stopping,   A::AskForStop},

    {S::Executing,  E::TagComplete,  S::Ended,      A::EndDone},
    {S::Executing,  E::Failed,       S::Ended,      A::EndError},
    {S::Executing,  E::Overdue,      S::Confirming, A::AskTag},
    {S::Executing,  E::Cancel,       S::Stopping,   A::AskForStop},

    {S::Confirming, E::TagComplete,  S::Ended,      A::EndDone},
    {S::Confirming, E::Failed,       S::Ended,      A::EndError},
    {S::Confirming, E::StillGoing,   S::Executing,  A::Extend},
    {S::Confirming, E::Cancel,       S::Stopping,   A::AskForStop},

    {S::Stopping,   E::Stopped,      S::Ended,      A::EndAborted},
    {S::Stopping,   E::Failed,       S::Ended,      A::EndError},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
