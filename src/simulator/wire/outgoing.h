// What goes to clients, and what the faults of the world do to it on the way: the one place for that.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "wire/outbox.h"

#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

struct Message {
  Port port;
  MessageKind kind;
  std::string bytes;
  std::string text;  ///< for the log; empty: not logged
};

class Outgoing {
 public:
  Outgoing(FaultSwitches& faults, Outbox& outbox) : faults_(faults), outbox_(outbox) {}

  /// To each of the clients, which all fare the same.
  void send(Message message, std::vector<ClientId> clients);
  /// Nothing more goes to a client that is gone.
  void forget(ClientId client);

  /// When the next delayed message is due; Instant::max() when there is none.
  [[nodiscard]] Instant nextEvent() const;
  /// Sends the delayed messages that are due.
  void deliver();

 private:
  struct Late {
    Message message;
    std::vector<ClientId> clients;
    int copies = 1;
  };
  void put(Late letter);
  void logFault(const char* what, const Message& message);

  FaultSwitches& faults_;
  Outbox& outbox_;
  std::multimap<Instant, Late> late_;  // by the time at which they are due
};

}  // namespace cobot_command::simulator
