// A proxy between a command layer and a controller, on both ports, that does to the traffic what networks,
// peers and people do: see frame_faults.h.
//
// It takes the stream apart into frames and passes them on one by one; what is no frame is passed on as it
// comes. It has a thread of its own.
#pragma once

#include <cstddef>
#include <memory>

#include "frame_faults.h"

namespace cobot_command::testing {

struct ProxyPorts {
  int script = 0;
  int status = 0;
};

/// Thread-safe.
class FaultProxy {
 public:
  enum class Port { Script, Status };
  /// Serves the loopback, on free ports unless `listen` says which, and passes on to the controller on these
  /// ports of the loopback. Throws when a port cannot be had.
  FaultProxy(ProxyPorts controller, unsigned seed, ProxyPorts listen = {});
  ~FaultProxy();
  FaultProxy(const FaultProxy&) = delete;
  FaultProxy& operator=(const FaultProxy&) = delete;

  [[nodiscard]] ProxyPorts ports() const;

  /// In force when it returns, for all connections of the port, those that there are too.
  void add(Port port, const Fault& fault);
  /// No faults any more: ports are open, frames pass, what was left unread is read, and connections that led
  /// nowhere are closed. What was delayed is still late.
  void heal();
  /// Drops all connections (RST).
  void reset();

  /// Frames that were struck on both ports.
  [[nodiscard]] std::size_t strikes() const;
  /// Connections that there are on both ports.
  [[nodiscard]] std::size_t connections() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::testing
