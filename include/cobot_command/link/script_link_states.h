// The script link as a table: how a connection to port 5890 is opened, supervised and closed.
//
// An unlisted pair changes nothing (transition_table.h): the event came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::link {

enum class ScriptLinkState {
  Disconnected,  ///< no connection is wanted
  BackingOff,    ///< between two attempts
  Connecting,    ///< the TCP connection is being opened
  Probing,       ///< connected; TMSTA 00 sent, not answered yet
  NotListening,  ///< a TM controller answers, its flow is in another node
  /// ScriptExit() was accepted: TMSCT is refused, although the answer to TMSTA 00 may still be true.
  Leaving,
  Ready  ///< in the Listen node
};

enum class ScriptLinkEvent {
  Start,
  RetryDue,
  Opened,
  OpenFailed,
  AnsweredTrue,   ///< TMSTA 00: in the Listen node
  AnsweredFalse,  ///< TMSTA 00: not in the Listen node
  NodeEntered,    ///< the entry message, TMSCT 0
  NodeLeft,       ///< CPERR F1
  ExitAccepted,   ///< a script with ScriptExit() was accepted
  /// Every repeated query since then was answered "in the Listen node".
  StillListening,
  NoAnswer,     ///< too many unanswered heartbeats
  ForeignPeer,  ///< the received data is not that of a script port
  Closed,       ///< by the peer or by the network
  Stop
};

enum class ScriptLinkAction {
  None,
  Open,   ///< open a TCP connection
  Probe,  ///< send TMSTA 00
  /// Not established: close the connection if there is one, try again after the back-off.
  Retry,
  Lose,    ///< established: report the loss, then as Retry
  Release  ///< close the connection, on request
};

struct ScriptLinkTable {
  using S = ScriptLinkState;
  using E = ScriptLinkEvent;
  using A = ScriptLinkAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from            event              to                action
    {S::Disconnected, E::Start,         S::Connecting,   A::Open},

    {S::BackingOff,   E::RetryDue,      S::Connecting,   A::Open},
    {S::BackingOff,   E::Stop,          S::Disconnected, A::Release},

    {S::Connecting,   E::Opened,        S::Probing,      A::Probe},
    {S::Connecting,   E::OpenFailed,    S::BackingOff,   A::Retry},
    {S::Connecting,   E::Closed,        S::BackingOff,   A::Retry},
    {S::Connecting,   E::Stop,          S::Disconnected, A::Release},

    {S::Probing,      E::AnsweredTrue,  S::Ready,        A::None},
    {S::Probing,      E::AnsweredFalse, S::NotListening, A::None},
    {S::Probing,      E::NodeEntered,   S::Ready,        A::None},
    {S::Probing,      E::NoAnswer,      S::BackingOff,   A::Retry},
    {S::Probing,      E::ForeignPeer,   S::BackingOff,   A::Retry},
    {S::Probing,      E::Closed,        S::BackingOff,   A::Retry},
    {S::Probing,      E::Stop,          S::Disconnected, A::Release},

    {S::NotListening, E::AnsweredTrue,  S::Ready,        A::None},
    {S::NotListening, E::AnsweredFalse, S::NotListening, A::None},
    {S::NotListening, E::NodeEntered,   S::Ready,        A::None},
    {S::NotListening, E::NodeLeft,      S::NotListening, A::None},
    {S::NotListening, E::NoAnswer,      S::BackingOff,   A::Lose},
    {S::NotListening, E::Closed,        S::BackingOff,   A::Lose},
    {S::NotListening, E::Stop,          S::Disconnected, A::Release},

    {S::Leaving,      E::AnsweredTrue,  S::Leaving,      A::None},
    {S::Leaving,      E::AnsweredFalse, S::NotListening, A::None},
    {S::Leaving,      E::NodeEntered,   S::Ready,        A::None},
    {S::Leaving,      E::NodeLeft,      S::Leaving,      A::None},
    // The flow has returned, and its entry message was lost or arrived before the OK.
    {S::Leaving,      E::StillListening, S::Ready,       A::None},
    {S::Leaving,      E::NoAnswer,      S::BackingOff,   A::Lose},
    {S::Leaving,      E::Closed,        S::BackingOff,   A::Lose},
    {S::Leaving,      E::Stop,          S::Disconnected, A::Release},

    {S::Ready,        E::AnsweredTrue,  S::Ready,        A::None},
    {S::Ready,        E::AnsweredFalse, S::NotListening, A::None},
    {S::Ready,        E::NodeEntered,   S::Ready,        A::None},
    {S::Ready,        E::NodeLeft,      S::NotListening, A::None},
    {S::Ready,        E::ExitAccepted,  S::Leaving,      A::None},
    {S::Ready,        E::NoAnswer,      S::BackingOff,   A::Lose},
    {S::Ready,        E::Closed,        S::BackingOff,   A::Lose},
    {S::Ready,        E::Stop,          S::Disconnected, A::Release},
  };
  // clang-format on
};

/// TCP is up: a request can be sent, whatever the answer.
[[nodiscard]] constexpr bool isConnected(ScriptLinkState state) {
  return state == ScriptLinkState::Probing || state == ScriptLinkState::NotListening ||
         state == ScriptLinkState::Leaving || state == ScriptLinkState::Ready;
}

/// TCP is up and a TM controller answered.
[[nodiscard]] constexpr bool isEstablished(ScriptLinkState state) {
  return state == ScriptLinkState::NotListening || state == ScriptLinkState::Leaving ||
         state == ScriptLinkState::Ready;
}

}  // namespace cobot_command::link
