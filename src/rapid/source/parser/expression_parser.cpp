#include "parser/expression_parser.h"

#include "parser/recovery.h"

#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

namespace {

bool isDisjunction(TokenKind kind) {
  return kind == TokenKind::Or || kind == TokenKind::Xor;
}
bool isConjunction(TokenKind kind) {
  return kind == TokenKind::And;
}
bool isRelation(TokenKind kind) {
  return kind >= TokenKind::Equal && kind <= TokenKind::GreaterEqual;
}
bool isSign(TokenKind kind) {
  return kind == TokenKind::Plus || kind == TokenKind::Minus;
}
bool isProduct(TokenKind kind) {
  return kind == TokenKind::Star || kind == TokenKind::Slash || kind == TokenKind::Div ||
         kind == TokenKind::Mod;
}

/// What follows a place where an element of a list is missing.
bool endsElement(TokenKind kind) {
  switch (kind) {
    case TokenKind::Comma:
    case TokenKind::Semicolon:
    case TokenKind::Colon:
    case TokenKind::RightParenthesis:
    case TokenKind::RightBracket:
    case TokenKind::RightBrace:
      return true;
    default:
      return false;
  }
}

bool isLeaf(TokenKind kind) {
  return kind == TokenKind::Number || kind == TokenKind::Name || kind == TokenKind::Text;
}

const char* commaOr(TokenKind close) {
  if (close == TokenKind::RightParenthesis) return "',' or ')'";
  return close == TokenKind::RightBracket ? "',' or ']'" : "',' or '}'";
}

}  // namespace

bool ExpressionParser::canBegin() const {
  switch (cursor_.kind()) {
    case TokenKind::Name:
    case TokenKind::Number:
    case TokenKind::Text:
    case TokenKind::Placeholder:
    case TokenKind::True:
    case TokenKind::False:
    case TokenKind::Not:
    case TokenKind::LeftParenthesis:
    case TokenKind::LeftBracket:
      return true;
    default:
      return isSign(cursor_.kind());
  }
}

template <ExpressionParser::Operand kOperand, bool (*kIsOperator)(TokenKind)>
NodeIndex ExpressionParser::chain(NodeIndex first) {
  if (first == kNoNode || !kIsOperator(cursor_.kind())) return first;
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Chain);
  tree_[node].first = tree_[first].first;
  ChildList operands(tree_, node);
  operands.add(first);
  while (kIsOperator(cursor_.kind())) {
    const NodeIndex operation = openNode(tree_, cursor_, NodeKind::Operation);
    cursor_.advance();
    const NodeIndex operand = (this->*kOperand)();
    if (operand == kNoNode) return kNoNode;
    ChildList(tree_, operation).add(operand);
    closeNode(tree_, cursor_, operation);
    operands.add(operation);
  }
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ExpressionParser::expression() {
  // Most expressions are the numbers of positions: no need to ask each rank for its operator.
  if (isLeaf(cursor_.kind()) && endsElement(cursor_.nextKind())) return leaf();
  return chain<&ExpressionParser::conjunction, isDisjunction>(conjunction());
}

/// NOT at its beginning is of the whole chain.
NodeIndex ExpressionParser::conjunction() {
  if (!cursor_.is(TokenKind::Not)) return chain<&ExpressionParser::negatable, isConjunction>(relation());
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Not);
  cursor_.advance();
  const NodeIndex operand = chain<&ExpressionParser::negatable, isConjunction>(relation());
  if (operand == kNoNode) return kNoNode;
  ChildList(tree_, node).add(operand);
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ExpressionParser::negatable() {
  return cursor_.is(TokenKind::Not) ? prefixed(NodeKind::Not, &ExpressionParser::relation) : relation();
}

/// Relations are not grouped: what follows the first one is left to the caller.
NodeIndex ExpressionParser::relation() {
  const NodeIndex left = sum();
  if (left == kNoNode || !isRelation(cursor_.kind())) return left;
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Chain);
  tree_[node].first = tree_[left].first;
  const NodeIndex operation = prefixed(NodeKind::Operation, &ExpressionParser::sum);
  if (operation == kNoNode) return kNoNode;
  ChildList operands(tree_, node);
  operands.add(left);
  operands.add(operation);
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ExpressionParser::sum() {
  const NodeIndex first =
      isSign(cursor_.kind()) ? nested(NodeKind::Sign, &ExpressionParser::product) : product();
  return chain<&ExpressionParser::product, isSign>(first);
}

NodeIndex ExpressionParser::product() {
  return chain<&ExpressionParser::primary, isProduct>(primary());
}

/// A number, a text, or a name alone.
NodeIndex ExpressionParser::leaf() {
  const TokenKind kind = cursor_.kind();
  return takeLeaf(tree_, cursor_,
                  kind == TokenKind::Number ? NodeKind::Number
                  : kind == TokenKind::Text ? NodeKind::String
                                            : NodeKind::Reference);
}

