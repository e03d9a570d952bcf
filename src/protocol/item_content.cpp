#include "cobot_command/protocol/item_content.h"

#include <algorithm>

#include "item_json.h"
#include "item_string.h"
#include "little_endian.h"
#include <fmt/format.h>

namespace cobot_command::protocol {

namespace {

constexpr std::string_view kLineEnd = "\r\n";

using Items = std::vector<StatusItem>;
enum class Wanted { Names, Values };

auto fault(std::string message) {
  return refuse(MessageFault{MessageFault::Kind::Data, std::move(message)});
}

auto tooMany() {
  return fault(fmt::format("a request has at most {} items", kMaxRequestedItems));
}

/// Repeated { u16 length, name }.
Result<Items, MessageFault> binaryNames(std::string_view content) {
  Items items;
  while (!content.empty()) {
    const std::size_t head = sizeof(std::uint16_t);
    const std::size_t length = content.size() < head ? 0 : readNumber<std::uint16_t>(content);
    if (length == 0 || content.size() < head + length) {
      return fault(fmt::format("name {} is missing or longer than the content", items.size() + 1));
    }
    if (items.size() == kMaxRequestedItems) return tooMany();
    items.push_back({std::string(content.substr(head, length)), {}});
    content.remove_prefix(head + length);
  }
  return items;
}

Result<Items, MessageFault> binaryItems(std::string_view content) {
  auto items = parseBinaryItems(content);
  if (items && items->size() > kMaxRequestedItems) return tooMany();
  return items;
}

/// A line break at the end is no item.
Result<Items, MessageFault> stringItems(std::string_view content, Wanted wanted) {
  Items items;
  while (!content.empty()) {
    const std::string_view line = takeUnquoted(kLineEnd, content);
    const std::size_t sign = wanted == Wanted::Values ? line.find('=') : line.size();
    if (sign == 0 || sign == std::string_view::npos) {
      return fault(fmt::format("line {} is not {}", items.size() + 1,
                               wanted == Wanted::Values ? "Item=Value" : "the name of an item"));
    }
    if (items.size() == kMaxRequestedItems) return tooMany();
    items.push_back({std::string(line.substr(0, sign)),
                     std::string(wanted == Wanted::Values ? line.substr(sign + 1) : std::string_view())});
  }
  return items;
}

Result<Items, MessageFault> jsonItems(std::string_view content, Wanted wanted) {
  const auto json = parseJson(content);
  if (!json || !json->is_array()) return fault("the content is not a JSON array, or is nested too deeply");
  if (json->size() > kMaxRequestedItems) return tooMany();
  Items items;
  for (const JsonTree& element : *json) {
    const auto name = element.is_object() ? element.find("Item") : element.end();
    const bool has_name = element.is_object() && name != element.end() && name->is_string() &&
                          !name->get_ref<const std::string&>().empty();
    if (!has_name || (wanted == Wanted::Values && !element.contains("Value"))) {
      return fault(fmt::format("element {} has no \"Item\"{}", items.size() + 1,
                               wanted == Wanted::Values ? ", or no \"Value\"" : ""));
    }
    items.push_back({name->get<std::string>(), wanted == Wanted::Values ? toText(element["Value"]) : ""});
  }
  return items;
}

Result<Items, MessageFault> parse(ItemFormat format, std::string_view content, Wanted wanted) {
  auto items = format == ItemFormat::String ? stringItems(content, wanted)
               : format == ItemFormat::Json ? jsonItems(content, wanted)
               : wanted == Wanted::Values   ? binaryItems(content)
                                            : binaryNames(content);
  if (items && items->empty()) return fault("the content names no item");
  return items;
}

}  // namespace

std::string encodeItems(ItemFormat format, const Items& items) {
  if (format == ItemFormat::Binary) return encodeBinaryItems(items);
  std::string content;
  for (const StatusItem& item : items) {
    if (format == ItemFormat::String) {
      content.append(content.empty() ? "" : kLineEnd).append(item.name).append("=").append(item.value);
    } else {
      content += fmt::format("{}{{\"Item\":{},\"Value\":{}}}", content.empty() ? "" : ",",
                             toText(JsonTree(item.name)), item.value);
    }
  }
  return format == ItemFormat::Json ? '[' + content + ']' : content;
}

Result<Items, MessageFault> parseItems(ItemFormat format, std::string_view content) {
  return parse(format, content, Wanted::Values);
}

Result<std::vector<std::string>, MessageFault> parseItemNames(ItemFormat format, std::string_view content) {
  auto items = parse(format, content, Wanted::Names);
  if (!items) return refuse(std::move(items.error()));
  std::vector<std::string> names;
  for (StatusItem& item : *items) names.push_back(std::move(item.name));
  return names;
}

}  // namespace cobot_command::protocol
