// Whether the robot continues a motion from before this connection, as a table. After a lost link, or after
// the end of a command node, the controller finishes its queued motions.
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::robot {

enum class OrphanState {
  NoLink,
  /// Commands can be sent, and it has not been seen yet whether the robot moves.
  Looking,
  /// It was at standstill, or it has been commanded since, or the flow was in another node: then the project
  /// moves it.
  None,
  /// It is at standstill, but a pause or a safeguard may hold back motions queued before.
  Held,
  Moving,  ///< it moves without a goal of this layer
  /// It moved when it was last seen; without a stream its standstill cannot be seen.
  Unseen
};

enum class OrphanEvent {
  Ready,  ///< commands can be sent
  Elsewhere,
  SeenMoving,
  SeenStanding,
  SeenHeld,
  OutOfSight,  ///< it is no longer visible whether it moves
  Commanded,   ///< a command of this layer was sent
  Stopped,     ///< a stop was confirmed
  LinkGone
};

enum class OrphanAction { None, Found };

struct OrphanTable {
  using S = OrphanState;
  using E = OrphanEvent;
  using A = OrphanAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from        event            to          action
    {S::NoLink,  E::Ready,        S::Looking, A::None},
    {S::NoLink,  E::Elsewhere,    S::None,    A::None},

    {S::Looking, E::SeenMoving,   S::Moving,  A::Found},
    {S::Looking, E::SeenStanding, S::None,    A::None},
    {S::Looking, E::SeenHeld,     S::Held,    A::Found},
    {S::Looking, E::Commanded,    S::None,    A::None},
    {S::Looking, E::Elsewhere,    S::None,    A::None},
    {S::Looking, E::Stopped,      S::None,    A::None},
    {S::Looking, E::LinkGone,     S::NoLink,  A::None},

    {S::None,    E::LinkGone,     S::NoLink,  A::None},

    {S::Held,    E::SeenMoving,   S::Moving,  A::None},
    {S::Held,    E::SeenStanding, S::None,    A::None},
    {S::Held,    E::Stopped,      S::None,    A::None},
    {S::Held,    E::Elsewhere,    S::None,    A::None},
    {S::Held,    E::LinkGone,     S::NoLink,  A::None},

    {S::Moving,  E::SeenStanding, S::None,    A::None},
    {S::Moving,  E::Stopped,      S::None,    A::None},
    {S::Moving,  E::OutOfSight,   S::Unseen,  A::None},
    {S::Moving,  E::LinkGone,     S::NoLink,  A::None},

    {S::Unseen,  E::SeenMoving,   S::Moving,  A::None},
    {S::Unseen,  E::SeenStanding, S::None,    A::None},
    {S::Unseen,  E::Stopped,      S::None,    A::None},
    {S::Unseen,  E::LinkGone,     S::NoLink,  A::None},
  };
  // clang-format on
};

}  // namespace cobot_command::robot
