#include "links/links.h"

#include <utility>

#include "cobot_command/common/deadline.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::command {

Links::Links(const link::LinkSettings& settings, std::vector<Action>& actions,
             std::function<bool(link::Channel)> traced)
    : actions_(actions), traced_(std::move(traced)), script_(settings, *this), status_(settings, *this) {}

template <typename Deliver>
void Links::deliver(link::ConnectionId id, Deliver to) {
  if (script_.owns(id)) {
    to(script_);
  } else if (status_.owns(id)) {
    to(status_);
  } else {
    ++late_events_;
  }
}

void Links::opened(link::ConnectionId id, Instant now) {
  deliver(id, [&](auto& link) { link.opened(now); });
}

void Links::openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now) {
  deliver(id, [&](auto& link) { link.openFailed(failure, now); });
}

void Links::received(link::ConnectionId id, std::string_view bytes) {
  deliver(id, [&](auto& link) { link.received(bytes); });
}

void Links::closed(link::ConnectionId id, const std::string& reason, Instant now) {
  deliver(id, [&](auto& link) { link.closed(reason, now); });
}

void Links::advance(Instant now) {
  script_.advance(now);
  status_.advance(now);
}

std::optional<Instant> Links::nextDeadline() const {
  return earlier(script_.nextDeadline(), status_.nextDeadline());
}

// --- Wire.

link::ConnectionId Links::open(link::Channel channel, const std::string& host, int port, Duration timeout) {
  const link::ConnectionId id = ++last_;
  actions_.emplace_back(OpenConnection{id, channel, host, port, timeout});
  return id;
}

void Links::close(link::ConnectionId id) {
  actions_.emplace_back(CloseConnection{id});
}

void Links::send(link::ConnectionId id, std::string bytes) {
  actions_.emplace_back(SendBytes{id, std::move(bytes)});
}

bool Links::isTraced(link::Channel channel) const {
  return !traced_ || traced_(channel);
}

void Links::trace(Instant now, link::Channel channel, bool sent, std::string_view bytes,
                  std::string meaning) {
  actions_.emplace_back(FrameTraced{now, channel, sent, std::string(bytes), forPeople(std::move(meaning))});
}

}  // namespace cobot_command::command
