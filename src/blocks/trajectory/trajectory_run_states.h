// The life of a trajectory, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::blocks {

enum class TrajectoryState {
  Following,   ///< waits for its start, or is at the controller
  Stopping,    ///< cancelled, stopped or taken over: what is at the controller is being stopped
  OffPath,     ///< the same, as a path tolerance is violated
  Explaining,  ///< the link was lost with nothing at the controller; the status stream may tell why
  Ended
};

enum class TrajectoryEvent {
  Done,         ///< at its end, within the goal tolerance
  Cancel,       ///< by whomever
  LeftPath,     ///< further off than the path tolerance
  Failed,       ///< the cause comes with it
  Unexplained,  ///< the same, where the status stream may soon tell more
  NothingLeft   ///< of it is at the controller
};

enum class TrajectoryAction { None, AwaitReason, EndDone, EndStopped, EndFailed };

struct TrajectoryTable {
  using S = TrajectoryState;
  using E = TrajectoryEvent;
  using A = TrajectoryAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from           event           to             action
    {S::Following,  E::Done,        S::Ended,      A::EndDone},
    {S::Following,  E::Cancel,      S::Stopping,   A::None},
    {S::Following,  E::LeftPath,    S::OffPath,    A::None},
    {S::Following,  E::Failed,      S::Ended,      A::EndFailed},
    {S::Following,  E::Unexplained, S::Explaining, A::AwaitReason},

    {S::Stopping,   E::Done,        S::Ended,      A::EndDone},
    {S::Stopping,   E::Failed,      S::Ended,      A::EndFailed},
    {S::Stopping,   E::NothingLeft, S::Ended,      A::EndStopped},

    {S::OffPath,    E::Failed,      S::Ended,      A::EndFailed},
    {S::OffPath,    E::NothingLeft, S::Ended,      A::EndFailed},

    {S::Explaining, E::Failed,      S::Ended,      A::EndFailed},
    {S::Explaining, E::Cancel,      S::Ended,      A::EndFailed},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
