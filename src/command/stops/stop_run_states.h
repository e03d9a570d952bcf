// How one StopAndClearBuffer() goes on, from its frame to its one end, as a table. Each wish to stop sends
// one of its own: who asks twice has a reason.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::command {

enum class StopState {
  Asked,     ///< it was sent, no reply yet
  Settling,  ///< it was accepted; the robot comes to rest
  Failing,   ///< refused, or not answered; one that was sent behind it may still be confirmed
  Ended
};

enum class StopEvent {
  Accepted,
  Refused,   ///< or not answered
  Standing,  ///< the robot was seen to stand behind it, or behind a later one
  GiveUp     ///< its time is over, the link is lost, or there is no later one; the cause comes with it
};

enum class StopAction { None, AwaitStandstill, EndStopped, EndFailed };

struct StopTable {
  using S = StopState;
  using E = StopEvent;
  using A = StopAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from        event         to            action
    {S::Asked,    E::Accepted,  S::Settling,  A::AwaitStandstill},
    {S::Asked,    E::Refused,   S::Failing,   A::None},
    {S::Asked,    E::Standing,  S::Ended,     A::EndStopped},
    {S::Asked,    E::GiveUp,    S::Ended,     A::EndFailed},

    {S::Settling, E::Standing,  S::Ended,     A::EndStopped},
    {S::Settling, E::GiveUp,    S::Ended,     A::EndFailed},

    {S::Failing,  E::Standing,  S::Ended,     A::EndStopped},
    {S::Failing,  E::GiveUp,    S::Ended,     A::EndFailed},
  };
  // clang-format on
};

}  // namespace cobot_command::command
