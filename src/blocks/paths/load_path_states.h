// The life of a chain of load_path goals, as a table. Each goal's own end follows of where its points are.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::blocks {

enum class LoadPathState {
  Following,   ///< pieces go out, or the next one is waited for
  Stopping,    ///< cancelled, stopped or taken over: what is at the controller is being stopped
  Failing,     ///< a piece failed: the others are being stopped, or come to their end
  Explaining,  ///< failed with nothing at the controller; the status stream may tell why
  Ended
};

enum class LoadPathEvent {
  LastDone,     ///< the last point of the last goal
  Cancel,       ///< by whomever
  Failed,       ///< the cause comes with it
  Unexplained,  ///< the same, where the status stream may soon tell more
  NothingLeft   ///< of it is at the controller
};

enum class LoadPathAction { None, AwaitReason, EndDone, EndStopped, EndFailed };

struct LoadPathTable {
  using S = LoadPathState;
  using E = LoadPathEvent;
  using A = LoadPathAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from           event           to             action
    {S::Following,  E::LastDone,    S::Ended,      A::EndDone},
    {S::Following,  E::Cancel,      S::Stopping,   A::None},
    {S::Following,  E::Failed,      S::Failing,    A::None},
    {S::Following,  E::Unexplained, S::Explaining, A::AwaitReason},

    {S::Stopping,   E::Failed,      S::Failing,    A::None},
    {S::Stopping,   E::LastDone,    S::Ended,      A::EndDone},
    {S::Stopping,   E::NothingLeft, S::Ended,      A::EndStopped},

    {S::Failing,    E::NothingLeft, S::Ended,      A::EndFailed},

    {S::Explaining, E::Failed,      S::Ended,      A::EndFailed},
    {S::Explaining, E::NothingLeft, S::Ended,      A::EndFailed},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
