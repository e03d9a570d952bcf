#include "script_arguments.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/protocol/frame.h"

namespace cobot_command::protocol {

namespace {

std::string shown(const Literal& literal) {
  switch (literal.kind) {
    case Literal::Kind::Integer:
    case Literal::Kind::Real:
      return fmt::format("{}", literal.number);
    case Literal::Kind::Boolean:
      return literal.flag ? "true" : "false";
    case Literal::Kind::Text:
      return '"' + foreignText(literal.text, kQuoteLimit) + '"';
    case Literal::Kind::Array:
      return fmt::format("an array of {}", literal.elements.size());
    case Literal::Kind::Name:
      return "the variable " + foreignText(literal.text, kQuoteLimit);
  }
  return {};
}

bool isNumber(const Literal& literal) {
  return literal.kind == Literal::Kind::Integer || literal.kind == Literal::Kind::Real;
}

}  // namespace

DataFormat Arguments::toFormat(std::string_view letters) {
  return {static_cast<DataFormat::Target>(letters[0]), static_cast<DataFormat::Speed>(letters[1]),
          static_cast<DataFormat::Blending>(letters[2])};
}

std::size_t Arguments::oneOf(std::string_view what, Literal::Kind kind, const std::string_view* allowed,
                             std::size_t count) {
  std::string expected = "one of";
  for (std::size_t i = 0; i < count; ++i) expected.append(i == 0 ? " " : ", ").append(allowed[i]);
  const Literal* literal = take(what, expected);
  if (literal == nullptr) return 0;
  const auto* const found = std::find(allowed, allowed + count, literal->text);
  if (literal->kind == kind && found != allowed + count) return static_cast<std::size_t>(found - allowed);
  refuseArgument(what, expected, *literal);
  return 0;
}

void Arguments::takeEach(std::string_view what, std::string_view expected, std::size_t count,
                         const std::function<void(std::size_t, const Literal&)>& use) {
  if (!more() || literals_[next_].kind != Literal::Kind::Array) {
    for (std::size_t i = 0; i < count; ++i) {
      if (const Literal* literal = take(what, expected)) use(i, *literal);
    }
    return;
  }
  const Literal* array = take(what, expected);
  if (array == nullptr) return;
  if (array->elements.size() != count) return refuseArgument(what, fmt::format("{} numbers", count), *array);
  for (std::size_t i = 0; i < count; ++i) use(i, array->elements[i]);
}

std::array<int, 3> Arguments::poseBits() {
  constexpr std::string_view kWhat = "pose configuration";
  std::array<int, 3> bits{};
  takeEach(kWhat, "an integer", bits.size(), [&](std::size_t i, const Literal& literal) {
    bits[i] = integerOf(literal, kWhat, std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
  });
  return bits;
}

double Arguments::number(std::string_view what) {
  const Literal* literal = take(what, "a number");
  return literal == nullptr ? 0 : numberOf(*literal, what);
}

int Arguments::integer(std::string_view what, int least, int most) {
  const Literal* literal = take(what, "an integer");
  return literal == nullptr ? 0 : integerOf(*literal, what, least, most);
}

bool Arguments::boolean(std::string_view what) {
  constexpr std::string_view kExpected = "true or false";
  const Literal* literal = take(what, kExpected);
  if (literal == nullptr) return false;
  if (literal->kind != Literal::Kind::Boolean) refuseArgument(what, kExpected, *literal);
  return literal->flag;
}

std::string Arguments::name(std::string_view what) {
  constexpr std::string_view kExpected = "a name without control characters";
  const Literal* literal = take(what, kExpected);
  if (literal == nullptr) return {};
  if (literal->kind != Literal::Kind::Text || !isName(literal->text)) {
    refuseArgument(what, kExpected, *literal);
  }
  return literal->text;
}

MotionOptions Arguments::motionOptions() {
  MotionOptions options;
  options.speed = integer("speed");
  options.accel_time = integer("time to top speed");
  options.blending = integer("blending");
  return options;
}

std::string Arguments::fault() {
  if (fault_.empty() && more()) {
    fault_ = fmt::format("expected {} arguments, found {}", next_, literals_.size());
  }
  return std::move(fault_);
}

const Literal* Arguments::take(std::string_view what, std::string_view expected) {
  if (!fault_.empty()) return nullptr;
  if (more()) return &literals_[next_++];
  fault_ = fmt::format("argument {} ({}) is missing, expected {}", next_ + 1, what, expected);
  return nullptr;
}

double Arguments::numberOf(const Literal& literal, std::string_view what) {
  if (!isNumber(literal) || !std::isfinite(literal.number)) refuseArgument(what, "a number", literal);
  return literal.number;
}

int Arguments::integerOf(const Literal& literal, std::string_view what, int least, int most) {
  if (literal.kind == Literal::Kind::Integer && literal.number >= least && literal.number <= most) {
    return static_cast<int>(literal.number);
  }
  const bool any = least == std::numeric_limits<int>::min();
  refuseArgument(what, any ? "an integer" : fmt::format("an integer from {} to {}", least, most), literal);
  return 0;
}

void Arguments::refuseArgument(std::string_view what, std::string_view expected, const Literal& found) {
  if (fault_.empty()) {
    fault_ = fmt::format("argument {} ({}) is {}, expected {}", next_, what, shown(found), expected);
  }
}

}  // namespace cobot_command::protocol
