// What becomes of a goal, as result and feedback: one way for all actions. Each message gets the fields that
// it has.
#pragma once

#include <cstdint>
#include <type_traits>

#include "cobot_command/ConnectFeedback.h"
#include "cobot_command/blocks/outcome.h"
#include "cobot_command/ros/conversions.h"

namespace cobot_command::ros_adapter {

/// The phase of every action but connect, as the constants in the .action files.
[[nodiscard]] std::uint8_t toPhase(blocks::Phase phase);

/// Calls `write` with the message when it has the fields that the return type of `write` names.
template <class Message, class Write>
void ifItHas(Message& message, const Write& write) {
  if constexpr (std::is_invocable_v<const Write&, Message&>) write(message);
}

/// Where the robot was at the end; what is unknown stays empty.
template <class Result>
void fillFinal(Result& message, const blocks::Outcome& outcome) {
  if (outcome.final_joints_deg) {
    message.final_joints.assign(outcome.final_joints_deg->begin(), outcome.final_joints_deg->end());
  }
  if (outcome.final_pose_mm_deg) message.final_pose = toTransformation(*outcome.final_pose_mm_deg);
}

/// What was found of each step, and the error of the one that failed.
template <class Result>
void fillSteps(Result& message, const blocks::Outcome& outcome, const JointNames& names) {
  for (const blocks::StepReport& step : outcome.steps) message.steps.push_back(toMessage(step, names));
  message.failed_step = outcome.failed_step;
  if (outcome.failed_step < 0 || static_cast<std::size_t>(outcome.failed_step) >= outcome.steps.size()) {
    return;
  }
  const blocks::StepReport& failed = outcome.steps[static_cast<std::size_t>(outcome.failed_step)];
  ifItHas(message, [&](auto& m) -> decltype(void(m.step_error_id)) {
    m.step_error_id = failed.error_id;
    m.step_error_description = failed.error_description;
  });
}

template <class Result>
void fill(Result& message, const blocks::Outcome& outcome, const JointNames& names) {
  message.error_id = outcome.error_id;
  message.error_description = outcome.error_description;
  message.remedy = outcome.remedy;
  ifItHas(message,
          [&](auto& m) -> decltype(void(m.command_id_ack)) { m.command_id_ack = outcome.command_id_ack; });
  ifItHas(message, [&](auto& m) -> decltype(void(m.planned_duration)) {
    m.planned_duration = toRos(outcome.planned);
  });
  ifItHas(message,
          [&](auto& m) -> decltype(void(m.actual_duration)) { m.actual_duration = toRos(outcome.actual); });
  ifItHas(message, [&](auto& m) -> decltype(void(m.final_pose)) { fillFinal(m, outcome); });
  ifItHas(message, [&](auto& m) -> decltype(void(m.joint_path)) {
    m.joint_path = toMessage(outcome.joint_path, names);
  });
  ifItHas(message, [&](auto& m) -> decltype(void(m.steps)) { fillSteps(m, outcome, names); });
  ifItHas(message, [&](auto& m) -> decltype(void(m.cycles_done)) { m.cycles_done = outcome.cycles_done; });
}

template <class Feedback>
void fill(Feedback& message, const blocks::Progress& progress) {
  message.phase = toPhase(progress.phase);
  message.text = progress.text;
  ifItHas(message,
          [&](auto& m) -> decltype(void(m.command_id_ack)) { m.command_id_ack = progress.command_id_ack; });
  ifItHas(message,
          [&](auto& m) -> decltype(void(m.place_in_queue)) { m.place_in_queue = progress.place_in_queue; });
  ifItHas(message, [&](auto& m) -> decltype(void(m.progress)) {
    m.progress = progress.fraction;
    m.remaining = toRos(progress.remaining);
    m.planned_duration = toRos(progress.planned);
  });
  ifItHas(message, [&](auto& m) -> decltype(void(m.cycle)) {
    m.step = progress.step;
    m.cycle = progress.cycle;
  });
}

/// The instants of a result or a feedback, in ROS time; apart, as they need both clocks.
template <class Message>
void fillTimes(Message& message, const blocks::LinkTimes& times, const ClockPair& clocks) {
  ifItHas(message, [&](auto& m) -> decltype(void(m.last_lost)) {
    if (times.last_connected) m.last_connected = clocks.toRos(*times.last_connected);
    if (times.last_lost) m.last_lost = clocks.toRos(*times.last_lost);
  });
}

/// It has phases of its own.
void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress);

}  // namespace cobot_command::ros_adapter
