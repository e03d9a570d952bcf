// Which of what the controller sends belongs to a script that reads, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): numbers that come before the mark are of
// other scripts.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::robot {

enum class ReadState {
  Idle,       ///< nobody has asked
  Sent,       ///< the controller is busy with what others sent before
  Collecting  ///< the mark has come: it runs this script, and no other before its reply
};

enum class ReadEvent {
  Send,
  Mark,
  Numbers,  ///< under a channel of an attribute
  End       ///< the reply, or there will be none
};

enum class ReadAction {
  Begin,  ///< nothing has come yet
  Store,
  Tell
};

struct ReadTable {
  using S = ReadState;
  using E = ReadEvent;
  using A = ReadAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from            event        to               action
    {S::Idle,       E::Send,    S::Sent,       A::Begin},

    {S::Sent,       E::Mark,    S::Collecting, A::Begin},
    {S::Sent,       E::End,     S::Idle,       A::Tell},

    {S::Collecting, E::Mark,    S::Collecting, A::Begin},  // the one before was somebody else's
    {S::Collecting, E::Numbers, S::Collecting, A::Store},
    {S::Collecting, E::End,     S::Idle,       A::Tell},
  };
  // clang-format on
};

}  // namespace cobot_command::robot