NodeIndex ExpressionParser::primary() {
  switch (cursor_.kind()) {
    case TokenKind::Number:
    case TokenKind::Text:
      return leaf();
    case TokenKind::True:
    case TokenKind::False:
      return takeLeaf(tree_, cursor_, NodeKind::Bool);
    case TokenKind::Placeholder:
      return placeholder();
    case TokenKind::Name:
      return cursor_.nextKind() == TokenKind::LeftParenthesis ? function() : reference();
    case TokenKind::LeftParenthesis:
    case TokenKind::LeftBracket:
      return enclosed(cursor_.is(TokenKind::LeftBracket) ? NodeKind::Aggregate : NodeKind::Parentheses);
    case TokenKind::Plus:
    case TokenKind::Minus:
      return nested(NodeKind::Sign, &ExpressionParser::primary);
    default:
      cursor_.reportExpected("an expression");
      return kNoNode;
  }
}

NodeIndex ExpressionParser::placeholder() {
  cursor_.report(kinds::kPlaceholder, cursor_.index());
  return takeLeaf(tree_, cursor_, NodeKind::Placeholder);
}

/// A node with a word or sign, and one operand after it.
NodeIndex ExpressionParser::prefixed(NodeKind kind, Operand operand) {
  const NodeIndex node = openNode(tree_, cursor_, kind);
  cursor_.advance();
  const NodeIndex child = (this->*operand)();
  if (child == kNoNode) return kNoNode;
  ChildList(tree_, node).add(child);
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ExpressionParser::nested(NodeKind kind, Operand operand) {
  if (!enter()) return kNoNode;
  const NodeIndex node = prefixed(kind, operand);
  --depth_;
  return node;
}

NodeIndex ExpressionParser::enclosed(NodeKind kind) {
  if (!enter()) return kNoNode;
  const NodeIndex node = openNode(tree_, cursor_, kind);
  cursor_.advance();
  bool is_read = false;
  if (kind == NodeKind::Parentheses) {
    const NodeIndex inner = element();
    ChildList(tree_, node).add(inner);
    is_read = inner != kNoNode && cursor_.take(TokenKind::RightParenthesis);
    if (inner != kNoNode && !is_read) cursor_.reportExpected("')'");
    closeNode(tree_, cursor_, node);
  } else {
    is_read = elements(node, TokenKind::RightBracket);
  }
  --depth_;
  return is_read ? node : kNoNode;
}

NodeIndex ExpressionParser::element() {
  if (!endsElement(cursor_.kind())) return expression();
  cursor_.report(kinds::kSomethingMissing, cursor_.index());
  return kNoNode;
}

bool ExpressionParser::elements(NodeIndex node, TokenKind close) {
  ChildList children(tree_, node);
  do {
    const NodeIndex child = element();
    if (child == kNoNode) return false;
    children.add(child);
  } while (cursor_.take(TokenKind::Comma));
  const bool is_closed = cursor_.take(close);
  if (!is_closed) cursor_.reportExpected(commaOr(close));
  closeNode(tree_, cursor_, node);
  return is_closed;
}

NodeIndex ExpressionParser::reference() {
  if (cursor_.is(TokenKind::Placeholder)) return placeholder();
  const NodeIndex node = takeLeaf(tree_, cursor_, NodeKind::Reference);
  ChildList selectors(tree_, node);
  while (cursor_.is(TokenKind::LeftBrace) || cursor_.is(TokenKind::Dot)) {
    const bool is_index = cursor_.is(TokenKind::LeftBrace);
    if (is_index && !enter()) return kNoNode;
    const NodeIndex selector = openNode(tree_, cursor_, is_index ? NodeKind::Index : NodeKind::Part);
    cursor_.advance();
    if (is_index) {
      const bool is_read = elements(selector, TokenKind::RightBrace);
      --depth_;
      if (!is_read) return kNoNode;
    } else {
      tree_[selector].name = takeName(cursor_, "the name of a component");
      if (tree_[selector].name == kNoToken) return kNoNode;
      closeNode(tree_, cursor_, selector);
    }
    selectors.add(selector);
  }
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ExpressionParser::function() {
  const NodeIndex node = takeLeaf(tree_, cursor_, NodeKind::Function);
  ChildList call(tree_, node);
  if (!argumentsInParentheses(call)) return kNoNode;
  closeNode(tree_, cursor_, node);
  return node;
}

bool ExpressionParser::enter() {
  if (depth_ < kMostNesting) {
    ++depth_;
    return true;
  }
  cursor_.report(kinds::kNestedTooDeep, cursor_.index(), kMostNesting);
  return false;
}

}  // namespace cobot_command::rapid
