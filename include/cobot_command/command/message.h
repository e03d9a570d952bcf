// What people have to know of the layer, the controller and the arm: kept, and pending until that is over or
// acknowledged. Severities and kinds have the numbers of SRCI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cobot_command/common/time.h"

namespace cobot_command::command {

enum class Severity { Off = 0, Debug = 4, Info = 5, Warning = 20, Error = 28, Fatal = 29 };
[[nodiscard]] const char* toString(Severity severity);

/// Of what it is.
enum class MessageType {
  Interface = 1,   ///< the connection, and this layer
  Controller = 2,  ///< the robot's
  Arm = 3,
  Command = 4  ///< of a client
};

struct Message {
  std::uint32_t id = 0;  ///< from 1 on, increasing; of the same run of the layer
  Instant time{};        ///< when it was raised
  Severity severity = Severity::Info;
  MessageType type = MessageType::Interface;
  int code = 0;        ///< an ErrorID, or the controller's Error_Code; 0: none
  std::string origin;  ///< block, or part of the cell
  std::string text;
  std::string remedy;    ///< what to do; empty: nothing has to be done
  bool pending = false;  ///< an error until it is acknowledged, a warning until its cause is gone

  friend bool operator==(const Message& a, const Message& b) {
    return a.id == b.id && a.time == b.time && a.severity == b.severity && a.type == b.type &&
           a.code == b.code && a.origin == b.origin && a.text == b.text && a.remedy == b.remedy &&
           a.pending == b.pending;
  }
};

/// What became of a reset: all errors and warnings are acknowledged, but for what is wrong still.
struct ResetAnswer {
  bool success = false;
  int acknowledged = 0;
  std::string message;           ///< what is left, and what to do, in plain words
  std::vector<Message> pending;  ///< what is left
};

}  // namespace cobot_command::command
