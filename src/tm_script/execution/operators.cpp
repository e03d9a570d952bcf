#include "execution/operators.h"

#include <algorithm>
#include <cmath>

#include "values/conversion.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

using Applied = Result<Value, std::string>;
using B = BinaryOperator;

bool isLogical(B binary) {
  return binary == B::And || binary == B::Or;
}
bool isBitwise(B binary) {
  return binary == B::BitAnd || binary == B::BitOr || binary == B::BitXor || binary == B::ShiftLeft ||
         binary == B::ShiftRight;
}
bool isEquality(B binary) {
  return binary == B::Equal || binary == B::NotEqual;
}
bool isComparison(B binary) {
  return binary >= B::Equal && binary <= B::GreaterEqual;
}

std::int32_t wrapped(std::uint32_t bits) {
  return static_cast<std::int32_t>(bits);
}

template <class Number>
bool compare(B binary, const Number& a, const Number& b) {
  switch (binary) {
    case B::Equal:
      return a == b;
    case B::NotEqual:
      return a != b;
    case B::Less:
      return a < b;
    case B::LessEqual:
      return a <= b;
    case B::Greater:
      return a > b;
    default:
      return a >= b;
  }
}

Applied divide(B binary, std::int32_t a, std::int32_t b) {
  if (b == 0) return refuse(std::string("division by zero"));
  if (b == -1) return Scalar(binary == B::Divide ? wrapped(0U - static_cast<std::uint32_t>(a)) : 0);
  return Scalar(binary == B::Divide ? a / b : a % b);
}

Applied ofIntegers(B binary, std::int32_t a, std::int32_t b) {
  const auto left = static_cast<std::uint32_t>(a);
  const auto right = static_cast<std::uint32_t>(b);
  switch (binary) {
    case B::Add:
      return Scalar(wrapped(left + right));
    case B::Subtract:
      return Scalar(wrapped(left - right));
    case B::Multiply:
      return Scalar(wrapped(left * right));
    case B::BitAnd:
      return Scalar(a & b);
    case B::BitOr:
      return Scalar(a | b);
    case B::BitXor:
      return Scalar(a ^ b);
    case B::ShiftLeft:
      return Scalar(wrapped(left << (right & 31U)));
    case B::ShiftRight:
      return Scalar(a >> (right & 31U));
    default:
      return divide(binary, a, b);
  }
}

template <class Real>
Applied ofReals(B binary, Real a, Real b) {
  switch (binary) {
    case B::Add:
      return Scalar(a + b);
    case B::Subtract:
      return Scalar(a - b);
    case B::Multiply:
      return Scalar(a * b);
    case B::Divide:
      return Scalar(a / b);
    default:
      return Scalar(std::fmod(a, b));
  }
}

template <class Number>
Applied ofNumbers(B binary, const Scalar& a, const Scalar& b, ScalarType type) {
  // Numbers widen without fail.
  const auto left = std::get<Number>(*convert(a, type));
  const auto right = std::get<Number>(*convert(b, type));
  if (isComparison(binary)) return Scalar(compare(binary, left, right));
  if constexpr (std::is_integral_v<Number>) {
    return ofIntegers(binary, left, right);
  } else {
    return ofReals(binary, left, right);
  }
}

Applied concatenated(const Scalar& a, const Scalar& b) {
  std::string text = textOf(a) + textOf(b);
  if (text.size() > kMaxValueBytes) {
    return refuse(fmt::format("a text of more than {} bytes", kMaxValueBytes));
  }
  return Scalar(std::move(text));
}

std::string mismatch(B binary, Type a, Type b) {
  return fmt::format("{} {} {} is not defined", toText(a), toText(binary), toText(b));
}

}  // namespace

std::optional<ScalarType> commonType(ScalarType a, ScalarType b) {
  if (!isNumber(a) || !isNumber(b)) return std::nullopt;
  return std::max(a, b);
}

Result<Type, std::string> resultOf(B binary, Type a, Type b) {
  if (a.is_array || b.is_array) return refuse(mismatch(binary, a, b));
  const bool has_text = a.scalar == ScalarType::String || b.scalar == ScalarType::String;
  const auto common = commonType(a.scalar, b.scalar);
  if (isLogical(binary) && a.scalar == ScalarType::Bool && b.scalar == ScalarType::Bool) return a;
  if (isEquality(binary) && a.scalar == b.scalar) return Type{ScalarType::Bool};
  if (isComparison(binary) && common) return Type{ScalarType::Bool};
  if (isBitwise(binary) && isInteger(a.scalar) && isInteger(b.scalar)) return Type{ScalarType::Int};
  if (binary == B::Add && has_text) return Type{ScalarType::String};
  if (binary >= B::Add && common) return Type{std::max(*common, ScalarType::Int)};
  return refuse(mismatch(binary, a, b));
}

Result<Type, std::string> resultOf(PrefixOperator prefix, Type operand) {
  const bool fits = !operand.is_array && (prefix == PrefixOperator::Not ? operand.scalar == ScalarType::Bool
                                          : prefix == PrefixOperator::Complement ? isInteger(operand.scalar)
                                                                                 : isNumber(operand.scalar));
  if (!fits) return refuse(fmt::format("{}{} is not defined", toText(prefix), toText(operand)));
  return isInteger(operand.scalar) ? Type{ScalarType::Int} : operand;
}

Applied applyOperator(B binary, const Value& left, const Value& right) {
  const auto result = resultOf(binary, typeOf(left), typeOf(right));
  if (!result) return refuse(result.error());
  const auto& a = std::get<Scalar>(left);
  const auto& b = std::get<Scalar>(right);
  if (result->scalar == ScalarType::String) return concatenated(a, b);
  const auto common = commonType(typeOf(a), typeOf(b));
  if (!common) {  // texts or truth values
    if (isEquality(binary)) return Scalar((a == b) == (binary == B::Equal));
    const bool first = std::get<bool>(a);
    const bool second = std::get<bool>(b);
    return Scalar(binary == B::And ? first && second : first || second);
  }
  if (*common == ScalarType::Double) return ofNumbers<double>(binary, a, b, ScalarType::Double);
  if (*common == ScalarType::Float) return ofNumbers<float>(binary, a, b, ScalarType::Float);
  return ofNumbers<std::int32_t>(binary, a, b, ScalarType::Int);
}

Applied applyOperator(PrefixOperator prefix, const Value& operand) {
  const auto result = resultOf(prefix, typeOf(operand));
  if (!result) return refuse(result.error());
  const Scalar number = *convert(std::get<Scalar>(operand), result->scalar);
  switch (prefix) {
    case PrefixOperator::Not:
      return Scalar(!std::get<bool>(number));
    case PrefixOperator::Complement:
      return Scalar(~std::get<std::int32_t>(number));
    case PrefixOperator::Minus:
      if (const auto* a_float = std::get_if<float>(&number)) return Scalar(-*a_float);
      if (const auto* a_double = std::get_if<double>(&number)) return Scalar(-*a_double);
      return ofIntegers(B::Subtract, 0, std::get<std::int32_t>(number));
    default:
      return number;
  }
}

}  // namespace cobot_command::tm_script
