#include "cobot_command/arm/joint_range.h"

#include <charconv>

#include "cobot_command/arm/types.h"

namespace cobot_command::arm {
namespace {

/// The number in front of `text`, which is shorter then; nothing: there is none.
template <class Number>
std::optional<Number> take(std::string_view& text) {
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  return number;
}

bool takeMark(std::string_view& text, char mark) {
  if (text.empty() || text.front() != mark) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::optional<JointRange> parseJointRange(std::string_view text) {
  const auto joint = take<std::size_t>(text);
  if (!joint || *joint < 1 || *joint > kJointCount || !takeMark(text, '=')) return std::nullopt;
  const auto lower = take<double>(text);
  if (!lower || !takeMark(text, ',')) return std::nullopt;
  const auto upper = take<double>(text);
  if (!upper || !text.empty()) return std::nullopt;
  return JointRange{*joint, *lower, *upper};
}

}  // namespace cobot_command::arm
