// How the file of a block makes its action server: with an ActionOf, toGoal() of the goal message, and fill()
// of result and feedback, which are looked up by the messages; then it instantiates serve().
#pragma once

#include "command/action_servers.h"

namespace cobot_command::ros_adapter {

/// The action of a block, as its Type.
template <class Goal>
struct ActionOf;

template <class Goal>
std::unique_ptr<GoalListener> serve(const ActionSite& site) {
  return std::make_unique<ActionBridge<typename ActionOf<Goal>::Type>>(site.node, Goal::kName,
                                                                       site.joint_names, site.sink);
}

}  // namespace cobot_command::ros_adapter
