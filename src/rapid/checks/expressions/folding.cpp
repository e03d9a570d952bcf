#include "expressions/folding.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::rapid {

namespace {

using Cells = std::vector<Cell>;

bool isWhole(float value) {
  return value == std::trunc(value);
}

std::optional<float> quotient(TokenKind op, float left, float right) {
  if (right == 0) return std::nullopt;
  if (op == TokenKind::Slash) return left / right;
  if (!isWhole(left) || !isWhole(right)) return std::nullopt;
  return op == TokenKind::Div ? std::trunc(left / right) : std::fmod(left, right);
}

std::optional<float> ofNums(TokenKind op, float left, float right) {
  switch (op) {
    case TokenKind::Plus:
      return left + right;
    case TokenKind::Minus:
      return left - right;
    case TokenKind::Star:
      return left * right;
    default:
      return quotient(op, left, right);
  }
}

bool holds(TokenKind op, float left, float right) {
  switch (op) {
    case TokenKind::Less:
      return left < right;
    case TokenKind::LessEqual:
      return left <= right;
    case TokenKind::Greater:
      return left > right;
    default:
      return left >= right;
  }
}

bool ofBools(TokenKind op, bool left, bool right) {
  return op == TokenKind::And ? left && right : op == TokenKind::Or ? left || right : left != right;
}

bool isRelation(TokenKind op) {
  return op == TokenKind::Less || op == TokenKind::LessEqual || op == TokenKind::Greater ||
         op == TokenKind::GreaterEqual;
}
bool isLogical(TokenKind op) {
  return op == TokenKind::And || op == TokenKind::Or || op == TokenKind::Xor;
}
bool isSum(TokenKind op) {
  return op == TokenKind::Plus || op == TokenKind::Minus;
}

Cells cross(const Cell* a, const Cell* b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Of two quaternions, the scalar first.
Cells product(const Cell* a, const Cell* b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

std::optional<Cells> joined(const Cell* left, const Cell* right) {
  const std::string text = std::string(stringIn(left)) + std::string(stringIn(right));
  if (text.size() > kMostTextCharacters) return std::nullopt;
  Cells cells(kStringCells);
  putString(text, cells.data());
  return cells;
}

/// Each component with the num, or with the component of the other pos.
std::optional<Cells> byComponent(TokenKind op, const Cell* left, std::size_t left_step, const Cell* right,
                                 std::size_t right_step) {
  Cells cells;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = ofNums(op, left[i * left_step], right[i * right_step]);
    if (!value) return std::nullopt;
    cells.push_back(*value);
  }
  return cells;
}

std::optional<Cells> finite(std::optional<Cells> cells) {
  if (!cells) return std::nullopt;
  for (Cell& cell : *cells) {
    if (!std::isfinite(cell)) return std::nullopt;
    cell = numCell(cell);
  }
  return cells;
}

std::optional<Cells> ofVectors(const KnownTypes& known, TokenKind op, TypeIndex left_type, const Cell* left,
                               TypeIndex right_type, const Cell* right) {
  if (left_type == known.orient) return product(left, right);
  const bool are_vectors = left_type == right_type;
  if (are_vectors && op == TokenKind::Star) return cross(left, right);
  return byComponent(op, left, left_type == kNum ? 0 : 1, right, right_type == kNum ? 0 : 1);
}

}  // namespace

TypeIndex typeOfOperation(const Draft& draft, TokenKind op, TypeIndex left, TypeIndex right) {
  const TypeIndex pos = draft.known.pos;
  const bool are_nums = left == kNum && right == kNum;
  if (isLogical(op)) return left == kBool && right == kBool ? kBool : kNoType;
  if (isRelation(op)) return are_nums ? kBool : kNoType;
  if (are_nums) return kNum;
  if (op == TokenKind::Plus && left == kString && right == kString) return kString;
  if (isSum(op)) return left == pos && right == pos ? pos : kNoType;
  if (op == TokenKind::Slash) {
    const bool is_scaled = left == pos && right == kNum && draft.dialect == Dialect::Irc5;
    return is_scaled ? pos : kNoType;
  }
  if (op != TokenKind::Star) return kNoType;
  if (left == draft.known.orient && right == left) return left;
  const bool is_vector = (left == pos || left == kNum) && (right == pos || right == kNum);
  return is_vector ? pos : kNoType;
}

std::optional<std::vector<Cell>> valueOfOperation(const Draft& draft, TokenKind op, TypeIndex left_type,
                                                  const Cell* left, TypeIndex right_type, const Cell* right) {
  if (isLogical(op)) return Cells{boolCell(ofBools(op, isTrue(*left), isTrue(*right)))};
  if (isRelation(op)) return Cells{boolCell(holds(op, *left, *right))};
  if (left_type == kString) return joined(left, right);
  if (left_type == kNum && right_type == kNum) {
    const auto value = ofNums(op, *left, *right);
    return finite(value ? std::optional(Cells{*value}) : std::nullopt);
  }
  return finite(ofVectors(draft.known, op, left_type, left, right_type, right));
}

}  // namespace cobot_command::rapid
