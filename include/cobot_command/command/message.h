// Messages for people about the layer, the controller and the arm. They are stored, and pending until their
// cause is gone or they are acknowledged. Severities and types have the numbers of SRCI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cobot_command/common/time.h"

namespace cobot_command::command {

enum class Severity { Off = 0, Debug = 4, Info = 5, Warning = 20, Error = 28, Fatal = 29 };
[[nodiscard]] const char* toString(Severity severity);

/// Source of the message.
enum class MessageType {
  Interface = 1,  ///< the connection and this layer
  Controller = 2,
  Arm = 3,
  Command = 4  ///< a client's command
};

struct Message {
  /// From 1, increasing; unique within one run of the layer.
  std::uint32_t id = 0;
  Instant time{};  ///< when it was raised
  Severity severity = Severity::Info;
  MessageType type = MessageType::Interface;
  int code = 0;        ///< an ErrorID, or the controller's Error_Code; 0: none
  std::string origin;  ///< block, or part of the cell
  std::string text;
  std::string remedy;  ///< what to do; empty: nothing
  /// An error until it is acknowledged, a warning until its cause is gone.
  bool pending = false;

  friend bool operator==(const Message& a, const Message& b) {
    return a.id == b.id && a.time == b.time && a.severity == b.severity && a.type == b.type &&
           a.code == b.code && a.origin == b.origin && a.text == b.text && a.remedy == b.remedy &&
           a.pending == b.pending;
  }
};

/// Result of a reset: all errors and warnings are acknowledged, except those whose cause still exists.
struct ResetAnswer {
  bool success = false;
  int acknowledged = 0;
  std::string message;           ///< the remaining messages and what to do, in plain words
  std::vector<Message> pending;  ///< the remaining messages
};

}  // namespace cobot_command::command
