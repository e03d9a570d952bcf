// The life of an interruption, as a table (SRCI: GroupInterrupt, GroupContinue).
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::command {

enum class InterruptState {
  None,
  Stopping,    ///< what is under way is being stopped
  Interrupted  ///< it is set aside, with what waits; the robot may be moved by other goals
};

enum class InterruptEvent {
  Asked,        ///< and what is under way can go on later
  Stands,       ///< the robot does, and nothing is under way any more
  NothingLeft,  ///< what was to go on later has ended: cancelled, stopped, taken over, failed
  Continued     ///< the robot is where it was
};

enum class InterruptAction { None, Stop, SetAside, TellLost, PutBack };

struct InterruptTable {
  using S = InterruptState;
  using E = InterruptEvent;
  using A = InterruptAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from             event            to               action
    {S::None,        E::Asked,       S::Stopping,    A::Stop},

    {S::Stopping,    E::Stands,      S::Interrupted, A::SetAside},
    {S::Stopping,    E::NothingLeft, S::None,        A::TellLost},

    {S::Interrupted, E::NothingLeft, S::None,        A::None},
    {S::Interrupted, E::Continued,   S::None,        A::PutBack},
  };
  // clang-format on
};

}  // namespace cobot_command::command
