// Values of operations whose operands are constant, in single precision.
#pragma once

#include <optional>
#include <vector>

#include "draft.h"

namespace cobot_command::rapid {

/// What an operator makes of two types; kNoType if it is not defined for them. Operators of section 6 of the
/// language, relations without `=` and `<>`.
[[nodiscard]] TypeIndex typeOfOperation(const Draft& draft, TokenKind op, TypeIndex left, TypeIndex right);

/// The value of such an operation, in cells; std::nullopt if it has none: an error, or a
/// result beyond single precision.
[[nodiscard]] std::optional<std::vector<Cell>> valueOfOperation(const Draft& draft, TokenKind op,
                                                                TypeIndex left_type, const Cell* left,
                                                                TypeIndex right_type, const Cell* right);

}  // namespace cobot_command::rapid
