// The fields of results and feedback that many actions have, and some have not.
#pragma once

#include "clients/command.h"
#include <boost/type_traits/is_detected.hpp>

namespace cobot_command::rviz_plugin::outcome {

template <class Message>
using Ack = decltype(Message::command_id_ack);
template <class Message>
using Durations = decltype(Message::planned_duration, Message::actual_duration);
template <class Message>
using Fraction = decltype(Message::progress);
template <class Message>
using Step = decltype(Message::step);
template <class Message>
using Steps = decltype(Message::steps);
template <class Message>
using Points = decltype(Message::points);
template <class Message>
using Why = decltype(Message::why);
template <class Message>
using Path = decltype(Message::joint_path);

template <template <class> class Field, class Message>
inline constexpr bool kHas = boost::is_detected<Field, Message>::value;

template <class Message>
void readFeedback(const Message& feedback, CommandState& state) {
  state.text = feedback.text;
  if constexpr (kHas<Ack, Message>) state.command_id_ack = feedback.command_id_ack;
  if constexpr (kHas<Fraction, Message>) state.progress = feedback.progress;
  if constexpr (kHas<Step, Message>) state.step = feedback.step;
}

/// Where one command was checked its own error says more than that a step is wrong.
template <class Message>
void readErrorOfOnlyStep(const Message& result, CommandState& state) {
  if constexpr (kHas<Steps, Message>) {
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
  if constexpr (kHas<Why, Message>) {
    if (state.description.empty()) state.description = result.why;
  }
  readErrorOfOnlyStep(result, state);
  if constexpr (kHas<Ack, Message>) state.command_id_ack = result.command_id_ack;
  if constexpr (kHas<Durations, Message>) {
    state.planned = result.planned_duration.toSec();
    state.actual = result.actual_duration.toSec();
  }
}

template <class Message>
Plan readPlan(const Message& result) {
  Plan plan;
  if constexpr (kHas<Steps, Message>) plan = planOf(result.steps);
  if constexpr (kHas<Points, Message>) plan = planOf(result.points);
  if constexpr (kHas<Path, Message>) {
    if (plan.path.points.empty()) plan.path = result.joint_path;
  }
  return plan;
}

}  // namespace cobot_command::rviz_plugin::outcome
