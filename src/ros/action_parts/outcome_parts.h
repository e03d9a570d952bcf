// The fields that results and feedback of several blocks have, each written out: one that is renamed does not
// compile.
#pragma once

#include <cstdint>

#include "command/plan_messages.h"

#include "cobot_command/blocks/shared/joint_path.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/blocks/shared/sequence_report.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

/// As the constants in the .action files; connect has phases of its own.
[[nodiscard]] std::uint8_t toPhase(blocks::Phase phase);

/// What every result has.
template <class Result>
void fillEnd(Result& message, const blocks::Outcome& outcome) {
  message.error_id = outcome.error_id;
  message.error_description = forPeople(outcome.error_description);
  message.remedy = forPeople(outcome.remedy);
}

/// That of a command with an id.
template <class Result>
void fillCommandEnd(Result& message, const blocks::Outcome& outcome) {
  fillEnd(message, outcome);
  message.command_id_ack = outcome.command_id_ack;
}

/// Where the robot was at the end; what is unknown of that stays empty.
template <class Result>
void fillFinalPlace(Result& message, const blocks::Outcome& outcome) {
  if (outcome.final_joints_deg) {
    message.final_joints.assign(outcome.final_joints_deg->begin(), outcome.final_joints_deg->end());
  }
  if (outcome.final_pose_mm_deg) message.final_pose = toTransformation(*outcome.final_pose_mm_deg);
}

/// How long the motion took, and was to take, and where it ended.
template <class Result>
void fillArrival(Result& message, const blocks::Outcome& outcome) {
  message.planned_duration = toRos(outcome.planned);
  message.actual_duration = toRos(outcome.actual);
  fillFinalPlace(message, outcome);
}

/// That of a move.
template <class Result>
void fillMoveEnd(Result& message, const blocks::Outcome& outcome, const JointNames& names) {
  fillCommandEnd(message, outcome);
  fillArrival(message, outcome);
  message.joint_path = toMessage(outcome.detail.as<blocks::CheckedMotion>().joint_path, names);
}

/// What was found of each step.
template <class Result>
void fillSteps(Result& message, const blocks::SequenceReport& report, const JointNames& names) {
  for (const blocks::StepReport& step : report.steps) message.steps.push_back(toMessage(step, names));
  message.failed_step = report.failed_step;
}

/// What every feedback has.
template <class Feedback>
void fillPhase(Feedback& message, const blocks::Progress& progress) {
  message.phase = toPhase(progress.phase);
  message.text = forPeople(progress.text);
}

/// That of what waits for its turn.
template <class Feedback>
void fillTurn(Feedback& message, const blocks::Progress& progress) {
  fillPhase(message, progress);
  message.place_in_queue = progress.place_in_queue;
}

/// That of a command with an id.
template <class Feedback>
void fillCommandTurn(Feedback& message, const blocks::Progress& progress) {
  fillTurn(message, progress);
  message.command_id_ack = progress.command_id_ack;
}

/// That of what moves.
template <class Feedback>
void fillMotion(Feedback& message, const blocks::Progress& progress) {
  fillCommandTurn(message, progress);
  message.progress = progress.fraction;
  message.remaining = toRos(progress.remaining);
  message.planned_duration = toRos(progress.planned);
}

}  // namespace cobot_command::ros_adapter
