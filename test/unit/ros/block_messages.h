// What the files of the blocks (src/ros/actions) make of their messages: as their action servers find it.
#pragma once

#include "action_parts/outcome_parts.h"
#include "action_parts/step_goals.h"

#include "cobot_command/ChangeBaseAction.h"
#include "cobot_command/ChangeTCPAction.h"
#include "cobot_command/CheckSequenceAction.h"
#include "cobot_command/ConnectAction.h"
#include "cobot_command/ExitListenNodeAction.h"
#include "cobot_command/LoadPathAction.h"
#include "cobot_command/MoveAbsoluteAction.h"
#include "cobot_command/MoveCircleAction.h"
#include "cobot_command/MoveRelativeAction.h"
#include "cobot_command/PickAndPlaceAction.h"
#include "cobot_command/ProgramControlAction.h"
#include "cobot_command/RunScriptAction.h"
#include "cobot_command/StopAction.h"
#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/ros/command/action_bridge.h"

namespace cobot_command::ros_adapter {

blocks::ConnectGoal toGoal(const cobot_command::ConnectGoal& message, const Lookups& lookups);
blocks::ProgramControlGoal toGoal(const cobot_command::ProgramControlGoal& message, const Lookups& lookups);
blocks::StopGoal toGoal(const cobot_command::StopGoal& message, const Lookups& lookups);
blocks::ExitListenNodeGoal toGoal(const cobot_command::ExitListenNodeGoal& message, const Lookups& lookups);
blocks::RunScriptGoal toGoal(const cobot_command::RunScriptGoal& message, const Lookups& lookups);
blocks::CheckSequenceGoal toGoal(const cobot_command::CheckSequenceGoal& message, const Lookups& lookups);
blocks::PickAndPlaceGoal toGoal(const cobot_command::PickAndPlaceGoal& message, const Lookups& lookups);
blocks::LoadPathGoal toGoal(const cobot_command::LoadPathGoal& message, const Lookups& lookups);

void fill(cobot_command::LoadPathResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::LoadPathFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::ConnectResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::MoveAbsoluteResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::MoveRelativeResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::MoveCircleResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::ChangeBaseResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::ChangeTCPResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::ProgramControlResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::StopResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::ExitListenNodeResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::RunScriptResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::CheckSequenceResult& message, const blocks::Outcome& outcome, const FillSite& site);
void fill(cobot_command::PickAndPlaceResult& message, const blocks::Outcome& outcome, const FillSite& site);

void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::MoveAbsoluteFeedback& message, const blocks::Progress& progress,
          const FillSite& site);
void fill(cobot_command::MoveRelativeFeedback& message, const blocks::Progress& progress,
          const FillSite& site);
void fill(cobot_command::MoveCircleFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::ChangeBaseFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::ChangeTCPFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::ProgramControlFeedback& message, const blocks::Progress& progress,
          const FillSite& site);
void fill(cobot_command::StopFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::ExitListenNodeFeedback& message, const blocks::Progress& progress,
          const FillSite& site);
void fill(cobot_command::RunScriptFeedback& message, const blocks::Progress& progress, const FillSite& site);
void fill(cobot_command::CheckSequenceFeedback& message, const blocks::Progress& progress,
          const FillSite& site);
void fill(cobot_command::PickAndPlaceFeedback& message, const blocks::Progress& progress,
          const FillSite& site);

}  // namespace cobot_command::ros_adapter
