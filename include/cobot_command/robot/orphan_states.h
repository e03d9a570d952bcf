// Whether the robot moves on from before this connection, as a table: a lost link, or the end of a command
// node, lets the controller finish what it has queued.
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::robot {

enum class OrphanState {
  NoLink,
  Looking,  ///< commands can be sent, and it has not been seen yet whether the robot moves
  None,     ///< it stood, or it has been commanded since, or the flow was elsewhere: the project moves it
  Held,     ///< it stands, but a pause or a safeguard holds what may be queued from before
  Moving,   ///< it moves, and no goal of this layer asked for it
  Unseen    ///< it moved when it was last seen: a stream that is gone shows no robot that stands
};

enum class OrphanEvent {
  Ready,  ///< commands can be sent
  Elsewhere,
  SeenMoving,
  SeenStanding,
  SeenHeld,
  OutOfSight,  ///< nobody can tell any more whether it moves
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
