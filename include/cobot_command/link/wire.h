// The interface of a link to the owner of the sockets, for connections and for the trace of the traffic.
#pragma once

#include <string>
#include <string_view>

#include "cobot_command/common/time.h"
#include "cobot_command/link/connection.h"

namespace cobot_command::link {

class Wire {
 public:
  Wire() = default;
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;
  virtual ~Wire() = default;

  /// Starts to open a connection and gives it a new id. The link is notified of the result later, never
  /// within this call. The same applies to all functions below.
  virtual ConnectionId open(Channel channel, const std::string& host, int port, Duration timeout) = 0;
  /// Closes a connection or gives up opening it: no more events of it follow.
  virtual void close(ConnectionId id) = 0;
  virtual void send(ConnectionId id, std::string bytes) = 0;
  /// The flight recorder has a subscriber; without one, frames need no description.
  [[nodiscard]] virtual bool isTraced(Channel channel) const = 0;
  /// A frame or a faulty part of the stream, for the flight recorder.
  virtual void trace(Instant now, Channel channel, bool sent, std::string_view bytes,
                     std::string meaning) = 0;
};

}  // namespace cobot_command::link
