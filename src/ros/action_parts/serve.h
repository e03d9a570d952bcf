// How the file of a block makes its action server: with an ActionOf, toGoal() of the goal message, and fill()
// of result and feedback, which are looked up by the messages; then it instantiates serve(). Where a message
// names joints, readGoal() takes the place of toGoal().
#pragma once

#include "command/action_servers.h"

#include "cobot_command/blocks/list/goes_first.h"

namespace cobot_command::ros_adapter {

/// The action of a block, as its Type.
template <class Goal>
struct ActionOf;

template <class Goal>
std::unique_ptr<GoalListener> serve(const ActionSite& site) {
  const GoalWay& way = blocks::kGoesFirst<Goal> ? site.stops : site.goals;
  return std::make_unique<ActionBridge<typename ActionOf<Goal>::Type>>(site.node, Goal::kName,
                                                                       site.joint_names, way);
}

/// Of a block whose messages were not there when this was built: there are no goals that it could hear of.
[[nodiscard]] inline std::unique_ptr<GoalListener> serveNobody() {
  class Nobody final : public GoalListener {
    void accepted(blocks::GoalId /*id*/) override {}
    void progressed(blocks::GoalId /*id*/, const blocks::Progress& /*progress*/,
                    const ClockPair& /*clocks*/) override {}
    void ended(blocks::GoalId /*id*/, const blocks::Outcome& /*outcome*/,
               const ClockPair& /*clocks*/) override {}
  };
  return std::make_unique<Nobody>();
}

}  // namespace cobot_command::ros_adapter
