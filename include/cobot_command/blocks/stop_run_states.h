// How a robot is stopped and its queue emptied, as a table.
//
// An unlisted pair changes nothing (link/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/link/transition_table.h"

namespace cobot_command::blocks {

enum class StopState {
  Idle,
  Asked,    ///< StopAndClearBuffer() was sent, no reply yet
  Settling  ///< it was accepted; the robot comes to rest
};

enum class StopEvent {
  Ask,
  Accepted,
  Failed,  ///< refused, not answered, or the robot does not come to rest; the cause comes with it
  Standing
};

enum class StopAction { None, Send, AwaitStandstill, EndStopped, EndFailed };

struct StopTable {
  using S = StopState;
  using E = StopEvent;
  using A = StopAction;
  using Row = link::Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from        event         to            action
    {S::Idle,     E::Ask,       S::Asked,     A::Send},

    // A second wish to stop goes out like the first: who asks twice has a reason. The last reply counts.
    {S::Asked,    E::Ask,       S::Asked,     A::Send},
    {S::Asked,    E::Accepted,  S::Settling,  A::AwaitStandstill},
    {S::Asked,    E::Failed,    S::Idle,      A::EndFailed},

    {S::Settling, E::Ask,       S::Asked,     A::Send},
    {S::Settling, E::Standing,  S::Idle,      A::EndStopped},
    {S::Settling, E::Failed,    S::Idle,      A::EndFailed},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
