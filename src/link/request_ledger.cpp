#include "cobot_command/link/request_ledger.h"

#include <algorithm>

#include "cobot_command/common/deadline.h"

namespace cobot_command::link {

template <class Predicate>
RequestLedger::Open::iterator RequestLedger::findAwaited(Predicate matches) {
  return std::find_if(open_.begin(), open_.end(),
                      [&](const Request& request) { return !request.given_up && matches(request); });
}

std::optional<Request> RequestLedger::take(const Open::iterator& request) {
  if (request == open_.end()) return std::nullopt;
  Request taken = std::move(*request);
  open_.erase(request);
  return taken;
}

std::optional<Request> RequestLedger::giveUp(const Open::iterator& request) {
  if (request == open_.end() || request->kind != Request::Kind::TagQuery) return take(request);
  request->given_up = true;
  return *request;
}

bool RequestLedger::awaitsScript() const {
  return std::any_of(open_.begin(), open_.end(),
                     [](const Request& request) { return request.kind == Request::Kind::Script; });
}

std::optional<Request> RequestLedger::takeScript(std::string_view id) {
  return take(
      findAwaited([&](const Request& r) { return r.kind == Request::Kind::Script && r.script_id == id; }));
}

std::optional<Request> RequestLedger::takeNodeQuery() {
  const auto found = findAwaited([](const Request& r) { return r.kind == Request::Kind::NodeQuery; });
  if (found == open_.end()) return std::nullopt;
  const auto older = found - open_.begin();
  auto request = take(found);
  // Answers come in the order of the questions: those of before will not come any more.
  open_.erase(
      std::remove_if(open_.begin(), open_.begin() + older, [](const Request& r) { return r.given_up; }),
      open_.begin() + older);
  return request;
}

std::optional<Request> RequestLedger::takeTagQuery(int tag) {
  return take(std::find_if(open_.begin(), open_.end(), [&](const Request& r) {
    return r.kind == Request::Kind::TagQuery && r.tag == tag;
  }));
}

std::optional<Request> RequestLedger::takeOldest() {
  return giveUp(findAwaited([](const Request&) { return true; }));
}

std::optional<Request> RequestLedger::takeOldestScript() {
  return take(findAwaited([](const Request& r) { return r.kind == Request::Kind::Script; }));
}

std::optional<Request> RequestLedger::takeExpired(Instant now) {
  for (Request& request : open_) {
    if (request.patience && !request.deadline) request.deadline = now + *request.patience;
  }
  return giveUp(findAwaited([&](const Request& r) { return r.deadline && *r.deadline <= now; }));
}

std::optional<Instant> RequestLedger::nextDeadline() const {
  std::optional<Instant> next;
  for (const Request& request : open_) {
    if (!request.patience || request.given_up) continue;
    next = earlier(next, request.deadline.value_or(request.handed_over));
  }
  return next;
}

}  // namespace cobot_command::link
