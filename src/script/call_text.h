// The text of a call, built argument by argument: Name(argument,argument)
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "cobot_command/script/script_command.h"

namespace cobot_command::script {

/// To the nearest millionth. Precondition: finite.
void appendNumber(std::string& text, double value);

/// In quotes, those within doubled. Precondition: isName().
void appendQuoted(std::string& text, std::string_view name);

class CallText {
 public:
  explicit CallText(std::string_view function);

  /// An integer; anything that only converts to one, a bool above all, is none.
  template <class Integer, class = std::enable_if_t<std::is_same_v<Integer, int>>>
  CallText& operator<<(Integer value) {
    return addInteger(value);
  }
  /// Precondition: finite.
  CallText& operator<<(double value);
  CallText& operator<<(const DataFormat& format);
  /// In quotes. Precondition: isName().
  CallText& operator<<(const std::string& name);
  template <class Number, std::size_t N>
  CallText& operator<<(const std::array<Number, N>& numbers) {
    for (const Number value : numbers) *this << value;
    return *this;
  }
  template <class Value>
  CallText& operator<<(const std::optional<Value>& value) {
    return value ? *this << *value : *this;
  }
  CallText& addFlag(bool flag);
  /// Speed, time to top speed and blending.
  CallText& addOptions(const MotionOptions& options);

  [[nodiscard]] std::string str() &&;

 private:
  CallText& addInteger(int value);
  /// The text, ready for the next argument.
  std::string& next();

  std::string text_;
};

}  // namespace cobot_command::script
