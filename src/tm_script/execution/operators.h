// What operators accept, and what they give (I848-E-03 1.4).
//
// Integers are computed in 32 bits and wrap around; with a float or a double on either side, in the wider of
// the two.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

/// Of two numbers, the type that holds both; nothing where one is no number.
[[nodiscard]] std::optional<ScalarType> commonType(ScalarType a, ScalarType b);

[[nodiscard]] Result<Type, std::string> resultOf(BinaryOperator binary, Type a, Type b);
/// Not for ++ and --, which need a variable.
[[nodiscard]] Result<Type, std::string> resultOf(PrefixOperator prefix, Type operand);

/// Fail as resultOf(), for an integer division by zero, and for a text of more than kMaxValueBytes.
[[nodiscard]] Result<Value, std::string> applyOperator(BinaryOperator binary, const Value& a, const Value& b);
[[nodiscard]] Result<Value, std::string> applyOperator(PrefixOperator prefix, const Value& operand);

}  // namespace cobot_command::tm_script
