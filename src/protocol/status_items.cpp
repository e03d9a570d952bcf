#include "cobot_command/protocol/status_items.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "characters.h"
#include "little_endian.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::protocol {

namespace {

constexpr std::size_t kMaxField = std::numeric_limits<std::uint16_t>::max();

/// In the order of StatusReply::Code.
constexpr std::array<std::string_view, 8> kReplyTexts{
    "OK", "NotSupport", "WritePermission", "InvalidData", "NotExist", "ReadOnly", "ModeError", "ValueError"};

auto dataFault(std::string message) {
  return refuse(MessageFault{MessageFault::Kind::Data, std::move(message)});
}

void appendField(std::string& bytes, std::string_view field) {
  assert(field.size() <= kMaxField);
  appendNumber(bytes, static_cast<std::uint16_t>(field.size()));
  bytes += field;
}

/// A length and so many bytes; nothing when the content ends before that.
std::optional<std::string_view> takeField(std::string_view& content) {
  if (content.size() < sizeof(std::uint16_t)) return std::nullopt;
  const std::size_t size = readNumber<std::uint16_t>(content);
  content.remove_prefix(sizeof(std::uint16_t));
  if (content.size() < size) return std::nullopt;
  const std::string_view field = content.substr(0, size);
  content.remove_prefix(size);
  return field;
}

}  // namespace

namespace item {

StatusItem ofByte(std::string name, std::uint8_t value) {
  return {std::move(name), std::string(1, static_cast<char>(value))};
}
StatusItem ofBool(std::string name, bool value) {
  return ofByte(std::move(name), value ? 1 : 0);
}
StatusItem ofInt(std::string name, std::int32_t value) {
  StatusItem item{std::move(name), {}};
  appendNumber(item.value, value);
  return item;
}
StatusItem ofFloat(std::string name, float value) {
  return ofFloats(std::move(name), {value});
}
StatusItem ofFloats(std::string name, const std::vector<float>& values) {
  StatusItem item{std::move(name), {}};
  item.value.reserve(values.size() * sizeof(float));
  for (const float value : values) appendNumber(item.value, value);
  return item;
}
StatusItem ofString(std::string name, std::string value) {
  return {std::move(name), std::move(value)};
}

std::optional<std::uint8_t> asByte(const StatusItem& item) {
  if (item.value.size() != 1) return std::nullopt;
  return static_cast<std::uint8_t>(item.value.front());
}
std::optional<bool> asBool(const StatusItem& item) {
  const auto byte = asByte(item);
  if (!byte) return std::nullopt;
  return *byte != 0;
}
std::optional<std::int32_t> asInt(const StatusItem& item) {
  if (item.value.size() != sizeof(std::int32_t)) return std::nullopt;
  return readNumber<std::int32_t>(item.value);
}
std::optional<float> asFloat(const StatusItem& item) {
  if (item.value.size() != sizeof(float)) return std::nullopt;
  return readNumber<float>(item.value);
}
std::optional<std::vector<float>> asFloats(const StatusItem& item) {
  if (item.value.size() % sizeof(float) != 0) return std::nullopt;
  std::vector<float> values;
  values.reserve(item.value.size() / sizeof(float));
  for (std::string_view rest = item.value; !rest.empty(); rest.remove_prefix(sizeof(float))) {
    values.push_back(readNumber<float>(rest));
  }
  return values;
}

}  // namespace item

Result<StatusFrame, MessageFault> parseStatusFrame(const Frame& frame) {
  if (frame.header != header::kItems) {
    return refuse(
        MessageFault{MessageFault::Kind::UnknownHeader,
                     fmt::format("header is {}, known here: TMSVR", foreignText(frame.header, kQuoteLimit))});
  }
  std::string_view fields = frame.data;
  const std::size_t commas = static_cast<std::size_t>(std::count(fields.begin(), fields.end(), ','));
  const std::string_view id = takeUntil(',', fields);
  const auto mode = parseDigits(takeUntil(',', fields));
  if (commas < 2 || !isAlphanumeric(id) || !mode) {
    return dataFault(fmt::format("expected an id of letters and digits, a mode and a content, found \"{}\"",
                                 foreignText(frame.data, kQuoteLimit)));
  }
  return StatusFrame{std::string(id), *mode, std::string(fields)};
}

std::string encode(const StatusFrame& frame) {
  assert(isAlphanumeric(frame.id) && frame.mode >= 0);
  const fmt::format_int mode(frame.mode);
  return encodeFrame(header::kItems,
                     {frame.id, ",", std::string_view(mode.data(), mode.size()), ",", frame.content});
}

Result<std::vector<StatusItem>, MessageFault> parseBinaryItems(std::string_view content) {
  std::vector<StatusItem> items;
  const std::size_t size = content.size();
  while (!content.empty()) {
    const std::size_t begin = size - content.size();
    const auto name = takeField(content);
    const auto value = name ? takeField(content) : std::nullopt;
    if (!value || name->empty()) {
      return dataFault(
          fmt::format("item {} at byte {} has no name or needs more than the {} bytes that there are",
                      items.size() + 1, begin, size));
    }
    items.push_back({std::string(*name), std::string(*value)});
  }
  return items;
}

std::string encodeBinaryItems(const std::vector<StatusItem>& items) {
  std::string content;
  for (const StatusItem& item : items) {
    assert(!item.name.empty());
    appendField(content, item.name);
    appendField(content, item.value);
  }
  return content;
}

std::string encodeBinaryNames(const std::vector<std::string>& names) {
  std::string content;
  for (const std::string& name : names) {
    assert(!name.empty());
    appendField(content, name);
  }
  return content;
}

Result<StatusReply, MessageFault> parseStatusReply(std::string_view content) {
  std::string_view fields = content;
  const std::string_view digits = takeUntil(',', fields);
  const auto code = parseDigits(digits);
  const std::string_view text = takeUntil(';', fields);
  if (digits.size() != 2 || !code || *code >= static_cast<int>(kReplyTexts.size()) || text.empty()) {
    return dataFault(fmt::format("expected a code 00 to 07, ',' and a text, found \"{}\"",
                                 foreignText(content, kQuoteLimit)));
  }
  return StatusReply{static_cast<StatusReply::Code>(*code), std::string(fields)};
}

std::string toContent(const StatusReply& reply) {
  const auto code = static_cast<std::size_t>(reply.code);
  std::string content = fmt::format("{:02},{}", code, kReplyTexts[code]);
  if (!reply.item.empty()) content += ';' + reply.item;
  return content;
}

}  // namespace cobot_command::protocol
