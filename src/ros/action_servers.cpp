#include "action_servers.h"

#include "cobot_command/ChangeBaseAction.h"
#include "cobot_command/ChangeTCPAction.h"
#include "cobot_command/CheckSequenceAction.h"
#include "cobot_command/ConnectAction.h"
#include "cobot_command/ExitListenNodeAction.h"
#include "cobot_command/MoveAbsoluteAction.h"
#include "cobot_command/MoveCircleAction.h"
#include "cobot_command/MoveRelativeAction.h"
#include "cobot_command/PickAndPlaceAction.h"
#include "cobot_command/ProgramControlAction.h"
#include "cobot_command/RunScriptAction.h"
#include "cobot_command/StopAction.h"

namespace cobot_command::ros_adapter {
namespace {

using blocks::Block;

class Servers {
 public:
  Servers(const ros::NodeHandle& node, const JointNames& joint_names, const GoalSink& sink)
      : node_(node), joint_names_(joint_names), sink_(sink) {}

  template <class Action>
  Servers& serve(Block block) {
    bridges_.push_back(
        std::make_unique<ActionBridge<Action>>(node_, blocks::toString(block), joint_names_, sink_));
    return *this;
  }
  std::vector<std::unique_ptr<GoalListener>> take() { return std::move(bridges_); }

 private:
  const ros::NodeHandle& node_;
  const JointNames& joint_names_;
  const GoalSink& sink_;
  std::vector<std::unique_ptr<GoalListener>> bridges_;
};

}  // namespace

std::vector<std::unique_ptr<GoalListener>> serveActions(const ros::NodeHandle& node,
                                                        const JointNames& joint_names, const GoalSink& sink) {
  return Servers(node, joint_names, sink)
      .serve<cobot_command::ConnectAction>(Block::Connect)
      .serve<cobot_command::MoveAbsoluteAction>(Block::MoveAbsolute)
      .serve<cobot_command::MoveRelativeAction>(Block::MoveRelative)
      .serve<cobot_command::MoveCircleAction>(Block::MoveCircle)
      .serve<cobot_command::ChangeBaseAction>(Block::ChangeBase)
      .serve<cobot_command::ChangeTCPAction>(Block::ChangeTcp)
      .serve<cobot_command::ProgramControlAction>(Block::ProgramControl)
      .serve<cobot_command::StopAction>(Block::Stop)
      .serve<cobot_command::ExitListenNodeAction>(Block::ExitListenNode)
      .serve<cobot_command::RunScriptAction>(Block::RunScript)
      .serve<cobot_command::CheckSequenceAction>(Block::CheckSequence)
      .serve<cobot_command::PickAndPlaceAction>(Block::PickAndPlace)
      .take();
}

}  // namespace cobot_command::ros_adapter
