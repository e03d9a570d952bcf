// The script link as a table: how a connection to port 5890 comes up, is supervised, and goes down.
//
// An unlisted pair changes nothing (transition_table.h): it is an event that came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::link {

enum class ScriptLinkState {
  Disconnected,  ///< nobody wants a connection
  BackingOff,    ///< between two tries
  Connecting,    ///< TCP connection under way
  Probing,       ///< connected; TMSTA 00 asked, not yet answered
  NotListening,  ///< a TM controller answers, its flow is in another node
  Leaving,       ///< ScriptExit() was accepted: TMSCT is refused although TMSTA 00 may still say true
  Ready          ///< in the Listen node
};

enum class ScriptLinkEvent {
  Start,
  RetryDue,
  Opened,
  OpenFailed,
  AnsweredTrue,    ///< TMSTA 00: in the Listen node
  AnsweredFalse,   ///< TMSTA 00: not in the Listen node
  NodeEntered,     ///< the entry message, TMSCT 0
  NodeLeft,        ///< CPERR F1
  ExitAccepted,    ///< a script with ScriptExit() was accepted
  StillListening,  ///< asked again and again since then, it was always in the Listen node
  NoAnswer,        ///< too many lifesigns without an answer
  ForeignPeer,     ///< what arrives is not what a script port says
  Closed,          ///< by the peer, or by the network
  Stop
};

enum class ScriptLinkAction {
  None,
  Open,    ///< start a TCP connection
  Probe,   ///< ask TMSTA 00
  Retry,   ///< not established: drop the connection if there is one, try again after the back-off
  Lose,    ///< established: tell that it is lost, then as Retry
  Release  ///< drop the connection, on request
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
    // The flow has come back, and its entry message was lost or came before the OK.
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

/// TCP is up: something can be tried, whatever it will be answered.
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
