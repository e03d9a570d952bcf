// Where the flow of the project is, as seen from the script port: a table.
//
//   Stopped  -- Run ------> Listening      the script port is open, the node is entered
//   Listening - Exit -----> Leaving        ScriptExit: no script is taken, queued motion goes on
//   Leaving  -- Done -----> Elsewhere      the queue is empty, the arm stands: the node is left
//   Elsewhere - Reenter --> Listening      the project loops back into the node
//   any but Stopped -- Stop --> Stopped    the script port closes
//
// Every other pair leaves the flow where it is.
#pragma once

namespace cobot_command::simulator {

enum class FlowState { Stopped, Listening, Leaving, Elsewhere };
enum class FlowEvent { Run, Exit, Done, Reenter, Stop };

[[nodiscard]] FlowState after(FlowState state, FlowEvent event);

}  // namespace cobot_command::simulator
