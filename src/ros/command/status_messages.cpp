#include "command/status_messages.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/trace_text.h"

namespace cobot_command::ros_adapter {
namespace {

cobot_command::BlockStatus toMessage(const command::BlockOutputs& outputs) {
  cobot_command::BlockStatus message;
  message.block = blocks::toString(outputs.block);
  message.busy = outputs.busy;
  message.active = outputs.active;
  message.done = outputs.done;
  message.error = outputs.error;
  message.command_aborted = outputs.command_aborted;
  message.error_id = outputs.error_id;
  message.error_description = forPeople(outputs.error_description);
  message.command_id_ack = outputs.command_id_ack;
  return message;
}

std::uint8_t toMessage(command::CommandStatus::LinkState state) {
  using State = command::CommandStatus::LinkState;
  using Message = cobot_command::CommandStatus;
  switch (state) {
    case State::Disconnected:
      return Message::DISCONNECTED;
    case State::Connecting:
      return Message::CONNECTING;
    case State::Probing:
      return Message::PROBING;
    case State::NotListening:
      return Message::NOT_LISTENING;
    case State::Ready:
      return Message::READY;
  }
  return Message::DISCONNECTED;
}

template <class Message, class Levels>
void fill(Message& message, const Levels& levels) {
  using Io = cobot_command::DigitalIo;
  std::transform(levels.begin(), levels.end(), message.begin(), [](const std::optional<bool>& level) {
    if (!level) return Io::UNKNOWN;
    return *level ? Io::ON : Io::OFF;
  });
}

}  // namespace

cobot_command::CommandStatus toMessage(const command::CommandStatus& status, const ClockPair& clocks) {
  cobot_command::CommandStatus message;
  message.header.stamp = clocks.ros_now;
  message.link_state = toMessage(status.link);
  message.diagnosis = forPeople(status.diagnosis);
  message.host = status.host;
  message.port = status.port;
  message.listen_node = status.listen_node;
  message.status_stream = status.status_stream;
  message.status_diagnosis = status.status_diagnosis;
  if (status.last_connected) message.last_connected = clocks.toRos(*status.last_connected);
  if (status.last_lost) message.last_lost = clocks.toRos(*status.last_lost);
  message.queue_depth = status.queue_depth;
  message.commands_under_way = status.commands_under_way;
  message.commands_waiting = status.commands_waiting;
  message.waiting_return = status.waiting_return;
  message.open_tags.assign(status.open_tags.begin(), status.open_tags.end());
  message.late_replies = status.late_replies;
  message.decode_faults = status.decode_faults;
  for (const command::BlockOutputs& outputs : status.blocks) message.blocks.push_back(toMessage(outputs));
  return message;
}

cobot_command::FrameTrace toMessage(const command::FrameTraced& trace, const ClockPair& clocks) {
  using Message = cobot_command::FrameTrace;
  Message message;
  message.header.stamp = clocks.toRos(trace.time);
  message.channel = trace.channel == link::Channel::Script ? Message::SCRIPT : Message::STATUS;
  message.sent = trace.sent;
  message.bytes.assign(trace.bytes.begin(), trace.bytes.end());
  message.text = traceText(trace.bytes);
  message.meaning = trace.meaning;
  return message;
}

cobot_command::ActiveFrames toMessage(const robot::ActiveFrames& frames, const std::string& base_frame,
                                      const ros::Time& stamp) {
  cobot_command::ActiveFrames message;
  message.header.stamp = stamp;
  message.header.frame_id = base_frame;
  message.base_known = frames.base.has_value();
  message.base = toPoseMessage(frames.base.value_or(arm::Pose::Identity()));
  message.base_name = frames.base_name;
  message.tcp_known = frames.tcp.has_value();
  message.tcp = toPoseMessage(frames.tcp.value_or(arm::Pose::Identity()));
  message.tcp_name = frames.tcp_name;
  message.tool_mass = frames.tool_mass.value_or(-1);
  return message;
}

cobot_command::GroupState toMessage(const command::GroupState& state, const ros::Time& stamp) {
  cobot_command::GroupState message;
  message.header.stamp = stamp;
  message.ri_state = static_cast<std::uint8_t>(state.ri_state);
  message.out_of_sync = state.out_of_sync;
  message.enabled = state.enabled;
  message.sequence = static_cast<std::uint8_t>(state.sequence);
  message.in_primary_position = state.in_primary_position;
  message.queue_usage = state.queue_usage;
  message.pending_errors = static_cast<std::uint32_t>(state.pending_errors);
  message.pending_warnings = static_cast<std::uint32_t>(state.pending_warnings);
  message.speed_override = state.speed_override;
  message.effective_speed = state.effective_speed;
  message.motion_state_known = state.trend.has_value();
  message.accelerating = state.trend == robot::Trend::Accelerating;
  message.decelerating = state.trend == robot::Trend::Decelerating;
  message.constant_velocity = state.trend == robot::Trend::ConstantVelocity;
  return message;
}

cobot_command::DigitalIo toMessage(const link::DigitalLevels& inputs, const link::DigitalLevels& outputs,
                                   const ros::Time& stamp) {
  cobot_command::DigitalIo message;
  message.header.stamp = stamp;
  fill(message.control_box_inputs, inputs.control_box);
  fill(message.control_box_outputs, outputs.control_box);
  fill(message.end_module_inputs, inputs.end_module);
  fill(message.end_module_outputs, outputs.end_module);
  return message;
}

}  // namespace cobot_command::ros_adapter
