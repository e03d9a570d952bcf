#include "script_clients.h"

#include <fmt/format.h>

namespace cobot_command::simulator {

void ScriptClients::connect(ClientId client) {
  decoders_.emplace(client, protocol::FrameDecoder(options_));
  outbox_.log(fmt::format("script client {} connected", client));
}

void ScriptClients::disconnect(ClientId client) {
  if (decoders_.erase(client) > 0) outbox_.log(fmt::format("script client {} disconnected", client));
}

void ScriptClients::closeAll() {
  for (const auto& [client, decoder] : decoders_) outbox_.closeClient(Port::Script, client);
  decoders_.clear();
}

void ScriptClients::feed(ClientId client, std::string_view bytes) {
  const auto found = decoders_.find(client);
  if (found != decoders_.end()) found->second.feed(bytes);
}

std::optional<protocol::DecodeEvent> ScriptClients::next(ClientId client) {
  const auto found = decoders_.find(client);
  return found == decoders_.end() ? std::nullopt : found->second.next();
}

void ScriptClients::reply(ClientId client, const protocol::ControllerMessage& message) {
  if (decoders_.count(client) == 0) return;
  outbox_.send(Port::Script, client, protocol::encode(message));
  outbox_.log(fmt::format("to {}: {}", client, protocol::describe(message)));
}

void ScriptClients::broadcast(const protocol::ControllerMessage& message) {
  for (const auto& [client, decoder] : decoders_) reply(client, message);
}

}  // namespace cobot_command::simulator
