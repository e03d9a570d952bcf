// A misbehaving peer on a real port, on a thread of its own.
#pragma once

#include <memory>

#include "misbehaving_peers.h"

namespace cobot_command::testing {

/// Thread-safe.
class PeerServer {
 public:
  /// Serves the loopback on a free port.
  explicit PeerServer(MisbehavingPeer peer);
  ~PeerServer();
  PeerServer(const PeerServer&) = delete;
  PeerServer& operator=(const PeerServer&) = delete;

  [[nodiscard]] int port() const;
  /// Drops its clients, and is this peer for all that follow.
  void become(MisbehavingPeer peer);
  /// Waits until it had a client, and its first bytes, if there are any, were sent; false when there is none
  /// in time.
  [[nodiscard]] bool hasSpoken() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::testing
