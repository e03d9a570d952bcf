#include "wire/outgoing.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

/// The two digits of the checksum stand before the line end.
void spoilChecksum(std::string& frame) {
  char& digit = frame.at(frame.size() - 3);
  digit = digit == '0' ? '1' : '0';
}

}  // namespace

void Outgoing::send(Message message, std::vector<ClientId> clients) {
  if (clients.empty()) return;
  MessageFaults& faults = faults_.of(message.kind);
  if (message.port == Port::Script && faults_.silence.on) return logFault("not sent", message);
  if (faults.drop.take()) return logFault("not sent", message);
  Late letter{std::move(message), std::move(clients), 1};
  if (faults.corrupt.take()) {
    logFault("sent with a wrong checksum", letter.message);
    spoilChecksum(letter.message.bytes);
  }
  if (faults.duplicate.take()) {
    logFault("sent twice", letter.message);
    letter.copies = 2;
  }
  const Duration delay = fromSeconds(faults.delay.seconds);
  if (!faults.delay.take()) return put(std::move(letter));
  logFault("sent later", letter.message);
  late_.emplace(outbox_.now() + delay, std::move(letter));
}

void Outgoing::put(Late letter) {
  auto& [message, clients, copies] = letter;
  std::size_t left = clients.size() * static_cast<std::size_t>(copies);
  for (const ClientId client : clients) {
    for (int copy = 0; copy < copies; ++copy) {
      outbox_.send(message.port, client, --left == 0 ? std::exchange(message.bytes, {}) : message.bytes);
    }
    if (!message.text.empty()) outbox_.log(fmt::format("to {}: {}", client, message.text));
  }
}

void Outgoing::logFault(const char* what, const Message& message) {
  if (!message.text.empty()) outbox_.log(fmt::format("fault: {}: {}", what, message.text));
}

void Outgoing::forget(ClientId client) {
  for (auto& [due, letter] : late_) {
    auto& clients = letter.clients;
    clients.erase(std::remove(clients.begin(), clients.end(), client), clients.end());
  }
}

Instant Outgoing::nextEvent() const {
  return late_.empty() ? Instant::max() : late_.begin()->first;
}

void Outgoing::deliver() {
  while (nextEvent() <= outbox_.now()) {
    Late letter = std::move(late_.begin()->second);
    late_.erase(late_.begin());
    put(std::move(letter));
  }
}

}  // namespace cobot_command::simulator
