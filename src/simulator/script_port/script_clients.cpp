#include "script_port/script_clients.h"

#include <vector>

#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

/// Of a message to the one that asked.
MessageKind kindOf(const protocol::ControllerMessage& message) {
  if (std::holds_alternative<protocol::ScriptReply>(message)) return MessageKind::Reply;
  if (std::holds_alternative<protocol::ListenNodeState>(message)) return MessageKind::State;
  if (std::holds_alternative<protocol::TagReport>(message)) return MessageKind::TagAnswer;
  return MessageKind::Cperr;
}

/// Of a message to everybody.
MessageKind broadcastKindOf(const protocol::ControllerMessage& message) {
  return std::holds_alternative<protocol::TagReport>(message) ? MessageKind::Tag : MessageKind::Entry;
}

Message toMessage(MessageKind kind, const protocol::ControllerMessage& message) {
  return {Port::Script, kind, protocol::encode(message), protocol::describe(message)};
}

}  // namespace

void ScriptClients::connect(ClientId client) {
  outbox_.log(fmt::format("script client {} connected", client));
  if (faults_.close_on_connect.take()) return outbox_.closeClient(Port::Script, client);
  Client& added = clients_.try_emplace(client, Client{protocol::FrameDecoder(options_)}).first->second;
  const std::string greeting = faults_.impostor.text + "\r\n";
  if (!faults_.impostor.take()) return;
  added.deaf = true;
  outbox_.send(Port::Script, client, greeting);
  outbox_.log(fmt::format("fault: {} gets the greeting of another device", client));
}

void ScriptClients::disconnect(ClientId client) {
  if (clients_.erase(client) > 0) outbox_.log(fmt::format("script client {} disconnected", client));
  outgoing_.forget(client);
}

void ScriptClients::closeAll() {
  for (const auto& [id, client] : clients_) {
    outbox_.closeClient(Port::Script, id);
    outgoing_.forget(id);
  }
  clients_.clear();
}

void ScriptClients::feed(ClientId client, std::string_view bytes) {
  const auto found = clients_.find(client);
  if (found != clients_.end() && !found->second.deaf && !faults_.silence.on) {
    found->second.decoder.feed(bytes);
  }
}

std::optional<protocol::DecodeEvent> ScriptClients::next(ClientId client) {
  const auto found = clients_.find(client);
  return found == clients_.end() ? std::nullopt : found->second.decoder.next();
}

void ScriptClients::reply(ClientId client, const protocol::ControllerMessage& message) {
  const auto found = clients_.find(client);
  if (found == clients_.end() || found->second.deaf) return;
  const auto* script = std::get_if<protocol::ScriptReply>(&message);
  if (script != nullptr && faults_.wrong_id.take()) {
    protocol::ScriptReply strange = *script;
    strange.id += "x";
    return outgoing_.send(toMessage(MessageKind::Reply, strange), {client});
  }
  outgoing_.send(toMessage(kindOf(message), message), {client});
}

void ScriptClients::broadcast(const protocol::ControllerMessage& message) {
  std::vector<ClientId> all;
  for (const auto& [id, client] : clients_) {
    if (!client.deaf) all.push_back(id);
  }
  outgoing_.send(toMessage(broadcastKindOf(message), message), all);
}

}  // namespace cobot_command::simulator
