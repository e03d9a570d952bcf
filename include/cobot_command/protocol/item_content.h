// The three formats of items on the status port: BINARY, STRING and JSON (TM 3).
//
// What stands in a frame is first cut into items whose values are bytes in that format; which value the bytes
// mean depends on the type of the item, which the frame does not tell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/protocol/message.h"
#include "cobot_command/protocol/status_items.h"

namespace cobot_command::protocol {

/// Its number is the mode of the stream and of write requests; that of read requests is larger by 10.
enum class ItemFormat { Binary = 1, String = 2, Json = 3 };

/// A value of one of the types that items have. A predefined item has the same alternative always, and as
/// many elements.
using ItemValue = std::variant<bool, std::uint8_t, std::int32_t, float, double, std::string,
                               std::vector<bool>, std::vector<std::uint8_t>, std::vector<std::int32_t>,
                               std::vector<float>, std::vector<double>, std::vector<std::string>>;

/// What BINARY can say of one name or value [bytes].
inline constexpr std::size_t kMaxItemBytes = 65535;
/// Items of one request: ours, so that a short request cannot ask for an answer without end.
inline constexpr std::size_t kMaxRequestedItems = 1024;

/// 1 for what is no array.
[[nodiscard]] std::size_t elementCount(const ItemValue& value);

/// The value as it stands in a frame. In STRING and JSON a float has 7 digits if these make the same one,
/// else 9, a double 15 or 17; whole ones have `.0` in JSON. Strings are quoted; a quote within is doubled in
/// STRING. What JSON has no word for (not a number, no UTF-8) becomes null and U+FFFD.
[[nodiscard]] std::string encodeValue(ItemFormat format, const ItemValue& value);

/// The value that the bytes mean for an item of the type of `type`, with any number of elements; nothing when
/// they are no such value. A bool may be given as 0 and 1, a float as an integer; all numbers are finite.
[[nodiscard]] std::optional<ItemValue> parseValue(ItemFormat format, std::string_view bytes,
                                                  const ItemValue& type);

/// Adds an item to the content of a frame in BINARY, as encodeItems() would. False, and nothing is added, for
/// a value of more than kMaxItemBytes.
[[nodiscard]] bool appendBinaryItem(std::string& content, std::string_view name, const ItemValue& value);

/// The content of a frame of the stream, of a write request, or of the answer to a read request.
/// Precondition: the values are encodeValue() of that format; with BINARY, at most kMaxItemBytes each.
[[nodiscard]] std::string encodeItems(ItemFormat format, const std::vector<StatusItem>& items);
/// The values stay as they are written. Refused: content that is not of the format, nameless items, no item,
/// too many.
[[nodiscard]] Result<std::vector<StatusItem>, MessageFault> parseItems(ItemFormat format,
                                                                       std::string_view content);

/// The content of a read request: the names alone. Refused as above.
[[nodiscard]] Result<std::vector<std::string>, MessageFault> parseItemNames(ItemFormat format,
                                                                            std::string_view content);

}  // namespace cobot_command::protocol
