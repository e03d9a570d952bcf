// Typed messages of the frames of port 5890, in both directions (TM 1.3 to 1.6).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/protocol/frame.h"

namespace cobot_command::protocol {

/// Client -> controller: run this script (one command per line). The id must satisfy isScriptId(). A
/// controller also accepts "0" and only echoes the id; its reply would then look like ListenNodeEntered.
struct ScriptRequest {
  std::string id;
  std::string script;
};

/// Controller -> client: the flow has entered the Listen node (TMSCT with id 0).
struct ListenNodeEntered {
  std::string message;
};

/// Controller -> client: id,OK[;warning lines] or id,ERROR;error lines. Lines count from 1.
struct ScriptReply {
  std::string id;
  bool accepted = false;
  std::vector<int> lines;  ///< lines with warnings if accepted, with errors if not
};

/// TMSTA 00, query: is the flow in a Listen node?
struct ListenNodeQuery {};
/// TMSTA 00, answer. The message may contain commas.
struct ListenNodeState {
  bool listening = false;
  std::string message;
};

enum class TagState { Incomplete, Complete, Unknown };  ///< false, true, none

/// TMSTA 01, query. For a tag outside 1..15 the controller answers none.
struct TagQuery {
  int tag = 0;
};
/// TMSTA 01, answer, or sent spontaneously when the tag is complete.
struct TagReport {
  int tag = 0;
  TagState state = TagState::Unknown;
};

/// TMSTA 90..99: data that a script sent with ListenSend(). Any bytes.
struct ListenData {
  int channel = 90;
  std::string payload;
};

enum class CommunicationErrorCode {
  Ok = 0x00,
  Packet = 0x01,
  Checksum = 0x02,
  Header = 0x03,
  Data = 0x04,
  NotListening = 0xF1
};

/// CPERR with one of the codes above. It has no id, so it refers to the oldest unanswered frame.
struct CommunicationError {
  CommunicationErrorCode code = CommunicationErrorCode::Ok;
};

/// A frame with invalid data (the controller answers CPERR 04) or with an unknown header (CPERR 03).
struct MessageFault {
  enum class Kind { UnknownHeader, Data };
  Kind kind = Kind::Data;
  std::string message;  ///< found, expected
};

using ClientMessage = std::variant<ScriptRequest, ListenNodeQuery, TagQuery>;
using ControllerMessage =
    std::variant<ListenNodeEntered, ScriptReply, ListenNodeState, TagReport, ListenData, CommunicationError>;

/// Parses a message from a client to the controller.
[[nodiscard]] Result<ClientMessage, MessageFault> parseClientMessage(const Frame& frame);
/// Parses a message from the controller to a client.
[[nodiscard]] Result<ControllerMessage, MessageFault> parseControllerMessage(const Frame& frame);

/// The encoded frame of a message.
[[nodiscard]] std::string encode(const ClientMessage& message);
[[nodiscard]] std::string encode(const ControllerMessage& message);

/// One readable line: "script 12 accepted", "tag 3 complete", "not in a Listen node", "controller: checksum
/// error".
[[nodiscard]] std::string describe(const ClientMessage& message);
[[nodiscard]] std::string describe(const ControllerMessage& message);
/// The meaning of any frame, of both ports and both directions, or why it has none.
[[nodiscard]] std::string describe(const Frame& frame);

/// Valid script ids of a client: one or more of A-Z a-z 0-9, except "0", which the controller uses itself.
[[nodiscard]] bool isScriptId(std::string_view id);

}  // namespace cobot_command::protocol
