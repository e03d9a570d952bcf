// The fields of results and feedback that many actions have, and some have not.
#pragma once

#include <type_traits>

#include "clients/command.h"

namespace cobot_command::rviz_plugin::outcome {

template <class Message, class = void>
struct HasAck : std::false_type {};
template <class Message>
struct HasAck<Message, std::void_t<decltype(Message::command_id_ack)>> : std::true_type {};

template <class Message, class = void>
struct HasDurations : std::false_type {};
template <class Message>
struct HasDurations<Message,
                    std::void_t<decltype(Message::planned_duration), decltype(Message::actual_duration)>>
    : std::true_type {};

template <class Message, class = void>
struct HasProgress : std::false_type {};
template <class Message>
struct HasProgress<Message, std::void_t<decltype(Message::progress)>> : std::true_type {};

template <class Message, class = void>
struct HasStep : std::false_type {};
template <class Message>
struct HasStep<Message, std::void_t<decltype(Message::step)>> : std::true_type {};

template <class Message, class = void>
struct HasSteps : std::false_type {};
template <class Message>
struct HasSteps<Message, std::void_t<decltype(Message::steps)>> : std::true_type {};

template <class Message, class = void>
struct HasPoints : std::false_type {};
template <class Message>
struct HasPoints<Message, std::void_t<decltype(Message::points)>> : std::true_type {};

template <class Message>
void readFeedback(const Message& feedback, CommandState& state) {
  state.text = feedback.text;
  if constexpr (HasAck<Message>::value) state.command_id_ack = feedback.command_id_ack;
  if constexpr (HasProgress<Message>::value) state.progress = feedback.progress;
  if constexpr (HasStep<Message>::value) state.step = feedback.step;
}

/// Where one command was checked its own error says more than that a step is wrong.
template <class Message>
void readErrorOfOnlyStep(const Message& result, CommandState& state) {
  if constexpr (HasSteps<Message>::value) {
    if (result.steps.size() != 1 || result.steps.front().error_id == 0) return;
    state.error_id = result.steps.front().error_id;
    state.description = result.steps.front().error_description;
    state.remedy.clear();
  }
}

template <class Message>
void readResult(const Message& result, CommandState& state) {
  state.error_id = result.error_id;
  state.description = result.error_description;
  state.remedy = result.remedy;
  readErrorOfOnlyStep(result, state);
  if constexpr (HasAck<Message>::value) state.command_id_ack = result.command_id_ack;
  if constexpr (HasDurations<Message>::value) {
    state.planned = result.planned_duration.toSec();
    state.actual = result.actual_duration.toSec();
  }
}

template <class Message>
Plan readPlan(const Message& result) {
  if constexpr (HasSteps<Message>::value) return planOf(result.steps);
  if constexpr (HasPoints<Message>::value) return planOf(result.points);
  return {};
}

}  // namespace cobot_command::rviz_plugin::outcome
