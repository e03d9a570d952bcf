// Checksums, and the frames that are made with them.
#include <numeric>

#include "library/library.h"
#include <boost/crc.hpp>
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

std::uint32_t sumOf(const Bytes& bytes) {
  return std::accumulate(bytes.begin(), bytes.end(), std::uint32_t{0});
}

std::uint8_t xorOf(const Bytes& bytes) {
  return std::accumulate(
      bytes.begin(), bytes.end(), std::uint8_t{0},
      [](std::uint8_t sum, std::uint8_t byte) { return static_cast<std::uint8_t>(sum ^ byte); });
}

/// Of Modbus.
std::uint32_t crc16Of(const Bytes& bytes) {
  boost::crc_optimal<16, 0x8005, 0xFFFF, 0, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::uint32_t crc32Of(const Bytes& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

template <class Result>
Builtin ofBytes(std::uint32_t (*compute)(const Bytes&), std::uint32_t mask) {
  return [=](const Arguments& arguments) -> Computed {
    return Scalar(static_cast<Result>(compute(itemsAt<std::uint8_t>(arguments, 0)) & mask));
  };
}

/// $HEADER,LENGTH,DATA,*CS CR LF. An empty header is TMSCT.
Computed packet(const std::string& header, const std::string& data) {
  const std::string inside = fmt::format("{},{},{},", header.empty() ? "TMSCT" : header, data.size(), data);
  return Scalar(fmt::format("${}*{:02X}\r\n", inside, xorOf(bytesOf(inside))));
}

}  // namespace

void defineChecksumFunctions(FunctionTable& table) {
  table.define("byte XOR8(byte[])", kSinceEver, [](const Arguments& arguments) -> Computed {
    return Scalar(xorOf(itemsAt<std::uint8_t>(arguments, 0)));
  });
  table.define("byte SUM8(byte[])", kSinceEver, ofBytes<std::uint8_t>(sumOf, 0xFF));
  table.define("int SUM16(byte[])", kSinceEver, ofBytes<std::int32_t>(sumOf, 0xFFFF));
  table.define("int SUM32(byte[])", kSinceEver, ofBytes<std::int32_t>(sumOf, 0xFFFFFFFF));
  table.define("int CRC16(byte[])", kSinceEver, ofBytes<std::int32_t>(crc16Of, 0xFFFF));
  table.define("int CRC32(byte[])", kSinceEver, ofBytes<std::int32_t>(crc32Of, 0xFFFFFFFF));
  table.define("string ListenPacket(string, string)", kSinceEver,
               [](const Arguments& arguments) { return packet(textAt(arguments, 0), textAt(arguments, 1)); });
  table.define("string ListenPacket(string)", kSinceEver,
               [](const Arguments& arguments) { return packet("", textAt(arguments, 0)); });
}

}  // namespace cobot_command::tm_script
