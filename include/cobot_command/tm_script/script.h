// A script as a tree of plain values, and its conversion to text.
//
// Consecutive operators of the same precedence form one node with many operands. The depth of a tree is
// therefore bounded by the brackets of its text (kMaxNesting), not by its length.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/tm_script/boxed.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// Nested brackets, braces and conditions on one line.
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
  std::optional<double> written = std::nullopt;  ///< of a float: the double nearest to the written number
};
/// A variable. If a text is expected and no variable has this name, the name is the text.
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
/// Steps are operators and casts, outermost first: -(int)x
struct Prefix {
  using Step = std::variant<PrefixOperator, Type>;
  std::vector<Step> steps;
  Boxed<Expression> operand;
};
struct Postfix {
  Boxed<Expression> operand;
  PostfixOperator step;
};
/// a + b - c: evaluated from left to right. operators[i] is before operands[i + 1]; all have the same
/// precedence.
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
/// a = b += value: evaluated from right to left. operators[i] is after targets[i]; std::nullopt means "=".
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
/// Parsing it gives the same tree. An expression with an operator is in brackets if it is inside another
/// operator.
[[nodiscard]] std::string toText(const Expression& expression);
[[nodiscard]] std::string toText(const Statement& statement);
/// Lines joined by CR LF, without lines that contain no statement.
[[nodiscard]] std::string toText(const Script& script);

}  // namespace cobot_command::tm_script
