// The life of a jog, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::blocks {

enum class JogState {
  Driving,     ///< is held to run, or makes its increment
  Slowing,     ///< no keep-alive came: comes to rest, and goes on with the next one
  Ending,      ///< comes to rest for good, by its own end
  Stopping,    ///< cancelled, stopped, taken over or halted: what is at the controller is being stopped
  Failing,     ///< the same, by a failure
  Explaining,  ///< the link was lost with nothing at the controller; the status stream may tell why
  Ended
};

enum class JogEvent {
  KeepAlive,
  Late,         ///< the keep-alive is
  AtEnd,        ///< nothing more may be driven; why comes with it
  Standing,     ///< the arm is seen to stand, in a mode that would let it go on
  Cancel,       ///< by whomever
  Failed,       ///< the cause comes with it
  Unexplained,  ///< the same, where the status stream may soon tell more
  NothingLeft   ///< of it is at the controller
};

enum class JogAction { None, AwaitRest, AwaitReason, EndDone, EndStopped, EndFailed };

struct JogTable {
  using S = JogState;
  using E = JogEvent;
  using A = JogAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from           event           to             action
    {S::Driving,    E::Late,        S::Slowing,    A::AwaitRest},
    {S::Driving,    E::AtEnd,       S::Ending,     A::AwaitRest},
    {S::Driving,    E::Cancel,      S::Stopping,   A::None},
    {S::Driving,    E::Failed,      S::Failing,    A::None},
    {S::Driving,    E::Unexplained, S::Explaining, A::AwaitReason},

    {S::Slowing,    E::KeepAlive,   S::Driving,    A::None},
    {S::Slowing,    E::AtEnd,       S::Ending,     A::AwaitRest},
    {S::Slowing,    E::Standing,    S::Ending,     A::AwaitRest},
    {S::Slowing,    E::Cancel,      S::Stopping,   A::None},
    {S::Slowing,    E::Failed,      S::Failing,    A::None},
    {S::Slowing,    E::NothingLeft, S::Ended,      A::EndDone},

    {S::Ending,     E::Cancel,      S::Stopping,   A::None},
    {S::Ending,     E::Failed,      S::Failing,    A::None},
    {S::Ending,     E::NothingLeft, S::Ended,      A::EndDone},

    {S::Stopping,   E::Failed,      S::Failing,    A::None},
    {S::Stopping,   E::NothingLeft, S::Ended,      A::EndStopped},

    {S::Failing,    E::NothingLeft, S::Ended,      A::EndFailed},

    {S::Explaining, E::Failed,      S::Ended,      A::EndFailed},
    {S::Explaining, E::Cancel,      S::Ended,      A::EndFailed},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
