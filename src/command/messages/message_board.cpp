#include "messages/message_board.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::command {
namespace {

bool isOfOneCause(const Message& a, const Message& b) {
  return a.type == b.type && a.code == b.code && a.origin == b.origin && a.text == b.text;
}

}  // namespace

const char* toString(Severity severity) {
  switch (severity) {
    case Severity::Off:
      break;
    case Severity::Debug:
      return "debug";
    case Severity::Info:
      return "info";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
    case Severity::Fatal:
      return "fatal";
  }
  return "off";
}

std::optional<Message> MessageBoard::raise(Message message, bool lasts) {
  if (!keeps(message.severity)) return std::nullopt;
  for (std::string* text : {&message.origin, &message.text, &message.remedy}) {
    *text = forPeople(std::move(*text));
  }
  message.pending = lasts || message.severity >= Severity::Error;
  if (isPending(message)) return std::nullopt;
  message.id = ++last_id_;
  messages_.push_back(std::move(message));
  if (messages_.size() > kMost) messages_.pop_front();
  return messages_.back();
}

bool MessageBoard::isPending(const Message& message) const {
  return std::any_of(messages_.begin(), messages_.end(),
                     [&](const Message& known) { return known.pending && isOfOneCause(known, message); });
}

bool MessageBoard::end(const std::string& origin, int code) {
  bool was_pending = false;
  for (Message& message : messages_) {
    const bool is_it = message.pending && message.origin == origin && message.code == code &&
                       message.severity < Severity::Error;
    if (!is_it) continue;
    message.pending = false;
    was_pending = true;
  }
  return was_pending;
}

std::size_t MessageBoard::acknowledge(const std::vector<MessageType>& still) {
  std::size_t count = 0;
  for (Message& message : messages_) {
    const bool stays = std::find(still.begin(), still.end(), message.type) != still.end();
    if (!message.pending || stays) continue;
    message.pending = false;
    ++count;
  }
  return count;
}

std::vector<Message> MessageBoard::pending() const {
  std::vector<Message> found;
  std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(found),
               [](const Message& message) { return message.pending; });
  return found;
}

std::vector<Message> MessageBoard::all(Severity least, std::uint32_t after_id) const {
  std::vector<Message> found;
  std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(found),
               [&](const Message& message) { return message.severity >= least && message.id > after_id; });
  return found;
}

std::size_t MessageBoard::countPending(Severity severity) const {
  return static_cast<std::size_t>(std::count_if(
      messages_.begin(), messages_.end(),
      [severity](const Message& message) { return message.pending && message.severity == severity; }));
}

}  // namespace cobot_command::command
