// The two links of one robot, on connections that the core asks for: every event of a connection is handed to
// the link that owns it, and one of a connection that nobody owns any more is counted.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/command/actions.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/status_link.h"

namespace cobot_command::command {

class Links : private link::Wire {
 public:
  /// Settings and actions have to live longer. `traced`: see CorePorts.
  Links(const link::LinkSettings& settings, std::vector<Action>& actions,
        std::function<bool(link::Channel)> traced = {});
  Links(const Links&) = delete;
  Links& operator=(const Links&) = delete;

  [[nodiscard]] link::ScriptLink& script() { return script_; }
  [[nodiscard]] const link::ScriptLink& script() const { return script_; }
  [[nodiscard]] link::StatusLink& status() { return status_; }
  [[nodiscard]] const link::StatusLink& status() const { return status_; }

  void opened(link::ConnectionId id, Instant now);
  void openFailed(link::ConnectionId id, const link::OpenFailure& failure, Instant now);
  void received(link::ConnectionId id, std::string_view bytes);
  void closed(link::ConnectionId id, const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  /// Events of connections that were closed or given up before.
  [[nodiscard]] std::uint64_t lateEvents() const { return late_events_; }

 private:
  link::ConnectionId open(link::Channel channel, const std::string& host, int port,
                          Duration timeout) override;
  void close(link::ConnectionId id) override;
  void send(link::ConnectionId id, std::string bytes) override;
  [[nodiscard]] bool isTraced(link::Channel channel) const override;
  void trace(Instant now, link::Channel channel, bool sent, std::string_view bytes,
             std::string meaning) override;

  template <typename Deliver>
  void deliver(link::ConnectionId id, Deliver to);

  std::vector<Action>& actions_;
  std::function<bool(link::Channel)> traced_;
  link::ConnectionId last_ = 0;
  link::ScriptLink script_;
  link::StatusLink status_;
  std::uint64_t late_events_ = 0;
};

}  // namespace cobot_command::command
