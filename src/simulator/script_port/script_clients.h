// Who is connected to the script port, and what is said to them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "wire/outgoing.h"

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::simulator {

class ScriptClients {
 public:
  ScriptClients(protocol::FrameDecoder::Options options, FaultSwitches& faults, Outgoing& outgoing,
                Outbox& outbox)
      : options_(options), faults_(faults), outgoing_(outgoing), outbox_(outbox) {}

  void connect(ClientId client);
  void disconnect(ClientId client);
  void closeAll();
  [[nodiscard]] bool empty() const { return clients_.empty(); }

  void feed(ClientId client, std::string_view bytes);
  /// The next whole frame or fault of that client; nothing too when it is not connected.
  [[nodiscard]] std::optional<protocol::DecodeEvent> next(ClientId client);

  /// To one client; into the void when it is gone.
  void reply(ClientId client, const protocol::ControllerMessage& message);
  /// To all clients, in the order of their ids.
  void broadcast(const protocol::ControllerMessage& message);

 private:
  struct Client {
    protocol::FrameDecoder decoder;
    bool deaf = false;  ///< it was greeted by an impostor
  };

  protocol::FrameDecoder::Options options_;
  FaultSwitches& faults_;
  Outgoing& outgoing_;
  Outbox& outbox_;
  std::map<ClientId, Client> clients_;
};

}  // namespace cobot_command::simulator
