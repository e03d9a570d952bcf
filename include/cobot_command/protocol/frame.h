// One frame of the TM protocol: $HEADER,LENGTH,DATA,*CS\r\n (I848-E-03 section 7.3; thesis 4.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace cobot_command::protocol {

/// Upper limit of DATA, accepted or sent [bytes]. The controller documents only int32. A path in one frame
/// has up to 750 kB, so this limit leaves room and still bounds the memory that a peer can use.
inline constexpr std::size_t kMaxDataLength = std::size_t{16} * 1024 * 1024;

namespace header {
inline constexpr std::string_view kScript = "TMSCT";  ///< external script, port 5890
inline constexpr std::string_view kStatus = "TMSTA";  ///< status of the script control, port 5890
inline constexpr std::string_view kItems = "TMSVR";   ///< Ethernet Slave items, port 5891
inline constexpr std::string_view kCommunicationError = "CPERR";
}  // namespace header

/// A decoded frame. `header` may be unknown; the receiver checks it (CPERR 03).
struct Frame {
  std::string header;
  std::string data;

  friend bool operator==(const Frame& a, const Frame& b) { return a.header == b.header && a.data == b.data; }
};

/// XOR of all bytes. For a frame: of the bytes between '$' and '*'.
[[nodiscard]] std::uint8_t checksum(std::string_view bytes);

/// The frame as bytes, with decimal length and upper-case checksum. `data` may contain any bytes.
/// Preconditions: the header is not empty and has only letters; data.size() <= kMaxDataLength.
[[nodiscard]] std::string encodeFrame(std::string_view header, std::string_view data);
/// The same for DATA in parts, which are concatenated.
[[nodiscard]] std::string encodeFrame(std::string_view header, std::initializer_list<std::string_view> data);

}  // namespace cobot_command::protocol
