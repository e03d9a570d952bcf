// Any DATA of a TMSVR frame, and any content: items that are written back the same, or a fault.
#include <cstdint>
#include <string_view>

#include "require.h"

#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

using namespace cobot_command::protocol;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto items = parseBinaryItems(bytes)) REQUIRE(encodeBinaryItems(*items) == bytes);
  if (const auto reply = parseStatusReply(bytes)) REQUIRE(parseStatusReply(toContent(*reply)).has_value());
  const Frame frame{std::string(header::kItems), std::string(bytes)};
  REQUIRE(!describe(frame).empty());
  if (const auto status = parseStatusFrame(frame)) {
    if (const auto items = parseBinaryItems(status->content))
      REQUIRE(encodeBinaryItems(*items) == status->content);
  }
  return 0;
}
