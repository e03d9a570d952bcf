// The life of a wait in the queue, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::blocks {

enum class QueueWaitState {
  Waiting,
  Explaining,  ///< the link was lost; the status stream may tell why
  Ended
};

enum class QueueWaitEvent {
  Met,          ///< what it waits for is there
  Failed,       ///< the cause comes with it
  Unexplained,  ///< the same, and the status stream may soon tell more
  Cancelled
};

enum class QueueWaitAction { None, AwaitReason, EndDone, EndError, EndAborted };

struct QueueWaitTable {
  using S = QueueWaitState;
  using E = QueueWaitEvent;
  using A = QueueWaitAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event           to             action
    {S::Waiting,    E::Met,         S::Ended,      A::EndDone},
    {S::Waiting,    E::Failed,      S::Ended,      A::EndError},
    {S::Waiting,    E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Waiting,    E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Explaining, E::Failed,      S::Ended,      A::EndError},
    {S::Explaining, E::Cancelled,   S::Ended,      A::EndError},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
