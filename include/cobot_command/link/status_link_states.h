// The status link (port 5891) as a table. It is independent of the script link.
//
// An unlisted pair changes nothing (transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::link {

enum class StatusLinkState {
  Off,         ///< the stream is not wanted
  BackingOff,  ///< between two attempts
  Connecting,  ///< the TCP connection is being opened
  Waiting,     ///< connected, no usable frame yet
  Streaming    ///< frames arrive
};

enum class StatusLinkEvent {
  Start,
  RetryDue,
  Opened,
  OpenFailed,
  Frame,    ///< a readable status frame
  Silence,  ///< no such frame for status_timeout
  Closed,
  Stop
};

enum class StatusLinkAction {
  None,
  Open,
  Watch,  ///< start the watchdog
  /// Close the connection if there is one, try again after the back-off.
  Retry,
  Release  ///< close the connection, on request
};

struct StatusLinkTable {
  using S = StatusLinkState;
  using E = StatusLinkEvent;
  using A = StatusLinkAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event          to             action
    {S::Off,        E::Start,      S::Connecting, A::Open},

    {S::BackingOff, E::RetryDue,   S::Connecting, A::Open},
    {S::BackingOff, E::Stop,       S::Off,        A::Release},

    {S::Connecting, E::Opened,     S::Waiting,    A::Watch},
    {S::Connecting, E::OpenFailed, S::BackingOff, A::Retry},
    {S::Connecting, E::Closed,     S::BackingOff, A::Retry},
    {S::Connecting, E::Stop,       S::Off,        A::Release},

    {S::Waiting,    E::Frame,      S::Streaming,  A::Watch},
    {S::Waiting,    E::Silence,    S::BackingOff, A::Retry},
    {S::Waiting,    E::Closed,     S::BackingOff, A::Retry},
    {S::Waiting,    E::Stop,       S::Off,        A::Release},

    {S::Streaming,  E::Frame,      S::Streaming,  A::Watch},
    {S::Streaming,  E::Silence,    S::BackingOff, A::Retry},
    {S::Streaming,  E::Closed,     S::BackingOff, A::Retry},
    {S::Streaming,  E::Stop,       S::Off,        A::Release},
  };
  // clang-format on
};

}  // namespace cobot_command::link
