#include "parser/instruction_parser.h"

#include "parser/recovery.h"

namespace cobot_command::rapid {

bool InstructionParser::canBegin(TokenKind kind) {
  switch (kind) {
    case TokenKind::Name:
    case TokenKind::Percent:
    case TokenKind::Placeholder:
    case TokenKind::If:
    case TokenKind::For:
    case TokenKind::While:
    case TokenKind::Test:
    case TokenKind::Goto:
    case TokenKind::Return:
    case TokenKind::Raise:
    case TokenKind::Retry:
    case TokenKind::Trynext:
    case TokenKind::Exit:
    case TokenKind::Connect:
      return true;
    default:
      return false;
  }
}

NodeKind InstructionParser::kindHere() const {
  switch (cursor_.kind()) {
    case TokenKind::Goto:
      return NodeKind::Goto;
    case TokenKind::Return:
      return NodeKind::Return;
    case TokenKind::Raise:
      return NodeKind::Raise;
    case TokenKind::Retry:
      return NodeKind::Retry;
    case TokenKind::Trynext:
      return NodeKind::Trynext;
    case TokenKind::Exit:
      return NodeKind::Exit;
    case TokenKind::Connect:
      return NodeKind::Connect;
    case TokenKind::Percent:
      return NodeKind::LateCall;
    case TokenKind::Placeholder:
      return cursor_.nextKind() == TokenKind::Assign ? NodeKind::Assignment : NodeKind::Placeholder;
    default:
      return kindOfName();
  }
}

NodeKind InstructionParser::kindOfName() const {
  switch (cursor_.nextKind()) {
    case TokenKind::Colon:
      return NodeKind::Label;
    case TokenKind::Assign:
    case TokenKind::Equal:
    case TokenKind::LeftBrace:
    case TokenKind::Dot:
      return NodeKind::Assignment;
    default:
      return NodeKind::Call;
  }
}

NodeIndex InstructionParser::open(NodeKind kind) {
  const NodeIndex node = openNode(tree_, cursor_, kind);
  const bool is_named = kind == NodeKind::Call || kind == NodeKind::Label;
  if (is_named) tree_[node].name = cursor_.index();
  return node;
}

NodeIndex InstructionParser::instruction() {
  const NodeIndex node = open(kindHere());
  ChildList children(tree_, node);
  if (!read(node, children)) recover(cursor_);
  closeNode(tree_, cursor_, node);
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
  return node;
}

/// False after an error.
bool InstructionParser::read(NodeIndex node, ChildList& children) {
  switch (tree_[node].kind) {
    case NodeKind::Assignment:
      return assignment(children) && takeSemicolon(cursor_);
    case NodeKind::Call:
      return call(node, children) && takeSemicolon(cursor_);
    case NodeKind::LateCall:
      return lateCall(children) && takeSemicolon(cursor_);
    case NodeKind::Connect:
      return connect(node, children) && takeSemicolon(cursor_);
    case NodeKind::Label:
      cursor_.advance();
      cursor_.advance();
      return true;
    case NodeKind::Placeholder:
      return placeholder();
    case NodeKind::Goto:
      cursor_.advance();
      tree_[node].name = takeName(cursor_, "the name of a label");
      return tree_[node].name != kNoToken && takeSemicolon(cursor_);
    case NodeKind::Return:
    case NodeKind::Raise:
      cursor_.advance();
      return expressions_.optional(children) && takeSemicolon(cursor_);
    default:  // RETRY, TRYNEXT, EXIT
      cursor_.advance();
      return takeSemicolon(cursor_);
  }
}

bool InstructionParser::assignment(ChildList& children) {
  const NodeIndex target = expressions_.reference();
  children.add(target);
  if (target == kNoNode) return false;
  if (cursor_.is(TokenKind::Equal)) cursor_.report(kinds::kAssignMeant, cursor_.index());
  if (!cursor_.take(TokenKind::Assign) && !cursor_.take(TokenKind::Equal)) {
    cursor_.reportExpected("':='");
    return false;
  }
  const NodeIndex value = expressions_.expression();
  children.add(value);
  return value != kNoNode;
}

bool InstructionParser::call(NodeIndex node, ChildList& children) {
  tree_[node].name = cursor_.index();
  cursor_.advance();
  return hasBracketsOfCall() ? callInBrackets(children) : expressions_.arguments(children);
}

/// `f(a,b);`, `f();` and `f(\x);`, but not `f (a);`, whose argument is in brackets.
bool InstructionParser::hasBracketsOfCall() const {
  if (!cursor_.is(TokenKind::LeftParenthesis)) return false;
  if (cursor_.nextKind() == TokenKind::RightParenthesis) return true;
  int depth = 1;
  for (TokenIndex token = cursor_.index() + 1;; ++token) {
    switch (cursor_.kindAt(token)) {
      case TokenKind::LeftParenthesis:
      case TokenKind::LeftBracket:
      case TokenKind::LeftBrace:
        ++depth;
        break;
      case TokenKind::RightParenthesis:
      case TokenKind::RightBracket:
      case TokenKind::RightBrace:
        if (--depth == 0) return false;
        break;
      case TokenKind::Comma:
      case TokenKind::Backslash:
      case TokenKind::Assign:
        if (depth == 1) return true;
        break;
      case TokenKind::Semicolon:
      case TokenKind::End:
        return false;
      default:
        // No expression goes beyond such a word. Without this, a file of open brackets takes quadratic time.
        if (isAnchor(cursor_.kindAt(token))) return false;
        break;
    }
  }
}

bool InstructionParser::callInBrackets(ChildList& children) {
  cursor_.report(kinds::kCallBrackets, cursor_.index());
  return expressions_.argumentsInParentheses(children);
}

bool InstructionParser::lateCall(ChildList& children) {
  cursor_.advance();
  const NodeIndex name = expressions_.expression();
  children.add(name);
  if (name == kNoNode) return false;
  if (!cursor_.take(TokenKind::Percent)) {
    cursor_.reportExpected("'%'");
    return false;
  }
  return expressions_.arguments(children);
}

bool InstructionParser::connect(NodeIndex node, ChildList& children) {
  cursor_.advance();
  if (!cursor_.is(TokenKind::Name) && !cursor_.is(TokenKind::Placeholder)) {
    cursor_.reportExpected("a variable");
    return false;
  }
  const NodeIndex target = expressions_.reference();
  children.add(target);
  if (target == kNoNode) return false;
  if (!cursor_.take(TokenKind::With)) {
    cursor_.reportExpected("WITH");
    return false;
  }
  tree_[node].name = takeName(cursor_, "the name of a trap");
  return tree_[node].name != kNoToken;
}

bool InstructionParser::placeholder() {
  cursor_.report(kinds::kPlaceholder, cursor_.index());
  cursor_.advance();
  cursor_.take(TokenKind::Semicolon);
  return true;
}

}  // namespace cobot_command::rapid
