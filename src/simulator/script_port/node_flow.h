// Where the flow of the project is, as seen from the script port, as a table.
//
// An unlisted pair changes nothing (common/transition_table.h).
#pragma once

#include "cobot_command/common/transition_table.h"

namespace cobot_command::simulator {

enum class FlowState {
  Stopped,    ///< the script port is closed
  Listening,  ///< in the Listen node
  Leaving,    ///< no script is taken, queued motion goes on
  Elsewhere   ///< in another node
};
enum class FlowEvent {
  Run,      ///< the project
  Exit,     ///< ScriptExit, a timeout, or the operator
  Done,     ///< the queue is empty, the arm stands
  Reenter,  ///< the project loops back into the node
  Stop      ///< the project
};
enum class FlowAction { Open, Leave, ComeOut, Enter, Close };

struct FlowTable {
  using S = FlowState;
  using E = FlowEvent;
  using A = FlowAction;
  using Row = Transition<S, E, A>;

  // clang-format off
  static constexpr Row kRows[] = {
    // from          event        to             action
    {S::Stopped,    E::Run,      S::Listening,  A::Open},

    {S::Listening,  E::Exit,     S::Leaving,    A::Leave},
    {S::Listening,  E::Stop,     S::Stopped,    A::Close},

    {S::Leaving,    E::Done,     S::Elsewhere,  A::ComeOut},
    {S::Leaving,    E::Stop,     S::Stopped,    A::Close},

    {S::Elsewhere,  E::Reenter,  S::Listening,  A::Enter},
    {S::Elsewhere,  E::Stop,     S::Stopped,    A::Close},
  };
  // clang-format on
};

}  // namespace cobot_command::simulator
