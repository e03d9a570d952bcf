// What the frames of port 5890 mean, as types, in both directions (TM 1.3 to 1.6).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/protocol/frame.h"

namespace cobot_command::protocol {

/// Client -> controller: run this script (one command a line). Id: isScriptId(). A controller takes "0" too,
/// as it only echoes the id; its reply would then look like ListenNodeEntered.
struct ScriptRequest {
  std::string id;
  std::string script;
};

/// Controller -> client: the flow entered the Listen node (TMSCT with id 0).
struct ListenNodeEntered {
  std::string message;
};

/// Controller -> client: id,OK[;warning lines] or id,ERROR;error lines. Lines count from 1.
struct ScriptReply {
  std::string id;
  bool accepted = false;
  std::vector<int> lines;  ///< warnings when accepted, errors when not
};

/// TMSTA 00, asked: is the flow in a Listen node?
struct ListenNodeQuery {};
/// TMSTA 00, answered. The message may hold commas.
struct ListenNodeState {
  bool listening = false;
  std::string message;
};

enum class TagState { Incomplete, Complete, Unknown };  ///< false, true, none

/// TMSTA 01, asked. Outside 1..15 the controller answers none.
struct TagQuery {
  int tag = 0;
};
/// TMSTA 01, answered or sent spontaneously when the tag completes.
struct TagReport {
  int tag = 0;
  TagState state = TagState::Unknown;
};

/// TMSTA 90..99: what a script sent with ListenSend(). Any bytes.
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

/// CPERR, a code of the list above: carries no id, so it belongs to the oldest frame that has no answer yet.
struct CommunicationError {
  CommunicationErrorCode code = CommunicationErrorCode::Ok;
};

/// A frame whose header is known but whose data means nothing: for a controller CPERR 04 (or 03, for an
/// unknown header).
struct MessageFault {
  enum class Kind { UnknownHeader, Data };
  Kind kind = Kind::Data;
  std::string message;  ///< found, expected
};

using ClientMessage = std::variant<ScriptRequest, ListenNodeQuery, TagQuery>;
using ControllerMessage =
    std::variant<ListenNodeEntered, ScriptReply, ListenNodeState, TagReport, ListenData, CommunicationError>;

/// What a client sent to the controller.
[[nodiscard]] Result<ClientMessage, MessageFault> parseClientMessage(const Frame& frame);
/// What the controller sent to a client.
[[nodiscard]] Result<ControllerMessage, MessageFault> parseControllerMessage(const Frame& frame);

/// The bytes of a message, ready for the wire.
[[nodiscard]] std::string encode(const ClientMessage& message);
[[nodiscard]] std::string encode(const ControllerMessage& message);

/// One line for people: "script 12 accepted", "tag 3 complete", "not in a Listen node", "controller: checksum
/// error".
[[nodiscard]] std::string describe(const ClientMessage& message);
[[nodiscard]] std::string describe(const ControllerMessage& message);
/// The meaning of any frame of either port and either direction, or why it means nothing.
[[nodiscard]] std::string describe(const Frame& frame);

/// What a client may use as id of a script: one or more of A-Z a-z 0-9, not "0", which is the controller's
/// own.
[[nodiscard]] bool isScriptId(std::string_view id);

}  // namespace cobot_command::protocol
