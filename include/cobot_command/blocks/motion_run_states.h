// The life of one motion command on the wire, as a table: from its frame to its one end.
//
// An unlisted pair changes nothing (link/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/link/transition_table.h"

namespace cobot_command::blocks {

enum class MotionRunState {
  Sent,        ///< the script was sent, no reply yet
  Executing,   ///< accepted; its tag is awaited
  Confirming,  ///< overdue; TMSTA 01 was asked
  Stopping,    ///< cancelled; the reply to StopAndClearBuffer() is awaited
  Settling,    ///< the stop was accepted; the robot comes to rest
  Ended
};

enum class MotionRunEvent {
  Accepted,      ///< OK, and the tag is still to come
  AcceptedLast,  ///< OK, and nothing more to wait for: blended, or the tag came before the reply
  TagComplete,
  Failed,  ///< whatever ends the command with an error; the cause comes with it
  Overdue,
  StillGoing,  ///< asked: not complete, but the robot moves, or is paused, or nobody can tell
  Cancel,
  StopAccepted,
  Standing
};

enum class MotionRunAction {
  None,
  RememberTag,
  AwaitTag,
  AskTag,
  Extend,
  SendStop,
  AwaitStandstill,
  EndDone,
  EndError,
  EndAborted  ///< CommandAborted
};

struct MotionRunTable {
  using S = MotionRunState;
  using E = MotionRunEvent;
  using A = MotionRunAction;
  using Row = link::Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event            to             action
    {S::Sent,       E::Accepted,     S::Executing,  A::AwaitTag},
    {S::Sent,       E::AcceptedLast, S::Ended,      A::EndDone},
    {S::Sent,       E::TagComplete,  S::Sent,       A::RememberTag},
    {S::Sent,       E::Failed,       S::Ended,      A::EndError},
    {S::Sent,       E::Cancel,       S::Stopping,   A::SendStop},

    {S::Executing,  E::TagComplete,  S::Ended,      A::EndDone},
    {S::Executing,  E::Failed,       S::Ended,      A::EndError},
    {S::Executing,  E::Overdue,      S::Confirming, A::AskTag},
    {S::Executing,  E::Cancel,       S::Stopping,   A::SendStop},

    {S::Confirming, E::TagComplete,  S::Ended,      A::EndDone},
    {S::Confirming, E::Failed,       S::Ended,      A::EndError},
    {S::Confirming, E::StillGoing,   S::Executing,  A::Extend},
    {S::Confirming, E::Cancel,       S::Stopping,   A::SendStop},

    {S::Stopping,   E::StopAccepted, S::Settling,   A::AwaitStandstill},
    {S::Stopping,   E::Failed,       S::Ended,      A::EndError},

    {S::Settling,   E::Standing,     S::Ended,      A::EndAborted},
    {S::Settling,   E::Failed,       S::Ended,      A::EndError},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
