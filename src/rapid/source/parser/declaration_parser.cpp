#include "parser/declaration_parser.h"

#include "parser/recovery.h"

namespace cobot_command::rapid {

namespace {

bool isStorage(TokenKind kind) {
  return kind == TokenKind::Var || kind == TokenKind::Pers || kind == TokenKind::Const;
}

}  // namespace

bool DeclarationParser::isData() const {
  const bool is_task = isIrc5Word(cursor_, TokenKind::Task) && isStorage(cursor_.nextKind());
  return isStorage(cursor_.kind()) || cursor_.is(TokenKind::Task) || is_task;
}

bool DeclarationParser::isType() const {
  return cursor_.is(TokenKind::Record) || cursor_.is(TokenKind::Alias);
}

NodeIndex DeclarationParser::open(NodeKind kind, Prefix prefix) {
  const NodeIndex node = openNode(tree_, cursor_, kind);
  tree_[node].first = prefix.first;
  tree_[node].flags = prefix.flags;
  return node;
}

void DeclarationParser::close(NodeIndex declaration, bool is_read) {
  if (!is_read) recover(cursor_);
  closeNode(tree_, cursor_, declaration);
  if (cursor_.takeFaulty()) tree_[declaration].flags |= Node::Faulty;
}

NodeIndex DeclarationParser::data(Prefix prefix) {
  if (!isStorage(cursor_.kind())) {
    const TokenIndex task = cursor_.index();
    const bool is_refused = cursor_.dialect() == Dialect::S4c;
    cursor_.advance();
    if (is_refused) cursor_.report(kinds::kNotInS4c, task, "TASK " + std::string(toString(cursor_.kind())));
    prefix.flags |= Node::Task;
  }
  const NodeIndex node = open(NodeKind::Data, prefix);
  ChildList children(tree_, node);
  bool is_read = isStorage(cursor_.kind());
  if (!is_read) cursor_.reportExpected("VAR, PERS or CONST");
  if (is_read) cursor_.advance();
  is_read = is_read && dataParts(node, children) && takeSemicolon(cursor_);
  close(node, is_read);
  if (is_read && !tree_[node].has(Node::Faulty)) checkValue(node);
  return node;
}

/// Type, name, dimensions and value.
bool DeclarationParser::dataParts(NodeIndex data, ChildList& children) {
  if (!typeAndName(data, children)) return false;
  if (cursor_.is(TokenKind::LeftBrace)) {
    const NodeIndex dimensions = openNode(tree_, cursor_, NodeKind::Dimensions);
    children.add(dimensions);
    cursor_.advance();
    if (!expressions_.elements(dimensions, TokenKind::RightBrace)) return false;
  }
  if (!hasValue()) return true;
  const NodeIndex value = expressions_.expression();
  children.add(value);
  return value != kNoNode;
}

bool DeclarationParser::hasValue() {
  if (cursor_.is(TokenKind::Equal)) cursor_.report(kinds::kAssignMeant, cursor_.index());
  return cursor_.take(TokenKind::Assign) || cursor_.take(TokenKind::Equal);
}

void DeclarationParser::checkValue(NodeIndex data) {
  const Node& node = tree_[data];
  if (node.word == TokenKind::Var || tree_.expressionOf(data) != kNoNode) return;
  const bool is_const = node.word == TokenKind::Const;
  const bool is_zero = cursor_.dialect() == Dialect::Irc5;
  const FindingKind& kind = is_const  ? kinds::kConstNoValue
                            : is_zero ? kinds::kPersZero
                                      : kinds::kPersNoValue;
  cursor_.reportHarmless(kind, node.name, quoted(cursor_.textOf(node.name)));
}

NodeIndex DeclarationParser::typeName() {
  const TokenIndex name = takeName(cursor_, "a data type");
  if (name == kNoToken) return kNoNode;
  Node node;
  node.kind = NodeKind::TypeName;
  node.first = name;
  node.last = name;
  node.name = name;
  return tree_.add(node);
}

bool DeclarationParser::typeAndName(NodeIndex declaration, ChildList& children) {
  const NodeIndex type = typeName();
  children.add(type);
  if (type == kNoNode) return false;
  tree_[declaration].name = takeName(cursor_, "a name");
  return tree_[declaration].name != kNoToken;
}

NodeIndex DeclarationParser::type(Prefix prefix) {
  return cursor_.is(TokenKind::Record) ? record(prefix) : alias(prefix);
}

NodeIndex DeclarationParser::alias(Prefix prefix) {
  const NodeIndex node = open(NodeKind::Alias, prefix);
  ChildList children(tree_, node);
  cursor_.advance();
  close(node, typeAndName(node, children) && takeSemicolon(cursor_));
  return node;
}

NodeIndex DeclarationParser::record(Prefix prefix) {
  const NodeIndex node = open(NodeKind::Record, prefix);
  const TokenIndex word = cursor_.index();
  ChildList children(tree_, node);
  cursor_.advance();
  tree_[node].name = takeName(cursor_, "a name");
  if (tree_[node].name == kNoToken) skipLine(cursor_);
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
  while (!cursor_.is(TokenKind::End) && !isAnchor(cursor_.kind())) children.add(component());
  if (!cursor_.take(TokenKind::Endrecord)) {
    cursor_.reportHarmless(kinds::kNotClosed, word, "RECORD", "ENDRECORD");
  } else {
    cursor_.take(TokenKind::Semicolon);
  }
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex DeclarationParser::component() {
  const TokenIndex first = cursor_.index();
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Component);
  ChildList children(tree_, node);
  const bool is_read = typeAndName(node, children) && takeSemicolon(cursor_);
  close(node, is_read);
  if (cursor_.index() == first) cursor_.advance();
  return node;
}

bool DeclarationParser::parameters(ChildList& routine) {
  if (!cursor_.is(TokenKind::LeftParenthesis)) {
    cursor_.reportExpected("'('");
    return false;
  }
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Parameters);
  routine.add(node);
  cursor_.advance();
  bool is_read = cursor_.is(TokenKind::RightParenthesis);
  if (!is_read) {
    ChildList parameters(tree_, node);
    do {
      is_read = parameterGroup(parameters);
    } while (is_read && (cursor_.take(TokenKind::Comma) || cursor_.is(TokenKind::Backslash)));
  }
  if (is_read && !cursor_.is(TokenKind::RightParenthesis)) {
    cursor_.reportExpected("',' or ')'");
    is_read = false;
  }
  if (is_read) cursor_.advance();
  closeNode(tree_, cursor_, node);
  return is_read;
}

