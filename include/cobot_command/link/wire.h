// What a link asks of whoever owns the sockets, and what it has to tell of the traffic.
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

  /// Starts to open a connection and gives it a new id. Its outcome is told to the link later, never inside
  /// of this call; the same holds for everything below.
  virtual ConnectionId open(Channel channel, const std::string& host, int port, Duration timeout) = 0;
  /// Closes a connection or gives up opening it: nothing is told of it any more.
  virtual void close(ConnectionId id) = 0;
  virtual void send(ConnectionId id, std::string bytes) = 0;
  /// Somebody listens to the flight recorder: what nobody reads is not described.
  [[nodiscard]] virtual bool isTraced(Channel channel) const = 0;
  /// A frame or a faulty piece of stream for the flight recorder.
  virtual void trace(Instant now, Channel channel, bool sent, std::string_view bytes,
                     std::string meaning) = 0;
};

}  // namespace cobot_command::link
