// The life of an exchange_configuration goal, as a table (SRCI: Enable, Enabled, Busy).
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::command {

enum class ExchangeState {
  Disabled,
  Enabling,  ///< waits for a link that is ready
  Enabled,
  Disabling  ///< cancelled; the settings of the node are put back
};

enum class ExchangeEvent {
  Execute,
  Ready,  ///< the link, and the settings were taken
  TimedOut,
  Update,  ///< other settings, that are good
  Cancel,
  Restored,  ///< the settings of the node hold again
  ConnectionLost,
  LifeSignLost,
  ShutDown
};

enum class ExchangeAction {
  Begin,
  Enable,
  TakeUpdate,
  Restore,
  EndDone,
  EndTimedOut,
  EndConnectionLost,
  EndLifeSignLost,
  EndShutDown
};

struct ExchangeTable {
  using S = ExchangeState;
  using E = ExchangeEvent;
  using A = ExchangeAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from         event               to            action
    {S::Disabled,  E::Execute,         S::Enabling,  A::Begin},

    {S::Enabling,  E::Ready,           S::Enabled,   A::Enable},
    {S::Enabling,  E::TimedOut,        S::Disabled,  A::EndTimedOut},
    {S::Enabling,  E::Cancel,          S::Disabling, A::Restore},
    {S::Enabling,  E::ShutDown,        S::Disabled,  A::EndShutDown},

    {S::Enabled,   E::Update,          S::Enabled,   A::TakeUpdate},
    {S::Enabled,   E::Cancel,          S::Disabling, A::Restore},
    {S::Enabled,   E::ConnectionLost,  S::Disabled,  A::EndConnectionLost},
    {S::Enabled,   E::LifeSignLost,    S::Disabled,  A::EndLifeSignLost},
    {S::Enabled,   E::ShutDown,        S::Disabled,  A::EndShutDown},

    {S::Disabling, E::Restored,        S::Disabled,  A::EndDone},
    {S::Disabling, E::TimedOut,        S::Disabled,  A::EndTimedOut},
    {S::Disabling, E::ConnectionLost,  S::Disabled,  A::EndDone},
    {S::Disabling, E::LifeSignLost,    S::Disabled,  A::EndDone},
    {S::Disabling, E::ShutDown,        S::Disabled,  A::EndShutDown},
  };
  // clang-format on
};

}  // namespace cobot_command::command
