// Which data from the controller belongs to a reading script, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): numbers before the mark belong to other
// scripts.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::robot {

enum class ReadState {
  Idle,  ///< nothing was requested
  Sent,  ///< the controller may still run scripts sent earlier by others
  /// The mark has arrived: the controller runs this script, and no other before its reply.
  Collecting
};

enum class ReadEvent {
  Send,
  Mark,
  Numbers,  ///< on a channel of an attribute
  End       ///< the reply, or the certainty that there is none
};

enum class ReadAction {
  Begin,  ///< no value has arrived yet
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

    {S::Collecting, E::Mark,    S::Collecting, A::Begin},  // the mark before belonged to another script
    {S::Collecting, E::Numbers, S::Collecting, A::Store},
    {S::Collecting, E::End,     S::Idle,       A::Tell},
  };
  // clang-format on
};

}  // namespace cobot_command::robot
