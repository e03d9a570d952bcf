// The life of a run_program goal, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h): it came too late for its state.
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::blocks {

enum class ProgramState {
  Waiting,   ///< for a permit, or for the robot to be seen where the program goes on
  Moving,    ///< a frame is under way
  Setting,   ///< so is the output behind it
  Awaiting,  ///< the input behind it
  Dwelling,
  Explaining,  ///< the link was lost between two frames; the status stream may tell why
  Ended
};

enum class ProgramEvent {
  FrameSent,
  OutputNext,  ///< a part is over, and an output is to be set
  InputNext,   ///< ... and an input is to be waited for
  DwellNext,   ///< ... and a dwell follows
  StepDone,    ///< ... and nothing follows it
  AllDone,
  Failed,       ///< the cause comes with it
  Unexplained,  ///< the same, and the status stream may soon tell more
  Cancelled     ///< and nothing is under way any more
};

enum class ProgramAction { None, StartWait, StartDwell, GoOn, AwaitReason, EndDone, EndError, EndAborted };

struct ProgramTable {
  using S = ProgramState;
  using E = ProgramEvent;
  using A = ProgramAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event           to             action
    {S::Waiting,     E::FrameSent,   S::Moving,     A::None},
    {S::Waiting,     E::AllDone,     S::Ended,      A::EndDone},
    {S::Waiting,     E::Failed,      S::Ended,      A::EndError},
    {S::Waiting,     E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Waiting,     E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Moving,      E::OutputNext,  S::Setting,    A::None},
    {S::Moving,      E::InputNext,   S::Awaiting,   A::StartWait},
    {S::Moving,      E::DwellNext,   S::Dwelling,   A::StartDwell},
    {S::Moving,      E::StepDone,    S::Waiting,    A::GoOn},
    {S::Moving,      E::Failed,      S::Ended,      A::EndError},
    {S::Moving,      E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Moving,      E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Setting,     E::InputNext,   S::Awaiting,   A::StartWait},
    {S::Setting,     E::DwellNext,   S::Dwelling,   A::StartDwell},
    {S::Setting,     E::StepDone,    S::Waiting,    A::GoOn},
    {S::Setting,     E::Failed,      S::Ended,      A::EndError},
    {S::Setting,     E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Setting,     E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Awaiting,    E::DwellNext,   S::Dwelling,   A::StartDwell},
    {S::Awaiting,    E::StepDone,    S::Waiting,    A::GoOn},
    {S::Awaiting,    E::Failed,      S::Ended,      A::EndError},
    {S::Awaiting,    E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Dwelling,    E::StepDone,    S::Waiting,    A::GoOn},
    {S::Dwelling,    E::Failed,      S::Ended,      A::EndError},
    {S::Dwelling,    E::Unexplained, S::Explaining, A::AwaitReason},
    {S::Dwelling,    E::Cancelled,   S::Ended,      A::EndAborted},

    {S::Explaining,  E::Failed,      S::Ended,      A::EndError},
    {S::Explaining,  E::Cancelled,   S::Ended,      A::EndError},
  };
  // clang-format on
};

}  // namespace cobot_command::blocks
