// The lines for people: what a frame or a message says.
#include <algorithm>
#include <iterator>

#include "characters.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::protocol {

namespace {

constexpr std::size_t kMaxQuoted = 80;
constexpr std::size_t kMaxListed = 20;

std::string shortened(std::string_view text) {
  return foreignText(text, kMaxQuoted);
}

/// " and 5 more", when a list was cut.
std::string andMore(std::size_t count) {
  return count > kMaxListed ? fmt::format(" and {} more", count - kMaxListed) : "";
}

std::string lineList(const std::vector<int>& lines) {
  std::string text = lines.size() == 1 ? "line" : "lines";
  for (std::size_t i = 0; i < std::min(lines.size(), kMaxListed); ++i) {
    fmt::format_to(std::back_inserter(text), " {}", lines[i]);
  }
  return text + andMore(lines.size());
}

std::string described(const ScriptRequest& request) {
  std::string_view script = request.script;
  script.remove_prefix(std::min(script.find_first_not_of("\r\n"), script.size()));
  const auto further = std::count(script.begin(), script.end(), '\n');
  std::string_view first = takeUntil('\n', script);
  if (!first.empty() && first.back() == '\r') first.remove_suffix(1);
  std::string text = fmt::format("run script {}: {}", shortened(request.id), shortened(first));
  if (further > 0) {
    fmt::format_to(std::back_inserter(text), " (and {} more {})", further, further == 1 ? "line" : "lines");
  }
  return text;
}
std::string described(const ListenNodeQuery&) {
  return "in a Listen node?";
}
std::string described(const TagQuery& query) {
  return fmt::format("tag {} complete?", query.tag);
}
std::string described(const ListenNodeEntered& entered) {
  return "entered the Listen node: " + shortened(entered.message);
}
std::string described(const ScriptReply& reply) {
  std::string text =
      fmt::format("script {} {}", shortened(reply.id), reply.accepted ? "accepted" : "refused");
  if (reply.lines.empty()) return text;
  return text + (reply.accepted ? ", warnings in " : ", errors in ") + lineList(reply.lines);
}
std::string described(const ListenNodeState& state) {
  if (!state.listening) return "not in a Listen node";
  return state.message.empty() ? "in a Listen node" : "in a Listen node: " + shortened(state.message);
}
std::string described(const TagReport& report) {
  switch (report.state) {
    case TagState::Incomplete:
      return fmt::format("tag {} not complete", report.tag);
    case TagState::Complete:
      return fmt::format("tag {} complete", report.tag);
    case TagState::Unknown:
      return fmt::format("tag {} unknown", report.tag);
  }
  return {};
}
std::string described(const ListenData& data) {
  return fmt::format("script data on {}: {}", data.channel, shortened(data.payload));
}
std::string described(const CommunicationError& error) {
  switch (error.code) {
    case CommunicationErrorCode::Ok:
      return "controller: no error";
    case CommunicationErrorCode::Packet:
      return "controller: packet error";
    case CommunicationErrorCode::Checksum:
      return "controller: checksum error";
    case CommunicationErrorCode::Header:
      return "controller: unknown header";
    case CommunicationErrorCode::Data:
      return "controller: data error";
    case CommunicationErrorCode::NotListening:
      return "controller: not in a Listen node";
  }
  return {};
}

std::string names(const std::vector<StatusItem>& items) {
  std::string text;
  for (std::size_t i = 0; i < std::min(items.size(), kMaxListed); ++i) {
    text.append(text.empty() ? "" : ", ").append(foreignText(items[i].name, kQuoteLimit));
  }
  return text + andMore(items.size());
}

std::string described(const StatusFrame& frame) {
  const auto say = [&](std::string_view what, std::string_view content) {
    return fmt::format("{} {}: {}", what, shortened(frame.id), content);
  };
  const auto items = parseBinaryItems(frame.content);
  switch (static_cast<StatusMode>(frame.mode)) {
    case StatusMode::Reply:
      if (parseStatusReply(frame.content)) return say("answer to item request", shortened(frame.content));
      break;
    case StatusMode::WriteBinary:
      if (items) return say("binary items", names(*items));
      break;
    case StatusMode::ReadBinary:
      return say("binary items asked", items ? names(*items) : shortened(frame.content));
    case StatusMode::WriteString:
      return say("text items", shortened(frame.content));
    case StatusMode::ReadString:
      return say("text items asked", shortened(frame.content));
    case StatusMode::WriteJson:
      return say("JSON items", shortened(frame.content));
    case StatusMode::ReadJson:
      return say("JSON items asked", shortened(frame.content));
  }
  return fmt::format("item frame {} of mode {} with invalid content", shortened(frame.id), frame.mode);
}

}  // namespace

std::string describe(const ClientMessage& message) {
  return std::visit([](const auto& value) { return described(value); }, message);
}

std::string describe(const ControllerMessage& message) {
  return std::visit([](const auto& value) { return described(value); }, message);
}

std::string describe(const Frame& frame) {
  if (frame.header == header::kItems) {
    const auto items = parseStatusFrame(frame);
    return items ? described(*items) : items.error().message;
  }
  // A reply is told from a script by its words, so it is tried first: "1,OK" is no useful script.
  const auto from_controller = parseControllerMessage(frame);
  if (from_controller) return describe(*from_controller);
  const auto from_client = parseClientMessage(frame);
  if (from_client) return describe(*from_client);
  if (from_controller.error().kind == MessageFault::Kind::UnknownHeader) {
    return fmt::format("unknown header {}, known are TMSCT, TMSTA, TMSVR, CPERR", shortened(frame.header));
  }
  return from_client.error().kind == MessageFault::Kind::Data ? from_client.error().message
                                                              : from_controller.error().message;
}

}  // namespace cobot_command::protocol
