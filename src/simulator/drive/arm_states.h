// The life of a motion on the arm, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): who stands cannot be stopped, and an arm that
// brakes cannot be held.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::simulator {

enum class ArmState {
  Standing,  ///< no motion is under way
  Moving,    ///< also where it speeds up again after a hold
  Held,      ///< within a motion: it slows down on its path, or stands there
  Braking    ///< it slows down on its path, and the rest is given up
};

enum class ArmEvent {
  Begin,    ///< a motion from rest; velocities, also out of another motion
  Hold,     ///< somebody holds it
  Release,  ///< nobody holds it any more
  Stop,     ///< the rest of the motion is given up
  End,      ///< the end of the path, or of the braking
  Halt      ///< it stands at once
};

enum class ArmAction { Start, SlowDown, SpeedUp, Brake, BrakeOn, Arrive, StandHere };

struct ArmTable {
  using S = ArmState;
  using E = ArmEvent;
  using A = ArmAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from         event         to            action
    {S::Standing, E::Begin,     S::Moving,    A::Start},

    {S::Moving,   E::Begin,     S::Moving,    A::Start},
    {S::Moving,   E::Hold,      S::Held,      A::SlowDown},
    {S::Moving,   E::Stop,      S::Braking,   A::Brake},
    {S::Moving,   E::End,       S::Standing,  A::Arrive},
    {S::Moving,   E::Halt,      S::Standing,  A::StandHere},

    {S::Held,     E::Release,   S::Moving,    A::SpeedUp},
    {S::Held,     E::Stop,      S::Braking,   A::BrakeOn},    // it slows down already
    {S::Held,     E::End,       S::Standing,  A::Arrive},     // the end came before the standstill
    {S::Held,     E::Halt,      S::Standing,  A::StandHere},

    {S::Braking,  E::Begin,     S::Moving,    A::Start},      // a velocity takes over
    {S::Braking,  E::End,       S::Standing,  A::StandHere},
    {S::Braking,  E::Halt,      S::Standing,  A::StandHere},
  };
  // clang-format on
};

}  // namespace cobot_command::simulator
