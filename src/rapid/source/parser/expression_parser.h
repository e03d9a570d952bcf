// Expressions, and the arguments of calls.
#pragma once

#include "parser/child_list.h"
#include "parser/cursor.h"

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

/// Functions that return a node return kNoNode after a syntax error, which they have reported.
class ExpressionParser {
 public:
  ExpressionParser(Cursor& cursor, Tree& tree) : cursor_(cursor), tree_(tree) {}

  [[nodiscard]] NodeIndex expression();
  /// An expression of a list: what is missing between two commas is E218.
  [[nodiscard]] NodeIndex element();
  /// Precondition: a Name or a Placeholder is here.
  [[nodiscard]] NodeIndex reference();
  /// `EXPR , EXPR ...` up to `close`, which is taken; `node` is open, and closed then. False after an error.
  [[nodiscard]] bool elements(NodeIndex node, TokenKind close);
  /// The expression after RETURN and RAISE, if there is one. False after an error.
  [[nodiscard]] bool optional(ChildList& parent);
  /// The arguments of a procedure call, without brackets. False after an error.
  [[nodiscard]] bool arguments(ChildList& call);
  /// Arguments in brackets, of which the first is here. False after an error.
  [[nodiscard]] bool argumentsInParentheses(ChildList& call);

  /// True if an expression can begin with the token here.
  [[nodiscard]] bool canBegin() const;

 private:
  using Operand = NodeIndex (ExpressionParser::*)();

  NodeIndex conjunction();
  NodeIndex negatable();
  NodeIndex relation();
  NodeIndex sum();
  NodeIndex product();
  NodeIndex primary();
  NodeIndex leaf();
  template <Operand kOperand, bool (*kIsOperator)(TokenKind)>
  NodeIndex chain(NodeIndex first);
  NodeIndex prefixed(NodeKind kind, Operand operand);
  NodeIndex nested(NodeKind kind, Operand operand);
  NodeIndex enclosed(NodeKind kind);
  NodeIndex function();
  NodeIndex placeholder();

  bool moreArguments(ChildList& call);
  NodeIndex argument();
  NodeIndex namedArgument();
  NodeIndex optionalArgument();
  NodeIndex argumentValue();
  bool optionValue(NodeIndex argument);

  bool enter();

  Cursor& cursor_;
  Tree& tree_;
  int depth_ = 0;
};

}  // namespace cobot_command::rapid
