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

StatusServer::StatusServer(Duration period, Instant start, Outbox& outbox)
    : period_(std::max<Duration>(period, std::chrono::milliseconds(1))), start_(start), outbox_(outbox) {}

void StatusServer::connected(ClientId client, Instant now) {
  if (decoders_.empty()) next_tick_ = (now - start_) / period_ + 1;
  decoders_.emplace(client, protocol::FrameDecoder());
  outbox_.log(fmt::format("status client {} connected", client));
}

void StatusServer::disconnected(ClientId client) {
  if (decoders_.erase(client) > 0) outbox_.log(fmt::format("status client {} disconnected", client));
}

Instant StatusServer::nextEvent() const {
  return decoders_.empty() ? Instant::max() : start_ + next_tick_ * period_;
}

void StatusServer::stream(const ItemSource& source) {
  const StatusFrame frame{std::to_string(next_tick_++ % 10), static_cast<int>(StatusMode::WriteBinary),
                          protocol::encodeBinaryItems(streamedItems(source))};
  const std::string bytes = protocol::encode(frame);
  for (const auto& [client, decoder] : decoders_) outbox_.send(Port::Status, client, bytes);
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
    const auto code = codeFor(std::get<protocol::DecodeFault>(*event).kind);
    if (code) refuseFrame(client, *code);
  }
}

void StatusServer::refuseFrame(ClientId client, CommunicationErrorCode code) {
  outbox_.send(Port::Status, client, protocol::encode(protocol::CommunicationError{code}));
}

void StatusServer::answer(ClientId client, const protocol::Frame& frame, const ItemSource& source) {
  if (frame.header != protocol::header::kItems) return refuseFrame(client, CommunicationErrorCode::Header);
  const auto request = protocol::parseStatusFrame(frame);
  if (!request) return refuseFrame(client, CommunicationErrorCode::Data);
  outbox_.send(Port::Status, client, protocol::encode(answerTo(*request, source)));
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
