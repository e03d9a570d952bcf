#include "messages/message_services.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "shared/core_answer.h"
#include "shared/steady_now.h"
#include <fmt/format.h>

#include "cobot_command/Message.h"
#include "cobot_command/MessageList.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr std::uint32_t kQueueSize = 100;
constexpr int kSeverityRange = 0x8D51;

cobot_command::Message toMessage(const command::Message& one, const ClockPair& clocks) {
  cobot_command::Message message;
  message.header.stamp = clocks.toRos(one.time);
  message.id = one.id;
  message.severity = static_cast<std::uint8_t>(one.severity);
  message.type = static_cast<std::uint8_t>(one.type);
  message.code = one.code;
  message.origin = one.origin;
  message.text = forPeople(one.text);
  message.remedy = forPeople(one.remedy);
  message.pending = static_cast<std::uint8_t>(one.pending);
  return message;
}

std::vector<cobot_command::Message> toMessages(const std::vector<command::Message>& all,
                                               const ClockPair& clocks) {
  std::vector<cobot_command::Message> messages;
  std::transform(all.begin(), all.end(), std::back_inserter(messages),
                 [&](const command::Message& one) { return toMessage(one, clocks); });
  return messages;
}

}  // namespace

MessageServices::MessageServices(const ros::NodeHandle& node, Core core) : core_(std::move(core)) {
  OwnHandle handle(node);
  messages_ = handle.advertise<cobot_command::Message>("messages", kQueueSize);
  pending_ = handle.advertise<cobot_command::MessageList>("pending_messages", 1, true);
  take(command::PendingChanged(), {ros::Time::now(), steadyNow()});  // so that it can be read at once
  services_.push_back(handle.advertiseService("read_messages", &MessageServices::readMessages, this));
  services_.push_back(handle.advertiseService("reset", &MessageServices::reset, this));
}

void MessageServices::take(const command::MessageRaised& raised, const ClockPair& clocks) {
  messages_.publish(toMessage(raised.message, clocks));
}

void MessageServices::take(const command::PendingChanged& changed, const ClockPair& clocks) {
  cobot_command::MessageList list;
  list.header.stamp = ros::Time::now();
  list.messages = toMessages(changed.pending, clocks);
  pending_.publish(list);
}

bool MessageServices::readMessages(cobot_command::ReadMessages::Request& request,
                                   cobot_command::ReadMessages::Response& response) {
  constexpr int kMost = static_cast<int>(command::Severity::Error);
  if (request.min_severity > kMost) {
    response.error_id = kSeverityRange;
    response.message = fmt::format("min_severity is {}, allowed: 0 to {}: choose one in this range",
                                   request.min_severity, kMost);
    return true;
  }
  const auto least = static_cast<command::Severity>(request.min_severity);
  const auto found = answerOf(core_.read(least, request.after_id), response.message);
  if (!found) return true;
  response.messages = toMessages(*found, {ros::Time::now(), steadyNow()});
  response.success = 1;
  return true;
}

bool MessageServices::reset(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
  if (const auto answer = answerOf(core_.reset(), response.message)) {
    response.success = static_cast<std::uint8_t>(answer->success);
    response.message = forPeople(answer->message);
  }
  return true;
}

}  // namespace cobot_command::ros_adapter
