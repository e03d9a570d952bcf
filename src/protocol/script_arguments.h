// The arguments of one call, taken one after the other as what the function expects.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "script_syntax.h"

#include "cobot_command/protocol/script_command.h"

namespace cobot_command::protocol {

/// The first argument that does not fit is kept as the fault; what is taken after it means nothing.
class Arguments {
 public:
  explicit Arguments(const std::vector<Literal>& literals) : literals_(literals) {}

  [[nodiscard]] bool more() const { return next_ < literals_.size(); }
  [[nodiscard]] bool nextIsText() const { return more() && literals_[next_].kind == Literal::Kind::Text; }

  template <std::size_t N>
  DataFormat format(const std::array<std::string_view, N>& allowed) {
    return toFormat(allowed[oneOf("data format", Literal::Kind::Text, allowed.data(), N)]);
  }
  /// One array of N numbers, or N numbers.
  template <std::size_t N>
  std::array<double, N> numbers(std::string_view what) {
    std::array<double, N> values{};
    takeEach(what, "a number", N,
             [&](std::size_t i, const Literal& literal) { values[i] = numberOf(literal, what); });
    return values;
  }
  std::array<int, 3> poseBits();
  MotionOptions motionOptions();
  double number(std::string_view what);
  int integer(std::string_view what, int least = std::numeric_limits<int>::min(),
              int most = std::numeric_limits<int>::max());
  bool boolean(std::string_view what);
  /// The name of a base or TCP.
  std::string name(std::string_view what);
  /// One of these texts (in quotes) or names (without): its place among them.
  template <std::size_t N>
  std::size_t oneOf(std::string_view what, Literal::Kind kind,
                    const std::array<std::string_view, N>& allowed) {
    return oneOf(what, kind, allowed.data(), N);
  }

  /// Why the arguments are not those of the function; empty when they are. Arguments left over are a fault.
  [[nodiscard]] std::string fault();

 private:
  static DataFormat toFormat(std::string_view letters);
  std::size_t oneOf(std::string_view what, Literal::Kind kind, const std::string_view* allowed,
                    std::size_t count);
  /// One array of so many literals, or so many literals.
  void takeEach(std::string_view what, std::string_view expected, std::size_t count,
                const std::function<void(std::size_t, const Literal&)>& use);
  const Literal* take(std::string_view what, std::string_view expected);
  double numberOf(const Literal& literal, std::string_view what);
  int integerOf(const Literal& literal, std::string_view what, int least, int most);
  void refuseArgument(std::string_view what, std::string_view expected, const Literal& found);

  const std::vector<Literal>& literals_;
  std::size_t next_ = 0;
  std::string fault_;
};

}  // namespace cobot_command::protocol
