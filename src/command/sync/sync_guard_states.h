// What happens to motions while enabled data are out of sync, as a table (SRCI: SyncReaction).
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::command {

enum class SyncGuardState {
  Free,
  Refusing,     ///< the robot was not enabled: it is as if it stayed so, for motions
  Emptying,     ///< what is there goes on to its end
  Interrupted,  ///< out of sync: nobody may resume
  Stopped,      ///< the same, and nothing is left to be resumed
  Resumable     ///< in sync again, and nothing resumes by itself
};

enum class SyncGuardEvent {
  InSync,
  OutOfSync,
  NoEnable,   ///< out of sync for long enough: by the reaction, and by how robot and queue are
  WhenEmpty,  ///< the same
  Interrupt,  ///< the same
  Resumed,    ///< by its client, and the controller has taken it: the robot goes on
  Emptied,    ///< a stop has taken what there was
  Waits,      ///< a motion does
  Released,   ///< nothing is compared any more
  LinkLost    ///< nothing is left
};

enum class SyncGuardAction {
  None,
  Tell,
  Interrupt,  ///< the same, and what moves is held
  HoldAgain   ///< what was let go when that was not to be any more
};

struct SyncGuardTable {
  using S = SyncGuardState;
  using E = SyncGuardEvent;
  using A = SyncGuardAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from             event           to               action
    {S::Free,        E::NoEnable,   S::Refusing,    A::Tell},
    {S::Free,        E::WhenEmpty,  S::Emptying,    A::None},
    {S::Free,        E::Interrupt,  S::Interrupted, A::Interrupt},

    {S::Refusing,    E::InSync,     S::Free,        A::None},
    {S::Refusing,    E::Released,   S::Free,        A::None},
    {S::Refusing,    E::LinkLost,   S::Free,        A::None},

    {S::Emptying,    E::InSync,     S::Free,        A::None},
    {S::Emptying,    E::NoEnable,   S::Refusing,    A::Tell},
    {S::Emptying,    E::Interrupt,  S::Interrupted, A::Interrupt},
    {S::Emptying,    E::Released,   S::Free,        A::None},
    {S::Emptying,    E::LinkLost,   S::Free,        A::None},

    {S::Interrupted, E::InSync,     S::Resumable,   A::None},
    {S::Interrupted, E::Resumed,    S::Interrupted, A::HoldAgain},
    {S::Interrupted, E::Emptied,    S::Stopped,     A::None},
    {S::Interrupted, E::Released,   S::Resumable,   A::None},
    {S::Interrupted, E::LinkLost,   S::Free,        A::None},

    {S::Stopped,     E::InSync,     S::Free,        A::None},
    {S::Stopped,     E::Waits,      S::Interrupted, A::None},
    {S::Stopped,     E::Released,   S::Free,        A::None},
    {S::Stopped,     E::LinkLost,   S::Free,        A::None},

    {S::Resumable,   E::OutOfSync,  S::Interrupted, A::Interrupt},
    {S::Resumable,   E::Resumed,    S::Free,        A::None},
    {S::Resumable,   E::Emptied,    S::Free,        A::None},
    {S::Resumable,   E::LinkLost,   S::Free,        A::None},
  };
  // clang-format on
};

}  // namespace cobot_command::command
