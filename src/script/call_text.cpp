#include "call_text.h"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::script {

/// As a whole number of millionths where that fits, which is much faster than to format a double.
void appendNumber(std::string& text, double value) {
  assert(std::isfinite(value));
  constexpr double kLimit = 9e15;
  constexpr unsigned long long kMillion = 1000000;
  const double millionths = std::round(value * kMillion);
  if (!(std::abs(millionths) < kLimit)) {
    text += fmt::format("{:.0f}", value);
    return;
  }
  const auto magnitude = static_cast<unsigned long long>(std::abs(millionths));
  if (millionths < 0) text += '-';
  text += std::string_view(fmt::format_int(magnitude / kMillion).c_str());
  if (magnitude % kMillion == 0) return;
  // The million in front keeps the zeros behind the point.
  text += std::string_view(fmt::format_int(kMillion + magnitude % kMillion).c_str());
  text[text.size() - 7] = '.';
  text.erase(text.find_last_not_of('0') + 1);
}

void appendQuoted(std::string& text, std::string_view name) {
  assert(isName(name));
  text += '"';
  for (const char c : name) {
    if (isControl(c)) continue;  // a line end in a name must never begin another command
    if (c == '"') text += '"';
    text += c;
  }
  text += '"';
}

CallText::CallText(std::string_view function) {
  text_.reserve(128);
  text_.append(function) += '(';
}

CallText& CallText::operator<<(double value) {
  appendNumber(next(), value);
  return *this;
}

CallText& CallText::operator<<(const DataFormat& format) {
  return *this << format.text();
}

CallText& CallText::operator<<(const std::string& name) {
  appendQuoted(next(), name);
  return *this;
}

CallText& CallText::addFlag(bool flag) {
  next() += flag ? "true" : "false";
  return *this;
}

CallText& CallText::addOptions(const MotionOptions& options) {
  return *this << options.speed << options.accel_time << options.blending;
}

std::string CallText::str() && {
  text_ += ')';
  return std::move(text_);
}

CallText& CallText::addInteger(int value) {
  next() += std::string_view(fmt::format_int(value).c_str());
  return *this;
}

std::string& CallText::next() {
  if (text_.back() != '(') text_ += ',';
  return text_;
}

}  // namespace cobot_command::script
