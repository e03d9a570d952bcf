// A script as a tree of plain values, and its text.
//
// Operators of one precedence in a row stand in one node with many operands, so that the depth of a tree is
// bounded by the brackets of its text (kMaxNesting), not by its length.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/tm_script/boxed.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// Brackets, braces and conditions within each other on one line.
inline constexpr int kMaxNesting = 64;

enum class BinaryOperator {
  Or,
  And,
  BitOr,
  BitXor,
  BitAnd,
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  ShiftLeft,
  ShiftRight,
  Add,
  Subtract,
  Multiply,
  Divide,
  Modulo
};
enum class PrefixOperator { Increment, Decrement, Plus, Minus, Not, Complement };
enum class PostfixOperator { Increment, Decrement };

struct Expression;
using Expressions = std::vector<Expression>;

struct Literal {
  Scalar value;
  std::optional<double> written = std::nullopt;  ///< of a float: the nearest double to what is written
};
/// A variable; where a text is wanted and no variable has the name, the name itself.
struct Name {
  std::string name;
};
struct ArrayLiteral {
  Expressions elements;
};
struct Call {
  std::string function;
  Expressions arguments;
};
/// IO["ControlBox"].DO, Robot[0].Joint
struct Attribute {
  std::string object;
  Expressions keys;  ///< one or two
  std::string name;
};
struct Element {
  Boxed<Expression> array;
  Boxed<Expression> index;
};
/// Steps are operators and casts, the outermost first: -(int)x
struct Prefix {
  using Step = std::variant<PrefixOperator, Type>;
  std::vector<Step> steps;
  Boxed<Expression> operand;
};
struct Postfix {
  Boxed<Expression> operand;
  PostfixOperator step;
};
/// a + b - c: from the left to the right; operators[i] stands before operands[i + 1], all of one precedence.
struct Chain {
  Expressions operands;
  std::vector<BinaryOperator> operators;
};
/// c1 ? r1 : c2 ? r2 : otherwise
struct Conditional {
  Expressions conditions;
  Expressions results;
  Boxed<Expression> otherwise;
};
/// a = b += value: from the right to the left; operators[i] stands behind targets[i], nothing means "=".
struct Assignment {
  Expressions targets;
  std::vector<std::optional<BinaryOperator>> operators;
  Boxed<Expression> value;
};

struct Expression {
  std::variant<Literal, Name, ArrayLiteral, Call, Attribute, Element, Prefix, Postfix, Chain, Conditional,
               Assignment>
      node;
};

/// float[] p = {1, 2}
struct Declaration {
  Type type;
  std::string name;
  std::optional<Expression> initial;
};

struct Statement {
  int line = 0;  ///< from 1
  std::variant<Declaration, Expression> content;
};

using Script = std::vector<Statement>;

[[nodiscard]] std::string toText(BinaryOperator binary);
[[nodiscard]] std::string toText(PrefixOperator prefix);
[[nodiscard]] std::string toText(PostfixOperator postfix);
/// Reads back as the same tree. Whatever has an operator stands in brackets inside another operator.
[[nodiscard]] std::string toText(const Expression& expression);
[[nodiscard]] std::string toText(const Statement& statement);
/// Lines joined by CR LF, without those that hold no statement.
[[nodiscard]] std::string toText(const Script& script);

}  // namespace cobot_command::tm_script
