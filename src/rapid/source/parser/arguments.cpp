// The arguments of calls: the part of ExpressionParser with rules of its own for commas.
#include "parser/expression_parser.h"
#include "parser/recovery.h"

namespace cobot_command::rapid {

namespace {

/// If the `;` of an instruction without arguments or value is missing, the next line begins with the next
/// instruction. A first argument with a name could begin in the same way: on a line of its own it is unusual.
bool beginsInstruction(const Cursor& cursor) {
  if (!cursor.startsLine() || !cursor.is(TokenKind::Name)) return false;
  switch (cursor.nextKind()) {
    case TokenKind::Assign:
    case TokenKind::Colon:
    case TokenKind::Name:
    case TokenKind::Number:
    case TokenKind::Text:
      return true;
    default:
      return false;
  }
}

}  // namespace

bool ExpressionParser::optional(ChildList& parent) {
  if (!canBegin() || beginsInstruction(cursor_)) return true;
  const NodeIndex value = expression();
  parent.add(value);
  return value != kNoNode;
}

bool ExpressionParser::arguments(ChildList& call) {
  const bool has_first = cursor_.is(TokenKind::Backslash) || cursor_.is(TokenKind::Comma) ||
                         cursor_.is(TokenKind::Star) || (canBegin() && !beginsInstruction(cursor_));
  if (!has_first) return true;
  const NodeIndex first = argument();
  call.add(first);
  return first != kNoNode && moreArguments(call);
}

bool ExpressionParser::argumentsInParentheses(ChildList& call) {
  if (!enter()) return false;
  cursor_.advance();
  bool is_read = true;
  if (!cursor_.is(TokenKind::RightParenthesis)) {
    const NodeIndex first = argument();
    call.add(first);
    is_read = first != kNoNode && moreArguments(call);
  }
  --depth_;
  if (!is_read || cursor_.take(TokenKind::RightParenthesis)) return is_read;
  cursor_.reportExpected("',' or ')'");
  return false;
}

bool ExpressionParser::moreArguments(ChildList& call) {
  while (true) {
    const TokenIndex here = cursor_.index();
    if (cursor_.take(TokenKind::Comma)) {
      const bool is_refused = cursor_.is(TokenKind::Backslash) && cursor_.dialect() == Dialect::S4c;
      if (is_refused) cursor_.report(kinds::kCommaBeforeOption, here);
    } else if (canBegin() && !cursor_.startsLine()) {
      cursor_.report(kinds::kNoComma, here);
    } else if (!cursor_.is(TokenKind::Backslash)) {
      return true;
    }
    const NodeIndex next = argument();
    if (next == kNoNode) return false;
    call.add(next);
  }
}

NodeIndex ExpressionParser::argument() {
  if (cursor_.is(TokenKind::Backslash)) return optionalArgument();
  const bool is_named = cursor_.is(TokenKind::Name) && cursor_.nextKind() == TokenKind::Assign;
  return is_named ? namedArgument() : argumentValue();
}

NodeIndex ExpressionParser::argumentValue() {
  if (!cursor_.is(TokenKind::Star)) return element();
  cursor_.report(kinds::kStarPosition, cursor_.index());
  return takeLeaf(tree_, cursor_, NodeKind::Star);
}

NodeIndex ExpressionParser::namedArgument() {
  const NodeIndex node = takeLeaf(tree_, cursor_, NodeKind::Argument);
  cursor_.advance();
  const NodeIndex value = argumentValue();
  if (value == kNoNode) return kNoNode;
  ChildList(tree_, node).add(value);
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ExpressionParser::optionalArgument() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Argument);
  tree_[node].flags |= Node::Optional;
  cursor_.advance();
  tree_[node].name = takeName(cursor_, "the name of an argument");
  if (tree_[node].name == kNoToken || !optionValue(node)) return kNoNode;
  closeNode(tree_, cursor_, node);
  return node;
}

/// `:=value`, `?parameter` or nothing. False after an error.
bool ExpressionParser::optionValue(NodeIndex argument) {
  NodeIndex value = kNoNode;
  if (cursor_.take(TokenKind::Question)) {
    tree_[argument].flags |= Node::Conditional;
    const NodeIndex parameter = openNode(tree_, cursor_, NodeKind::Reference);
    tree_[parameter].name = takeName(cursor_, "the name of a parameter");
    value = tree_[parameter].name == kNoToken ? kNoNode : parameter;
  } else if (cursor_.is(TokenKind::Assign) || cursor_.is(TokenKind::Equal)) {
    if (cursor_.is(TokenKind::Equal)) cursor_.report(kinds::kAssignMeant, cursor_.index());
    cursor_.advance();
    value = argumentValue();
  } else {
    return true;
  }
  ChildList(tree_, argument).add(value);
  return value != kNoNode;
}

}  // namespace cobot_command::rapid
