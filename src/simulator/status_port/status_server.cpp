#include "status_port/status_server.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "wire/communication_error.h"
#include <fmt/format.h>

namespace cobot_command::simulator {

namespace {

using Code = protocol::StatusReply::Code;
using protocol::CommunicationErrorCode;
using protocol::ItemFormat;
using protocol::StatusFrame;
using protocol::StatusMode;

constexpr int kReadModes = 10;  // above the modes of the stream and of writing
constexpr std::size_t kLongestAnswer = std::size_t{1024} * 1024;  // bytes; ours

StatusFrame reply(const StatusFrame& request, Code code, std::string item = {}) {
  return {request.id, static_cast<int>(StatusMode::Reply), protocol::toContent({code, std::move(item)})};
}

std::string described(const StatusFrame& frame) {
  return protocol::describe(protocol::Frame{std::string(protocol::header::kItems),
                                            fmt::format("{},{},{}", frame.id, frame.mode, frame.content)});
}

std::string binaryContentOf(const std::vector<Item>& items, const ItemValues& values) {
  constexpr std::size_t kUsualItem = 32;  // bytes
  std::string content;
  content.reserve(items.size() * kUsualItem);
  for (const Item& item : items) {
    // A script can make a text that BINARY cannot say.
    static_cast<void>(protocol::appendBinaryItem(content, item.name, item.read(values)));
  }
  return content;
}

std::string contentOf(ItemFormat format, const std::vector<Item>& items, const ItemSource& source) {
  const ItemValues values(source);
  if (format == ItemFormat::Binary) return binaryContentOf(items, values);
  std::vector<protocol::StatusItem> found;
  found.reserve(items.size());
  for (const Item& item : items) {
    found.push_back({std::string(item.name), protocol::encodeValue(format, item.read(values))});
  }
  return protocol::encodeItems(format, found);
}

}  // namespace

StatusServer::StatusServer(const Settings& settings, const tm_script::Variables& variables, Instant start,
                           Outgoing& outgoing, Outbox& outbox)
    : period_(std::max<Duration>(settings.status_period, std::chrono::milliseconds(1))),
      start_(start),
      format_(settings.stream_format),
      writers_(settings.write_clients),
      table_(settings, variables),
      outgoing_(outgoing),
      outbox_(outbox) {}

void StatusServer::connected(ClientId client, std::string_view address, Instant now) {
  if (clients_.empty()) next_tick_ = (now - start_) / period_ + 1;
  const bool may_write = !writers_ || writers_->count(address) > 0;
  clients_.emplace(client, Client{protocol::FrameDecoder(), may_write});
  outbox_.log(
      fmt::format("status client {} connected{}", client, may_write ? "" : "; it is not allowed to write"));
}

void StatusServer::disconnected(ClientId client) {
  if (clients_.erase(client) > 0) outbox_.log(fmt::format("status client {} disconnected", client));
  outgoing_.forget(client);
}

void StatusServer::closeAll() {
  for (const auto& [id, client] : clients_) {
    outbox_.closeClient(Port::Status, id);
    outgoing_.forget(id);
  }
  clients_.clear();
}

Instant StatusServer::nextEvent() const {
  return clients_.empty() ? Instant::max() : start_ + next_tick_ * period_;
}

void StatusServer::stream(const ItemSource& source) {
  const std::vector<Item>& items = table_.stream();
  const StatusFrame frame{std::to_string(next_tick_++ % 10), static_cast<int>(format_),
                          source.hidden.on ? contentOf(format_, shown(items, source.hidden), source)
                                           : contentOf(format_, items, source)};
  std::vector<ClientId> all;
  for (const auto& [id, client] : clients_) all.push_back(id);
  outgoing_.send({Port::Status, MessageKind::Stream, protocol::encode(frame), {}}, std::move(all));
}

void StatusServer::feed(ClientId client, std::string_view bytes) {
  const auto found = clients_.find(client);
  if (found != clients_.end()) found->second.decoder.feed(bytes);
}

bool StatusServer::answerNext(ClientId client, const ItemSource& source) {
  const auto found = clients_.find(client);
  if (found == clients_.end()) return false;
  const auto event = found->second.decoder.next();
  if (!event) return false;
  if (const auto* frame = std::get_if<protocol::Frame>(&*event)) {
    answer(client, found->second, *frame, source);
    return true;
  }
  const auto& fault = std::get<protocol::DecodeFault>(*event);
  outbox_.log(fmt::format("from {}: {}: {}", client, protocol::toString(fault.kind), fault.message));
  if (const auto code = codeFor(fault.kind)) refuseFrame(client, *code);
  return true;
}

void StatusServer::refuseFrame(ClientId client, CommunicationErrorCode code) {
  const protocol::ControllerMessage refusal = protocol::CommunicationError{code};
  outgoing_.send({Port::Status, MessageKind::Cperr, protocol::encode(refusal), protocol::describe(refusal)},
                 {client});
}

void StatusServer::answer(ClientId id, const Client& client, const protocol::Frame& frame,
                          const ItemSource& source) {
  outbox_.log(fmt::format("from {}: {}", id, protocol::describe(frame)));
  if (frame.header != protocol::header::kItems) return refuseFrame(id, CommunicationErrorCode::Header);
  const auto request = protocol::parseStatusFrame(frame);
  if (!request) return refuseFrame(id, CommunicationErrorCode::Data);
  const StatusFrame answer = answerTo(*request, client.may_write, source);
  outgoing_.send({Port::Status, MessageKind::ItemAnswer, protocol::encode(answer), described(answer)}, {id});
}

// Checks in the controller's order: mode, permission, content, existence, read-only, operating mode, value
// (TM 3); each of all items before the next.
StatusFrame StatusServer::answerTo(const StatusFrame& request, bool may_write, const ItemSource& source) {
  switch (static_cast<StatusMode>(request.mode)) {
    case StatusMode::ReadBinary:
    case StatusMode::ReadString:
    case StatusMode::ReadJson:
      return read(request, static_cast<ItemFormat>(request.mode - kReadModes), source);
    case StatusMode::WriteBinary:
    case StatusMode::WriteString:
    case StatusMode::WriteJson:
      if (!may_write) return reply(request, Code::WritePermission);
      return write(request, static_cast<ItemFormat>(request.mode), source);
    default:
      return reply(request, Code::NotSupported);
  }
}

StatusFrame StatusServer::read(const StatusFrame& request, ItemFormat format,
                               const ItemSource& source) const {
  const auto names = protocol::parseItemNames(format, request.content);
  if (!names) return refuseContent(request, names.error());
  std::vector<Item> items;
  for (const std::string& name : *names) {
    const auto item = table_.find(name, source);
    if (!item) return reply(request, Code::NotExist, name);
    items.push_back(*item);
  }
  std::string content = contentOf(format, items, source);
  if (content.size() > kLongestAnswer) return reply(request, Code::InvalidData);
  return {request.id, request.mode, std::move(content)};
}

StatusFrame StatusServer::write(const StatusFrame& request, ItemFormat format, const ItemSource& source) {
  const auto written = protocol::parseItems(format, request.content);
  if (!written) return refuseContent(request, written.error());
  std::vector<Item> items;
  for (const protocol::StatusItem& item : *written) {
    const auto found = table_.find(item.name, source);
    if (!found) return reply(request, Code::NotExist, item.name);
    items.push_back(*found);
  }
  const auto refused = [&](Code code, const auto& is_refused) -> std::optional<StatusFrame> {
    const auto item = std::find_if(items.begin(), items.end(), is_refused);
    if (item == items.end()) return std::nullopt;
    return reply(request, code, std::string(item->name));
  };
  if (auto frame =
          refused(Code::ReadOnly, [](const Item& item) { return item.access() == Access::ReadOnly; })) {
    return *frame;
  }
  const bool manual = source.state.mode == OperatingMode::Manual;
  if (auto frame = refused(Code::ModeError,
                           [&](const Item& item) { return manual && item.access() == Access::Automatic; })) {
    return *frame;
  }
  const ItemValues values(source);
  std::vector<ItemWrite> writes;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const protocol::ItemValue old = items[i].read(values);
    const auto value = protocol::parseValue(format, (*written)[i].value, old);
    auto write = value ? items[i].write(*value, old) : std::nullopt;
    if (!write) return reply(request, Code::ValueError, std::string(items[i].name));
    writes.push_back(std::move(*write));
  }
  std::move(writes.begin(), writes.end(), std::back_inserter(writes_));
  return reply(request, Code::Ok);
}

StatusFrame StatusServer::refuseContent(const StatusFrame& request,
                                        const protocol::MessageFault& fault) const {
  outbox_.log(fmt::format("invalid data: {}", fault.message));
  return reply(request, Code::InvalidData);
}

}  // namespace cobot_command::simulator
