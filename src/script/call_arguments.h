// The arguments of a call, one behind the other, as the commands need them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <variant>

#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::script {

/// Precondition of all that takes: the arguments have the types of a declared form that has it here.
class CallArguments {
 public:
  explicit CallArguments(const tm_script::Arguments& arguments) : arguments_(arguments) {}

  [[nodiscard]] bool more() const { return next_ < arguments_.size(); }
  [[nodiscard]] bool nextIsText() const {
    const auto* scalar = std::get_if<tm_script::Scalar>(&arguments_[next_]);
    return scalar != nullptr && std::holds_alternative<std::string>(*scalar);
  }

  std::string text() { return take<std::string>(); }
  int integer() { return take<std::int32_t>(); }
  double number() { return take<double>(); }
  bool boolean() { return take<bool>(); }

  DataFormat format() {
    const std::string letters = text();
    return {static_cast<DataFormat::Target>(letters[0]), static_cast<DataFormat::Speed>(letters[1]),
            static_cast<DataFormat::Blending>(letters[2])};
  }
  /// Speed, time to top speed and blending.
  MotionOptions motionOptions() {
    MotionOptions options;
    options.speed = integer();
    options.accel_time = integer();
    options.blending = integer();
    return options;
  }

  /// One array, or as many scalars.
  template <std::size_t N>
  std::array<double, N> numbers() {
    return takeEach<double, N>();
  }
  template <std::size_t N>
  std::array<int, N> integers() {
    return takeEach<std::int32_t, N>();
  }

 private:
  template <class T>
  T take() {
    return std::get<T>(std::get<tm_script::Scalar>(arguments_[next_++]));
  }
  template <class T, std::size_t N>
  std::array<T, N> takeEach() {
    std::array<T, N> all{};
    const auto* array = std::get_if<tm_script::Array>(&arguments_[next_]);
    if (array != nullptr) ++next_;
    for (std::size_t i = 0; i < N; ++i) all[i] = array != nullptr ? std::get<T>(array->items[i]) : take<T>();
    return all;
  }

  const tm_script::Arguments& arguments_;
  std::size_t next_ = 0;
};

}  // namespace cobot_command::script
