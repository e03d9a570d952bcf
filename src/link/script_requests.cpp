#include "cobot_command/link/script_requests.h"

namespace cobot_command::link {

void ScriptRequests::dropNodeQueries() {
  while (ledger_.takeNodeQuery()) {
  }
}

std::optional<ScriptAnswer> ScriptRequests::take(const protocol::ScriptReply& message) {
  if (ledger_.takeScript(message.id)) return ScriptAnswered{message.id, message};
  ++late_;
  return std::nullopt;
}

std::optional<ScriptAnswer> ScriptRequests::take(const protocol::TagReport& message) {
  const auto question = ledger_.takeTagQuery(message.tag);
  if (question && question->given_up && message.state != protocol::TagState::Complete) {
    ++late_;  // what is complete stays so, anything else may have changed since
    return std::nullopt;
  }
  return TagReported{message.tag, question.has_value(), message.state};
}

std::optional<ScriptAnswer> ScriptRequests::take(const protocol::CommunicationError& message) {
  const bool not_listening = message.code == protocol::CommunicationErrorCode::NotListening;
  // F1 can only be meant for a script; any other code may be meant for whatever was sent.
  const auto request = not_listening ? ledger_.takeOldestScript() : ledger_.takeOldest();
  if (!request) {
    ++late_;
    return std::nullopt;
  }
  if (request->kind == Request::Kind::Script) return ScriptAnswered{request->script_id, message};
  if (request->kind == Request::Kind::TagQuery) {
    return TagQueryFailed{request->tag, protocol::describe(message)};
  }
  return std::nullopt;
}

bool ScriptRequests::takeNodeState() {
  if (ledger_.takeNodeQuery()) return true;
  ++late_;
  return false;
}

std::optional<ScriptAnswer> ScriptRequests::takeExpired(Instant now) {
  const auto request = ledger_.takeExpired(now);
  if (!request) return std::nullopt;
  if (request->kind == Request::Kind::Script) return ScriptAnswered{request->script_id, NoReply{}};
  return TagQueryFailed{request->tag, "no answer"};
}

}  // namespace cobot_command::link
