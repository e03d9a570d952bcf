#include "status_server.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "communication_error.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

using Code = protocol::StatusReply::Code;
using protocol::CommunicationErrorCode;
using protocol::StatusFrame;
using protocol::StatusMode;

StatusFrame reply(const StatusFrame& request, Code code, std::string item = {}) {
  return {request.id, static_cast<int>(StatusMode::Reply), protocol::toContent({code, std::move(item)})};
}

std::string described(const StatusFrame& frame) {
  return protocol::describe(protocol::Frame{std::string(protocol::header::kItems),
                                            fmt::format("{},{},{}", frame.id, frame.mode, frame.content)});
}

/// The names of a BINARY read request: repeated { u16 length, name }. Nothing when the lengths do not fit.
std::optional<std::vector<std::string>> requestedNames(std::string_view content) {
  std::vector<std::string> names;
  while (content.size() >= 2) {
    const auto low = static_cast<unsigned char>(content[0]);
    const auto high = static_cast<unsigned char>(content[1]);
    const std::size_t length = low + 256U * high;
    content.remove_prefix(2);
    if (length == 0 || length > content.size()) return std::nullopt;
    names.emplace_back(content.substr(0, length));
    content.remove_prefix(length);
  }
  if (names.empty() || !content.empty()) return std::nullopt;
  return names;
}

}  // namespace

StatusServer::StatusServer(Duration period, Instant start, Outgoing& outgoing, Outbox& outbox)
    : period_(std::max<Duration>(period, std::chrono::milliseconds(1))),
      start_(start),
      outgoing_(outgoing),
      outbox_(outbox) {}

void StatusServer::connected(ClientId client, Instant now) {
  if (decoders_.empty()) next_tick_ = (now - start_) / period_ + 1;
  decoders_.emplace(client, protocol::FrameDecoder());
  outbox_.log(fmt::format("status client {} connected", client));
}

void StatusServer::disconnected(ClientId client) {
  if (decoders_.erase(client) > 0) outbox_.log(fmt::format("status client {} disconnected", client));
  outgoing_.forget(client);
}

void StatusServer::closeAll() {
  for (const auto& [client, decoder] : decoders_) {
    outbox_.closeClient(Port::Status, client);
    outgoing_.forget(client);
  }
  decoders_.clear();
}

Instant StatusServer::nextEvent() const {
  return decoders_.empty() ? Instant::max() : start_ + next_tick_ * period_;
}

void StatusServer::stream(const ItemSource& source) {
  const StatusFrame frame{std::to_string(next_tick_++ % 10), static_cast<int>(StatusMode::WriteBinary),
                          protocol::encodeBinaryItems(streamedItems(source))};
  std::vector<ClientId> all;
  for (const auto& [client, decoder] : decoders_) all.push_back(client);
  outgoing_.send({Port::Status, MessageKind::Stream, protocol::encode(frame), {}}, all);
}

void StatusServer::received(ClientId client, std::string_view bytes, const ItemSource& source) {
  const auto found = decoders_.find(client);
  if (found == decoders_.end()) return;
  found->second.feed(bytes);
  while (const auto event = found->second.next()) {
    if (const auto* frame = std::get_if<protocol::Frame>(&*event)) {
      answer(client, *frame, source);
      continue;
    }
    const auto& fault = std::get<protocol::DecodeFault>(*event);
    outbox_.log(fmt::format("from {}: {}: {}", client, protocol::toString(fault.kind), fault.message));
    if (const auto code = codeFor(fault.kind)) refuseFrame(client, *code);
  }
}

void StatusServer::refuseFrame(ClientId client, CommunicationErrorCode code) {
  const protocol::ControllerMessage refusal = protocol::CommunicationError{code};
  outgoing_.send({Port::Status, MessageKind::Cperr, protocol::encode(refusal), protocol::describe(refusal)},
                 {client});
}

void StatusServer::answer(ClientId client, const protocol::Frame& frame, const ItemSource& source) {
  outbox_.log(fmt::format("from {}: {}", client, protocol::describe(frame)));
  if (frame.header != protocol::header::kItems) return refuseFrame(client, CommunicationErrorCode::Header);
  const auto request = protocol::parseStatusFrame(frame);
  if (!request) return refuseFrame(client, CommunicationErrorCode::Data);
  const StatusFrame answer = answerTo(*request, source);
  outgoing_.send({Port::Status, MessageKind::ItemAnswer, protocol::encode(answer), described(answer)},
                 {client});
}

// Checks in the controller's order: mode, permission, content, existence (fact sheet chapter 3). The data
// table of this controller is BINARY and no client has write permission.
StatusFrame StatusServer::answerTo(const StatusFrame& request, const ItemSource& source) {
  switch (static_cast<StatusMode>(request.mode)) {
    case StatusMode::ReadBinary:
      return read(request, source);
    case StatusMode::WriteBinary:
      return reply(request, Code::WritePermission);
    default:
      return reply(request, Code::NotSupported);
  }
}

StatusFrame StatusServer::read(const StatusFrame& request, const ItemSource& source) {
  const auto names = requestedNames(request.content);
  if (!names) return reply(request, Code::InvalidData);
  std::vector<protocol::StatusItem> items;
  for (const std::string& name : *names) {
    auto item = itemNamed(name, source);
    if (!item) return reply(request, Code::NotExist, name);
    items.push_back(std::move(*item));
  }
  return {request.id, request.mode, protocol::encodeBinaryItems(items)};
}

}  // namespace cobot_command::simulator
