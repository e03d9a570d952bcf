// Any DATA of a TMSVR frame, and any content: items that are written back the same, or a fault.
#include <cstdint>
#include <string_view>

#include "require.h"

#include "cobot_command/protocol/item_content.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

using namespace cobot_command::protocol;

namespace {

/// Items of any format are written back as the same items; a value as the same value.
void tryItems(ItemFormat format, std::string_view bytes) {
  static_cast<void>(parseItemNames(format, bytes));
  const auto items = parseItems(format, bytes);
  if (!items) return;
  const auto again = parseItems(format, encodeItems(format, *items));
  REQUIRE(again.has_value() && *again == *items);
  for (const StatusItem& item : *items) {
    for (const ItemValue& type : {ItemValue(false), ItemValue(0.0F), ItemValue(std::vector<std::string>())}) {
      const auto value = parseValue(format, item.value, type);
      if (value) REQUIRE(parseValue(format, encodeValue(format, *value), type) == value);
    }
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto items = parseBinaryItems(bytes)) REQUIRE(encodeBinaryItems(*items) == bytes);
  for (const ItemFormat format : {ItemFormat::Binary, ItemFormat::String, ItemFormat::Json}) {
    tryItems(format, bytes);
  }
  if (const auto reply = parseStatusReply(bytes)) REQUIRE(parseStatusReply(toContent(*reply)).has_value());
  const Frame frame{std::string(header::kItems), std::string(bytes)};
  REQUIRE(!describe(frame).empty());
  if (const auto status = parseStatusFrame(frame)) {
    if (const auto items = parseBinaryItems(status->content)) {
      REQUIRE(encodeBinaryItems(*items) == status->content);
    }
  }
  return 0;
}