/// One parameter, or optional ones that exclude each other.
bool DeclarationParser::parameterGroup(ChildList& parameters) {
  const bool is_optional = cursor_.take(TokenKind::Backslash);
  if (!parameter(parameters, is_optional ? Node::Optional : 0)) return false;
  while (is_optional && cursor_.take(TokenKind::Bar)) {
    cursor_.take(TokenKind::Backslash);
    if (!parameter(parameters, Node::Optional | Node::Excludes)) return false;
  }
  return true;
}

bool DeclarationParser::parameter(ChildList& parameters, std::uint8_t flags) {
  if (cursor_.is(TokenKind::Comma) || cursor_.is(TokenKind::RightParenthesis)) {
    cursor_.report(kinds::kSomethingMissing, cursor_.index());
    return false;
  }
  const bool is_placeholder = cursor_.is(TokenKind::Placeholder) && cursor_.nextKind() != TokenKind::Name;
  if (is_placeholder) {
    cursor_.report(kinds::kPlaceholder, cursor_.index());
    parameters.add(takeLeaf(tree_, cursor_, NodeKind::Placeholder));
    return true;
  }
  const NodeIndex node = open(NodeKind::Parameter, {cursor_.index(), flags});
  ChildList children(tree_, node);
  const TokenKind mode = cursor_.kind();
  if (mode == TokenKind::Inout || mode == TokenKind::Var || mode == TokenKind::Pers) {
    cursor_.advance();
  } else {
    tree_[node].word = TokenKind::Name;
  }
  const bool is_read = typeAndName(node, children) && parameterDimensions(children);
  closeNode(tree_, cursor_, node);
  parameters.add(node);
  return is_read;
}

/// `{*,*}` or nothing.
bool DeclarationParser::parameterDimensions(ChildList& parameter) {
  if (!cursor_.is(TokenKind::LeftBrace)) return true;
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Dimensions);
  parameter.add(node);
  cursor_.advance();
  ChildList dimensions(tree_, node);
  do {
    const bool is_placeholder = cursor_.is(TokenKind::Placeholder);
    if (is_placeholder) cursor_.report(kinds::kPlaceholder, cursor_.index());
    if (!is_placeholder && !cursor_.is(TokenKind::Star)) {
      cursor_.reportExpected("'*'");
      return false;
    }
    dimensions.add(takeLeaf(tree_, cursor_, is_placeholder ? NodeKind::Placeholder : NodeKind::Star));
  } while (cursor_.take(TokenKind::Comma));
  const bool is_closed = cursor_.take(TokenKind::RightBrace);
  if (!is_closed) cursor_.reportExpected("',' or '}'");
  closeNode(tree_, cursor_, node);
  return is_closed;
}

}  // namespace cobot_command::rapid
