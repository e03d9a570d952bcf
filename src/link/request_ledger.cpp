#include "cobot_command/link/request_ledger.h"

#include <algorithm>

namespace cobot_command::link {

template <class Predicate>
std::optional<Request> RequestLedger::takeFirst(Predicate matches) {
  const auto found = std::find_if(open_.begin(), open_.end(), matches);
  if (found == open_.end()) return std::nullopt;
  Request request = std::move(*found);
  open_.erase(found);
  return request;
}

std::optional<Request> RequestLedger::takeScript(std::string_view id) {
  return takeFirst([&](const Request& r) { return r.kind == Request::Kind::Script && r.script_id == id; });
}

std::optional<Request> RequestLedger::takeNodeQuery() {
  return takeFirst([](const Request& r) { return r.kind == Request::Kind::NodeQuery; });
}

std::optional<Request> RequestLedger::takeTagQuery(int tag) {
  return takeFirst([&](const Request& r) { return r.kind == Request::Kind::TagQuery && r.tag == tag; });
}

std::optional<Request> RequestLedger::takeOldest() {
  return takeFirst([](const Request&) { return true; });
}

std::optional<Request> RequestLedger::takeOldestScript() {
  return takeFirst([](const Request& r) { return r.kind == Request::Kind::Script; });
}

std::optional<Request> RequestLedger::takeExpired(Instant now) {
  for (Request& request : open_) {
    if (request.patience && !request.deadline) request.deadline = now + *request.patience;
  }
  return takeFirst([&](const Request& r) { return r.deadline && *r.deadline <= now; });
}

std::optional<Instant> RequestLedger::nextDeadline() const {
  std::optional<Instant> next;
  for (const Request& request : open_) {
    if (!request.patience) continue;
    const Instant due = request.deadline.value_or(request.handed_over);
    if (!next || due < *next) next = due;
  }
  return next;
}

}  // namespace cobot_command::link
