// The life of a pick-and-place goal, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::blocks {

enum class PickAndPlaceState {
  Moving,   ///< the move of a step is to be sent, or under way
  Setting,  ///< so is the output of the step
  Waiting,  ///< for the input of the step
  Dwelling,
  Explaining,  ///< the link was lost between two commands; the status stream may tell why
  Ended
};

enum class PickAndPlaceEvent {
  OutputNext,   ///< a part of the step is over, and an output is to be set
  InputNext,    ///< ... and an input is to be waited for
  DwellNext,    ///< ... and a dwell follows
  StepNext,     ///< ... it was the last one, and another step follows
  LastDone,     ///< the last step of the last cycle is over
  Failed,       ///< the cause comes with it
  Unexplained,  ///< the same, and the status stream may soon tell more
  Cancelled     ///< and nothing is under way any more
};

enum class PickAndPlaceAction {
  None,
  StartWait,
  StartDwell,
  NextStep,
  AwaitReason,
  EndDone,
  EndError,
  EndAborted
};

struct PickAndPlaceTable {
  using S = PickAndPlaceState;
  using E = PickAndPlaceEvent;
  using A = PickAndPlaceAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event           to             action
    {S::Moving,      E::OutputNext,  S::Setting,    A::None},
    {S::Moving,      E::InputNext,   S::Waiting,    A::StartWait},
    {S::Moving,      E::DwellNext,   S::Dwelling,   A::StartDwell},
    {S::Moving,      E::StepNext,    S::Moving,     A::NextStep},
    {S::Moving,      E::LastDone,    S::Ended,      A::EndDone},
    {S::Moving,      E::Failed,      S::Ended,      A::EndError},
    {S::Moving,      E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Moving,      E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Setting,     E::InputNext,   S::Waiting,    A::StartWait},
    {S::Setting,     E::DwellNext,   S::Dwelling,   A::StartDwell},
    {S::Setting,     E::StepNext,    S::Moving,     A::NextStep},
    {S::Setting,     E::LastDone,    S::Ended,      A::EndDone},
    {S::Setting,     E::Failed,      S::Ended,      A::EndError},
    {S::Setting,     E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Setting,     E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Waiting,     E::DwellNext,   S::Dwelling,   A::StartDwell},
    {S::Waiting,     E::StepNext,    S::Moving,     A::NextStep},
    {S::Waiting,     E::LastDone,    S::Ended,      A::EndDone},
    {S::Waiting,     E::Failed,      S::Ended,      A::EndError},
    {S::Waiting,     E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Dwelling,    E::StepNext,    S::Moving,     A::NextStep},
    {S::Dwelling,    E::LastDone,    S::Ended,      A::EndDone},
    {S::Dwelling,    E::Failed,      S::Ended,      A::EndError},
    {S::Dwelling,    E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Dwelling,    E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Explaining,  E::Failed,      S::Ended,      A::EndError},
    {S::Explaining,  E::Cancelled,   S::Ended,      A::EndError},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
