// The life of a connect goal, as a table. The connection itself: link/script_link_states.h.
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::command {

enum class ConnectState {
  Idle,
  Trying,        ///< not connected, or not in the Listen node; the timeout runs
  Supervising,   ///< was ready for commands; stays Busy for as long as the link lives
  Explaining,    ///< lost; the status stream may tell why
  Disconnecting  ///< cancelled; a motion is being stopped first
};

enum class ConnectEvent {
  Execute,
  BecameReady,
  TimedOut,
  Lost,             ///< an established link, not to be made again by this goal
  LostUnexplained,  ///< the same, and the status stream may soon tell why
  LostToRetry,      ///< lost, with auto_reconnect
  Cancel,
  MotionsEnded,
};

enum class ConnectAction {
  None,
  Start,
  Hold,
  RestartTimeout,
  StopMotions,
  AwaitReason,
  EndTimedOut,
  EndLost,
  EndDone
};

struct ConnectTable {
  using S = ConnectState;
  using E = ConnectEvent;
  using A = ConnectAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from             event                to                action
    {S::Idle,          E::Execute,          S::Trying,        A::Start},

    {S::Trying,        E::BecameReady,      S::Supervising,   A::Hold},
    {S::Trying,        E::TimedOut,         S::Idle,          A::EndTimedOut},
    {S::Trying,        E::Cancel,           S::Disconnecting, A::StopMotions},

    {S::Supervising,   E::Lost,             S::Idle,          A::EndLost},
    {S::Supervising,   E::LostUnexplained,  S::Explaining,    A::AwaitReason},
    {S::Supervising,   E::LostToRetry,      S::Trying,        A::RestartTimeout},
    {S::Supervising,   E::Cancel,           S::Disconnecting, A::StopMotions},

    {S::Explaining,    E::Lost,             S::Idle,          A::EndLost},
    {S::Explaining,    E::TimedOut,         S::Idle,          A::EndLost},

    {S::Disconnecting, E::MotionsEnded,     S::Idle,          A::EndDone},
    {S::Disconnecting, E::Lost,             S::Idle,          A::EndDone},
    {S::Disconnecting, E::LostToRetry,      S::Idle,          A::EndDone},
  };
  // clang-format on
};

}  // namespace cobot_command::command
