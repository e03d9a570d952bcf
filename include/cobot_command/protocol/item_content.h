// The three formats of items on the status port: BINARY, STRING and JSON (TM 3).
//
// The content of a frame is first divided into items; their values are bytes in that format. The meaning of
// the bytes depends on the type of the item, which the frame does not contain.
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

/// The number is the mode of the stream and of write requests. The mode of read requests is larger by 10.
enum class ItemFormat { Binary = 1, String = 2, Json = 3 };

/// A value of one of the item types. A predefined item always has the same alternative and the same number of
/// elements.
using ItemValue = std::variant<bool, std::uint8_t, std::int32_t, float, double, std::string,
                               std::vector<bool>, std::vector<std::uint8_t>, std::vector<std::int32_t>,
                               std::vector<float>, std::vector<double>, std::vector<std::string>>;

/// Largest name or value in BINARY [bytes].
inline constexpr std::size_t kMaxItemBytes = 65535;
/// Most items of one request. A limit of this package, so that a short request cannot cause an endless
/// answer.
inline constexpr std::size_t kMaxRequestedItems = 1024;

/// 1 if the value is not an array.
[[nodiscard]] std::size_t elementCount(const ItemValue& value);

/// The value as encoded in a frame. In STRING and JSON a float has 7 digits if these give the same float,
/// else 9; a double has 15 or 17. Whole numbers get `.0` in JSON. Strings are quoted; a quote inside is
/// doubled in STRING. What JSON cannot express becomes null (not a number) and U+FFFD (not UTF-8).
[[nodiscard]] std::string encodeValue(ItemFormat format, const ItemValue& value);

/// Decodes the bytes as a value of the type of `type`, with any number of elements; std::nullopt if they are
/// not such a value. A bool may be given as 0 and 1, a float as an integer. All numbers must be finite.
[[nodiscard]] std::optional<ItemValue> parseValue(ItemFormat format, std::string_view bytes,
                                                  const ItemValue& type);

/// Appends an item to the content of a BINARY frame, as encodeItems() would. Returns false and appends
/// nothing if the value is larger than kMaxItemBytes.
[[nodiscard]] bool appendBinaryItem(std::string& content, std::string_view name, const ItemValue& value);

/// The content of a stream frame, of a write request, or of the answer to a read request. Precondition: the
/// values are results of encodeValue() in that format; in BINARY at most kMaxItemBytes each.
[[nodiscard]] std::string encodeItems(ItemFormat format, const std::vector<StatusItem>& items);
/// The values remain encoded. Refused: content that is not in the format, items without a name, no items, too
/// many items.
[[nodiscard]] Result<std::vector<StatusItem>, MessageFault> parseItems(ItemFormat format,
                                                                       std::string_view content);

/// The content of a read request: only the names. Refused as above.
[[nodiscard]] Result<std::vector<std::string>, MessageFault> parseItemNames(ItemFormat format,
                                                                            std::string_view content);

}  // namespace cobot_command::protocol
