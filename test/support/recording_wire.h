// A wire that remembers what a link asked for.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/link/wire.h"

namespace cobot_command::testing {

class RecordingWire : public link::Wire {
 public:
  link::ConnectionId open(link::Channel /*channel*/, const std::string& host, int port,
                          Duration /*timeout*/) override {
    opened.push_back(host + ":" + std::to_string(port));
    return ++last_id;
  }
  void close(link::ConnectionId id) override { closed.push_back(id); }
  void send(link::ConnectionId /*id*/, std::string bytes) override { sent.push_back(std::move(bytes)); }
  [[nodiscard]] bool isTraced(link::Channel /*channel*/) const override { return true; }
  void trace(Instant /*now*/, link::Channel /*channel*/, bool /*sent*/, std::string_view bytes,
             std::string meaning) override {
    traced.push_back(std::string(bytes) + " | " + meaning);
  }

  link::ConnectionId last_id = 0;
  std::vector<std::string> opened;
  std::vector<link::ConnectionId> closed;
  std::vector<std::string> sent;
  std::vector<std::string> traced;
};

}  // namespace cobot_command::testing
