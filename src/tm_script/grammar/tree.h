// Builds trees out of what the grammar reads in a row.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

/// What may follow a value: [i], .attribute, ++, --
using Suffix = std::variant<Expressions, std::string, PostfixOperator>;

/// Operands and the operators between them, precedence not yet considered.
struct FlatChain {
  Expressions operands;
  std::vector<BinaryOperator> operators;
};

struct FlatConditional {
  Expressions values;   ///< condition, then in turns the next condition or the last value
  Expressions results;  ///< one less
};

struct FlatAssignment {
  Expressions values;  ///< targets and the value
  std::vector<std::optional<BinaryOperator>> operators;
};

[[nodiscard]] Result<Expression, std::string> withSuffixes(Expression primary, std::vector<Suffix> suffixes);
[[nodiscard]] Expression withPrefixes(std::vector<Prefix::Step> steps, Expression operand);
[[nodiscard]] Expression tree(FlatChain chain);
[[nodiscard]] Expression tree(FlatConditional conditional);
[[nodiscard]] Expression tree(FlatAssignment assignment);

}  // namespace cobot_command::tm_script
