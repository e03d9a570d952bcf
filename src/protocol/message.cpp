#include "cobot_command/protocol/message.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <utility>

#include "characters.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::protocol {

namespace {

constexpr std::string_view kListenNodeEnteredId = "0";
constexpr std::string_view kListenNodeStateCommand = "00";
constexpr std::string_view kTagCommand = "01";
constexpr int kFirstChannel = 90;
constexpr int kLastChannel = 99;

constexpr std::array<std::pair<TagState, std::string_view>, 3> kTagStates{{
    {TagState::Incomplete, "false"},
    {TagState::Complete, "true"},
    {TagState::Unknown, "none"},
}};

constexpr std::array<CommunicationErrorCode, 6> kErrorCodes{
    CommunicationErrorCode::Ok,     CommunicationErrorCode::Packet, CommunicationErrorCode::Checksum,
    CommunicationErrorCode::Header, CommunicationErrorCode::Data,   CommunicationErrorCode::NotListening};

auto dataFault(std::string_view expected, std::string_view found) {
  return refuse(MessageFault{MessageFault::Kind::Data, fmt::format("expected {}, found \"{}\"", expected,
                                                                   foreignText(found, kQuoteLimit))});
}

auto unknownHeader(const Frame& frame, std::string_view known) {
  return refuse(MessageFault{
      MessageFault::Kind::UnknownHeader,
      fmt::format("header is {}, known here: {}", foreignText(frame.header, kQuoteLimit), known)});
}

Result<ClientMessage, MessageFault> parseScriptRequest(std::string_view data) {
  const std::size_t comma = data.find(',');
  if (comma == std::string_view::npos || !isAlphanumeric(data.substr(0, comma))) {
    return dataFault("a script id of letters and digits, ',' and a script", data);
  }
  return ClientMessage(
      ScriptRequest{std::string(data.substr(0, comma)), std::string(data.substr(comma + 1))});
}

Result<ClientMessage, MessageFault> parseStatusQuery(std::string_view data) {
  // The vendor's driver asks with an empty second field.
  if (data == kListenNodeStateCommand || data == "00,") return ClientMessage(ListenNodeQuery{});
  std::string_view fields = data;
  if (takeUntil(',', fields) == kTagCommand) {
    if (const auto tag = parseDigits(fields)) return ClientMessage(TagQuery{*tag});
  }
  return dataFault("00, or 01 and the number of a tag", data);
}

/// ";2;3": the lines with warnings or errors.
std::optional<std::vector<int>> parseLineNumbers(std::string_view text) {
  std::vector<int> lines;
  while (!text.empty()) {
    if (text.front() != ';') return std::nullopt;
    const std::size_t end = std::min(text.find(';', 1), text.size());
    const auto line = parseDigits(text.substr(1, end - 1));
    if (!line) return std::nullopt;
    lines.push_back(*line);
    text.remove_prefix(end);
  }
  return lines;
}

Result<ControllerMessage, MessageFault> parseScriptReply(std::string_view data) {
  constexpr std::string_view kOk = "OK";
  constexpr std::string_view kError = "ERROR";
  std::string_view verdict = data;
  const std::string_view id = takeUntil(',', verdict);
  if (id == kListenNodeEnteredId && id.size() < data.size()) {
    return ControllerMessage(ListenNodeEntered{std::string(verdict)});
  }
  for (const std::string_view word : {kOk, kError}) {
    if (!isAlphanumeric(id) || verdict.substr(0, word.size()) != word) continue;
    if (auto lines = parseLineNumbers(verdict.substr(word.size()))) {
      return ControllerMessage(ScriptReply{std::string(id), word == kOk, std::move(*lines)});
    }
  }
  return dataFault("0 and a message, or a script id and OK or ERROR;lines", data);
}

Result<ControllerMessage, MessageFault> parseStatusReport(std::string_view data) {
  std::string_view fields = data;
  const std::string_view command = takeUntil(',', fields);
  const bool has_fields = command.size() < data.size();
  if (command == kListenNodeStateCommand) {
    const std::string_view state = takeUntil(',', fields);
    if (state == "true" || state == "false") {
      return ControllerMessage(ListenNodeState{state == "true", std::string(fields)});
    }
  } else if (command == kTagCommand) {
    const auto tag = parseDigits(takeUntil(',', fields));
    const auto known = std::find_if(kTagStates.begin(), kTagStates.end(),
                                    [&](const auto& entry) { return entry.second == fields; });
    if (tag && known != kTagStates.end()) return ControllerMessage(TagReport{*tag, known->first});
  } else if (const auto channel = parseDigits(command); has_fields && channel.value_or(0) >= kFirstChannel &&
                                                        *channel <= kLastChannel && command.size() == 2) {
    return ControllerMessage(ListenData{*channel, std::string(fields)});
  }
  return dataFault("00 and a state, 01 with a tag and its state, or 90 to 99 and any bytes", data);
}

Result<ControllerMessage, MessageFault> parseCommunicationError(std::string_view data) {
  const auto value = data.size() == 2 ? parseDigits(data, 16) : std::nullopt;
  const auto code = static_cast<CommunicationErrorCode>(value.value_or(-1));
  if (std::find(kErrorCodes.begin(), kErrorCodes.end(), code) == kErrorCodes.end()) {
    return dataFault("an error code 00 to 04 or F1", data);
  }
  return ControllerMessage(CommunicationError{code});
}

std::string encoded(const ScriptRequest& request) {
  assert(isScriptId(request.id));
  return encodeFrame(header::kScript, request.id + ',' + request.script);
}
std::string encoded(const ListenNodeQuery&) {
  return encodeFrame(header::kStatus, kListenNodeStateCommand);
}
std::string encoded(const TagQuery& query) {
  assert(query.tag >= 0);
  return encodeFrame(header::kStatus, fmt::format("{},{:02}", kTagCommand, query.tag));
}
std::string encoded(const ListenNodeEntered& entered) {
  return encodeFrame(header::kScript, fmt::format("{},{}", kListenNodeEnteredId, entered.message));
}
std::string encoded(const ScriptReply& reply) {
  assert(isAlphanumeric(reply.id));
  std::string data = reply.id + (reply.accepted ? ",OK" : ",ERROR");
  for (const int line : reply.lines) fmt::format_to(std::back_inserter(data), ";{}", line);
  return encodeFrame(header::kScript, data);
}
std::string encoded(const ListenNodeState& state) {
  return encodeFrame(header::kStatus, fmt::format("{},{},{}", kListenNodeStateCommand,
                                                  state.listening ? "true" : "false", state.message));
}
std::string encoded(const TagReport& report) {
  assert(report.tag >= 0);
  const auto known = std::find_if(kTagStates.begin(), kTagStates.end(),
                                  [&](const auto& entry) { return entry.first == report.state; });
  return encodeFrame(header::kStatus, fmt::format("{},{:02},{}", kTagCommand, report.tag, known->second));
}
std::string encoded(const ListenData& data) {
  assert(data.channel >= kFirstChannel && data.channel <= kLastChannel);
  return encodeFrame(header::kStatus, std::to_string(data.channel) + ',' + data.payload);
}
std::string encoded(const CommunicationError& error) {
  return encodeFrame(header::kCommunicationError, fmt::format("{:02X}", static_cast<int>(error.code)));
}

}  // namespace

Result<ClientMessage, MessageFault> parseClientMessage(const Frame& frame) {
  if (frame.header == header::kScript) return parseScriptRequest(frame.data);
  if (frame.header == header::kStatus) return parseStatusQuery(frame.data);
  return unknownHeader(frame, "TMSCT, TMSTA");
}

Result<ControllerMessage, MessageFault> parseControllerMessage(const Frame& frame) {
  if (frame.header == header::kScript) return parseScriptReply(frame.data);
  if (frame.header == header::kStatus) return parseStatusReport(frame.data);
  if (frame.header == header::kCommunicationError) return parseCommunicationError(frame.data);
  return unknownHeader(frame, "TMSCT, TMSTA, CPERR");
}

std::string encode(const ClientMessage& message) {
  return std::visit([](const auto& value) { return encoded(value); }, message);
}

std::string encode(const ControllerMessage& message) {
  return std::visit([](const auto& value) { return encoded(value); }, message);
}

bool isScriptId(std::string_view id) {
  return isAlphanumeric(id) && id != kListenNodeEnteredId;
}

}  // namespace cobot_command::protocol
