// Chains of operators, signs and NOT.
#include <cmath>

#include "expressions/expression_check.h"
#include "expressions/folding.h"
#include <fmt/format.h>

namespace cobot_command::rapid {

namespace {

bool isEquality(TokenKind op) {
  return op == TokenKind::Equal || op == TokenKind::NotEqual;
}

bool isDivision(TokenKind op) {
  return op == TokenKind::Slash || op == TokenKind::Div || op == TokenKind::Mod;
}

/// What the result would be, so that nothing follows from the error.
TypeIndex resultAfterError(TokenKind op) {
  switch (op) {
    case TokenKind::Plus:
    case TokenKind::Minus:
    case TokenKind::Star:
    case TokenKind::Slash:
      return kNoType;
    case TokenKind::Div:
    case TokenKind::Mod:
      return kNum;
    default:
      return kBool;
  }
}

}  // namespace

/// From the left. An aggregate takes its type from the other side.
Typed ExpressionCheck::chain(NodeIndex node) {
  const Tree& tree = file_.tree();
  const NodeIndex first = file_[node].child;
  const NodeIndex second = file_[first].next;
  const auto is_aggregate = [&](NodeIndex at) {
    while (tree[at].kind == NodeKind::Parentheses) at = tree[at].child;
    return tree[at].kind == NodeKind::Aggregate;
  };
  const NodeIndex second_operand = tree[second].child;
  Typed left;
  Typed right;
  const bool is_told_by_second = is_aggregate(first) && !is_aggregate(second_operand);
  if (is_told_by_second) {
    right = check(second_operand);
    left = check(first, right.type);
  } else {
    left = check(first);
  }
  for (NodeIndex at = second; at != kNoNode; at = tree[at].next) {
    if (at != second || !is_told_by_second) right = check(tree[at].child, left.type);
    left = operation(at, left, right);
    file_.at(at).type = left.type;
    file_.at(at).constant = left.constant;
  }
  return left;
}

Typed ExpressionCheck::operation(NodeIndex operation, const Typed& left, const Typed& right) {
  const TokenKind op = file_[operation].word;
  const bool is_open = left.type == kNoType || right.type == kNoType;
  if (is_open) return {resultAfterError(op), kNoConstant};
  if (isEquality(op)) return relation(operation, left, right);
  const auto read = [&](TypeIndex type) {
    return draft_.types()[type].kind == TypeKind::SemiValue ? kNum : type;
  };
  const TypeIndex type = typeOfOperation(draft_, op, read(left.type), read(right.type));
  if (type == kNoType) {
    file_.report(kinds::kNoOperation, file_[operation].first, toString(op),
                 file_.typeName(left.type) + " " + file_.typeName(right.type));
    return {resultAfterError(op), kNoConstant};
  }
  warnOfDivision(operation, left, right);
  if (left.constant == kNoConstant || right.constant == kNoConstant) return {type, kNoConstant};
  const auto cells = valueOfOperation(draft_, op, left.type, valueOf(left), right.type, valueOf(right));
  if (!cells) return {type, kNoConstant};
  const ConstantIndex place = draft_.reserve(static_cast<std::uint32_t>(cells->size()));
  if (place != kNoConstant) std::copy(cells->begin(), cells->end(), draft_.cells(place));
  return {type, place};
}

Typed ExpressionCheck::relation(NodeIndex operation, const Typed& left, const Typed& right) {
  const TokenIndex op = file_[operation].first;
  const Type& left_type = draft_.types()[left.type];
  const bool are_equal = fits(left.type, right.type) || fits(right.type, left.type);
  if (!are_equal) {
    file_.report(kinds::kNoOperation, op, toString(file_[operation].word),
                 file_.typeName(left.type) + " " + file_.typeName(right.type));
  } else if (!left_type.has_values) {
    file_.report(kinds::kNoValues, op, file_.typeName(left.type));
  } else if (left.constant != kNoConstant && right.constant != kNoConstant) {
    const bool is_same = areEqual(valueOf(left), valueOf(right), left_type.cells);
    return value(kBool, boolCell(is_same == (file_[operation].word == TokenKind::Equal)));
  }
  return {kBool, kNoConstant};
}

void ExpressionCheck::warnOfDivision(NodeIndex operation, const Typed& left, const Typed& right) {
  const TokenKind op = file_[operation].word;
  if (!isDivision(op)) return;
  const auto is_fraction = [&](const Typed& operand) {
    const Cell* const value = operand.type == kNum ? valueOf(operand) : nullptr;
    return value != nullptr && *value != std::trunc(*value);
  };
  const Cell* const divisor = valueOf(right);
  if (divisor != nullptr && *divisor == 0) {
    file_.report(kinds::kZeroDivision, file_[operation].first);
  } else if (op != TokenKind::Slash && (is_fraction(left) || is_fraction(right))) {
    file_.report(kinds::kNotWhole, file_[operation].first, toString(op));
  }
}

Typed ExpressionCheck::sign(NodeIndex node, TypeIndex context) {
  const NodeIndex operand = file_[node].child;
  const bool is_minus = file_[node].word == TokenKind::Minus;
  if (file_[operand].kind == NodeKind::Number && is_minus) {
    const Typed positive = number(operand);
    file_.at(operand).type = kNum;
    // In the place of the number, so that the parts of an aggregate stay one after another.
    if (positive.constant != kNoConstant) {
      Cell* const cell = draft_.cells(positive.constant);
      *cell = numCell(-*cell);
    }
    return positive;
  }
  const Typed typed = check(operand, context);
  const Type& type = draft_.types()[typed.type];
  const bool is_num = typed.type == kNum || type.kind == TypeKind::SemiValue;
  if (typed.type == kNoType) return {};
  if (!is_num && typed.type != draft_.known.pos) {
    file_.report(kinds::kNoOperation, file_[node].first, toString(file_[node].word),
                 file_.typeName(typed.type));
    return {};
  }
  const TypeIndex result = is_num ? kNum : typed.type;
  if (typed.constant == kNoConstant || !is_minus) return {result, typed.constant};
  const ConstantIndex place = draft_.reserve(type.cells);
  for (std::uint32_t i = 0; place != kNoConstant && i < type.cells; ++i) {
    draft_.cells(place)[i] = numCell(-draft_.cells(typed.constant)[i]);
  }
  return {result, place};
}

Typed ExpressionCheck::negation(NodeIndex node) {
  const NodeIndex operand = file_[node].child;
  const bool is_of_chain = file_[operand].kind == NodeKind::Chain &&
                           file_[file_[file_[operand].child].next].word == TokenKind::And;
  if (is_of_chain) file_.report(kinds::kNotOfChain, file_[node].first);
  const Typed typed = check(operand);
  if (typed.type != kBool && typed.type != kNoType) {
    file_.report(kinds::kNoOperation, file_[node].first, "NOT", file_.typeName(typed.type));
  }
  if (typed.type != kBool || typed.constant == kNoConstant) return {kBool, kNoConstant};
  return value(kBool, boolCell(!isTrue(*valueOf(typed))));
}

}  // namespace cobot_command::rapid
