// The item stream of the Ethernet Slave, port 5891 (TMSVR; TM 3).
//
// DATA = Id,Mode,Content. This header has the BINARY format, which the vendor's ROS driver needs, and the
// replies of mode 0.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/protocol/frame.h"
#include "cobot_command/protocol/message.h"

namespace cobot_command::protocol {

/// One item: its name and its value as bytes, little endian, as on the wire.
struct StatusItem {
  std::string name;
  std::string value;

  friend bool operator==(const StatusItem& a, const StatusItem& b) {
    return a.name == b.name && a.value == b.value;
  }
};

/// Creates items of the wire types: bool and byte have 1 byte, int and float 4 bytes; float[n]; string is raw
/// UTF-8.
namespace item {
[[nodiscard]] StatusItem ofByte(std::string name, std::uint8_t value);
[[nodiscard]] StatusItem ofBool(std::string name, bool value);
[[nodiscard]] StatusItem ofInt(std::string name, std::int32_t value);
[[nodiscard]] StatusItem ofFloat(std::string name, float value);
[[nodiscard]] StatusItem ofFloats(std::string name, const std::vector<float>& values);
[[nodiscard]] StatusItem ofString(std::string name, std::string value);

/// Reads an item of that type; std::nullopt if its size does not fit.
[[nodiscard]] std::optional<std::uint8_t> asByte(const StatusItem& item);
[[nodiscard]] std::optional<bool> asBool(const StatusItem& item);
[[nodiscard]] std::optional<std::int32_t> asInt(const StatusItem& item);
[[nodiscard]] std::optional<float> asFloat(const StatusItem& item);
[[nodiscard]] std::optional<std::vector<float>> asFloats(const StatusItem& item);
}  // namespace item

enum class StatusMode {
  Reply = 0,
  WriteBinary = 1,
  WriteString = 2,
  WriteJson = 3,
  ReadBinary = 11,
  ReadString = 12,
  ReadJson = 13
};

/// A TMSVR frame with undecoded content. The mode is as on the wire and may be unknown.
struct StatusFrame {
  std::string id;
  int mode = 0;
  std::string content;
};

[[nodiscard]] Result<StatusFrame, MessageFault> parseStatusFrame(const Frame& frame);
[[nodiscard]] std::string encode(const StatusFrame& frame);

/// The content of a BINARY frame (mode 1, or the reply of mode 11).
[[nodiscard]] Result<std::vector<StatusItem>, MessageFault> parseBinaryItems(std::string_view content);
[[nodiscard]] std::string encodeBinaryItems(const std::vector<StatusItem>& items);
/// The content of a read request for these items (mode 11). Precondition: there is at least one name, and
/// none is empty.
[[nodiscard]] std::string encodeBinaryNames(const std::vector<std::string>& names);

/// Mode 0: the result of a request. Codes: TM 3.
struct StatusReply {
  enum class Code {
    Ok = 0,
    NotSupported = 1,
    WritePermission = 2,
    InvalidData = 3,
    NotExist = 4,
    ReadOnly = 5,
    ModeError = 6,
    ValueError = 7
  };
  Code code = Code::Ok;
  std::string item;  ///< the first invalid item, if one is named
};
[[nodiscard]] Result<StatusReply, MessageFault> parseStatusReply(std::string_view content);
[[nodiscard]] std::string toContent(const StatusReply& reply);

}  // namespace cobot_command::protocol
