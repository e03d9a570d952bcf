#include "parser/list_parser.h"

#include <utility>

#include "parser/recovery.h"

#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

bool ListParser::isHandler() const {
  switch (cursor_.kind()) {
    case TokenKind::Backward:
    case TokenKind::Error:
    case TokenKind::Undo:
      return true;
    default:
      return isIrc5Word(cursor_, TokenKind::Undo) && cursor_.startsLine() && cursor_.next().startsLine();
  }
}

bool ListParser::takeAbandoned() {
  return std::exchange(is_abandoned_, false);
}

bool ListParser::endsList() const {
  switch (cursor_.kind()) {
    case TokenKind::Else:
    case TokenKind::Elseif:
    case TokenKind::Endif:
      return ifs_ > 0;
    case TokenKind::Case:
    case TokenKind::Default:
    case TokenKind::Endtest:
      return tests_ > 0;
    case TokenKind::Endfor:
      return fors_ > 0;
    case TokenKind::Endwhile:
      return whiles_ > 0;
    default:
      return endsRoutine(cursor_) || isHandler();
  }
}

NodeIndex ListParser::list(bool has_declarations) {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::List);
  ChildList children(tree_, node);
  while (!endsList()) item(children, has_declarations);
  closeNode(tree_, cursor_, node);
  return node;
}

/// Takes at least one token.
void ListParser::item(ChildList& list, bool& has_declarations) {
  if (declarations_.isData() || declarations_.isType()) {
    return declaration(list, has_declarations && declarations_.isData());
  }
  if (cursor_.is(TokenKind::Local)) {
    cursor_.report(kinds::kLocalInRoutine, cursor_.index());
    cursor_.advance();
    return;
  }
  has_declarations = false;
  if (InstructionParser::canBegin(cursor_.kind())) {
    list.add(instruction());
  } else if (isAnchor(cursor_.kind())) {
    strayWord();
  } else {
    nothing(list);
  }
}

void ListParser::declaration(ChildList& list, bool may_be_here) {
  const TokenIndex first = cursor_.index();
  if (!may_be_here) cursor_.reportHarmless(kinds::kLateDeclaration, first);
  list.add(declarations_.isData() ? declarations_.data({first}) : declarations_.type({first}));
}

void ListParser::strayWord() {
  const TokenKind word = cursor_.kind();
  cursor_.report(kinds::kEndsNothing, cursor_.index(), toString(word));
  cursor_.advance();
  if (word == TokenKind::Elseif) recoverHeader(cursor_, TokenKind::Then);
  if (word == TokenKind::Case || word == TokenKind::Default) recoverHeader(cursor_, TokenKind::Colon);
  static_cast<void>(cursor_.takeFaulty());
}

/// One Unread for text in a row.
void ListParser::nothing(ChildList& list) {
  const TokenIndex first = cursor_.index();
  cursor_.reportExpected("an instruction");
  recover(cursor_);
  if (cursor_.index() == first) cursor_.advance();
  static_cast<void>(cursor_.takeFaulty());
  const bool is_in_row = list.last() != kNoNode && tree_[list.last()].kind == NodeKind::Unread;
  const NodeIndex node = is_in_row ? list.last() : openNode(tree_, cursor_, NodeKind::Unread);
  if (!is_in_row) {
    tree_[node].first = first;
    tree_[node].flags |= Node::Faulty;
    list.add(node);
  }
  closeNode(tree_, cursor_, node);
}

NodeIndex ListParser::instruction() {
  switch (cursor_.kind()) {
    case TokenKind::If:
    case TokenKind::For:
    case TokenKind::While:
    case TokenKind::Test:
      return nestedInstruction();
    default:
      return instructions_.instruction();
  }
}

NodeIndex ListParser::nestedInstruction() {
  if (depth_ == kMostNesting) {
    cursor_.report(kinds::kNestedTooDeep, cursor_.index(), kMostNesting);
    const NodeIndex node = openNode(tree_, cursor_, NodeKind::Unread);
    while (!endsRoutine(cursor_)) cursor_.advance();
    closeNode(tree_, cursor_, node);
    markFaulty(node);
    is_abandoned_ = true;
    return node;
  }
  ++depth_;
  const TokenKind word = cursor_.kind();
  const NodeIndex node = word == TokenKind::If      ? ifInstruction()
                         : word == TokenKind::For   ? forInstruction()
                         : word == TokenKind::While ? whileInstruction()
                                                    : testInstruction();
  closeNode(tree_, cursor_, node);
  --depth_;
  return node;
}

void ListParser::markFaulty(NodeIndex node) {
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
}

bool ListParser::condition(ChildList& parts) {
  const NodeIndex condition = expressions_.expression();
  parts.add(condition);
  return condition != kNoNode;
}

/// Takes THEN, DO or ':'. At the end of a line a missing one is taken as written.
void ListParser::endHeader(NodeIndex node, bool is_read, TokenKind terminator) {
  if (!is_read) {
    recoverHeader(cursor_, terminator);
  } else if (!cursor_.take(terminator)) {
    const std::string_view word = toString(terminator);
    cursor_.reportExpected(terminator == TokenKind::Colon ? "':'" : word);
    if (!cursor_.startsLine()) recoverHeader(cursor_, terminator);
  }
  markFaulty(node);
}

void ListParser::endBlock(NodeIndex node, TokenKind opening, TokenKind closing) {
  if (cursor_.take(closing) || is_abandoned_) return;
  cursor_.reportHarmless(kinds::kNotClosed, tree_[node].first, toString(opening), toString(closing));
}

NodeIndex ListParser::ifInstruction() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::If);
  ChildList parts(tree_, node);
  cursor_.advance();
  const bool is_read = condition(parts);
  bool is_block = is_read && cursor_.take(TokenKind::Then);
  const bool is_compact = is_read && !is_block && InstructionParser::canBegin(cursor_.kind());
  if (is_compact) {
    compactIf(node, parts);
    return node;
  }
  if (!is_block) {
    if (is_read) cursor_.reportExpected("THEN");
    is_block =
        (is_read && cursor_.startsLine()) || recoverHeader(cursor_, TokenKind::Then) != TokenKind::Semicolon;
  }
  if (!is_block) tree_[node].kind = NodeKind::CompactIf;
  markFaulty(node);
  if (is_block) ifBlocks(node, parts);
  return node;
}

void ListParser::compactIf(NodeIndex node, ChildList& parts) {
  tree_[node].kind = NodeKind::CompactIf;
  markFaulty(node);
  parts.add(instruction());
}

void ListParser::ifBlocks(NodeIndex node, ChildList& parts) {
  ++ifs_;
  parts.add(list(false));
  bool has_else = false;
  while (cursor_.is(TokenKind::Elseif) || cursor_.is(TokenKind::Else)) {
    if (has_else) cursor_.report(kinds::kEndsNothing, cursor_.index(), toString(cursor_.kind()));
    has_else = has_else || cursor_.is(TokenKind::Else);
    parts.add(cursor_.is(TokenKind::Elseif) ? elseifBranch() : elseBranch());
  }
  --ifs_;
  endBlock(node, TokenKind::If, TokenKind::Endif);
}

NodeIndex ListParser::elseifBranch() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Elseif);
  ChildList parts(tree_, node);
  cursor_.advance();
  endHeader(node, condition(parts), TokenKind::Then);
  parts.add(list(false));
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ListParser::elseBranch() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Else);
  cursor_.advance();
  markFaulty(node);
  ChildList(tree_, node).add(list(false));
  closeNode(tree_, cursor_, node);
  return node;
}

NodeIndex ListParser::forInstruction() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::For);
  ChildList parts(tree_, node);
  cursor_.advance();
  endHeader(node, forHeader(node, parts), TokenKind::Do);
  ++fors_;
  parts.add(list(false));
  --fors_;
  endBlock(node, TokenKind::For, TokenKind::Endfor);
  return node;
}

/// From the counter to the step.
bool ListParser::forHeader(NodeIndex node, ChildList& parts) {
  tree_[node].name = takeName(cursor_, "the name of a counter");
  if (tree_[node].name == kNoToken) return false;
  for (const TokenKind word : {TokenKind::From, TokenKind::To}) {
    if (!cursor_.take(word)) {
      cursor_.reportExpected(toString(word));
      return false;
    }
    if (!condition(parts)) return false;
  }
  if (!cursor_.is(TokenKind::Step)) return true;
  const NodeIndex step = openNode(tree_, cursor_, NodeKind::Step);
  parts.add(step);
  cursor_.advance();
  ChildList value(tree_, step);
  const bool is_read = condition(value);
  closeNode(tree_, cursor_, step);
  return is_read;
}

NodeIndex ListParser::whileInstruction() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::While);
  ChildList parts(tree_, node);
  cursor_.advance();
  endHeader(node, condition(parts), TokenKind::Do);
  ++whiles_;
  parts.add(list(false));
  --whiles_;
  endBlock(node, TokenKind::While, TokenKind::Endwhile);
  return node;
}

NodeIndex ListParser::testInstruction() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Test);
  ChildList parts(tree_, node);
  cursor_.advance();
  if (!condition(parts)) recover(cursor_);
  markFaulty(node);
  ++tests_;
  bool has_default = false;
  const auto is_branch = [this] { return cursor_.is(TokenKind::Case) || cursor_.is(TokenKind::Default); };
  while (is_branch() || !endsList()) testItem(parts, has_default);
  --tests_;
  endBlock(node, TokenKind::Test, TokenKind::Endtest);
  return node;
}

void ListParser::testItem(ChildList& parts, bool& has_default) {
  const bool is_default = cursor_.is(TokenKind::Default);
  if (is_default || cursor_.is(TokenKind::Case)) {
    if (has_default) cursor_.reportHarmless(kinds::kAfterDefault, cursor_.index());
    has_default = has_default || is_default;
    parts.add(is_default ? defaultBranch() : caseBranch());
  } else if (cursor_.is(TokenKind::Placeholder)) {
    parts.add(instruction());
  } else {
    const TokenIndex first = cursor_.index();
    cursor_.reportExpected("CASE");
    recover(cursor_);
    if (cursor_.index() == first) cursor_.advance();
    static_cast<void>(cursor_.takeFaulty());
  }
}

NodeIndex ListParser::caseBranch() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Case);
  ChildList parts(tree_, node);
  cursor_.advance();
  endHeader(node, caseValues(parts), TokenKind::Colon);
  parts.add(list(false));
  closeNode(tree_, cursor_, node);
  return node;
}

bool ListParser::caseValues(ChildList& parts) {
  do {
    const NodeIndex value = expressions_.element();
    if (value == kNoNode) return false;
    parts.add(value);
  } while (cursor_.take(TokenKind::Comma));
  return true;
}

NodeIndex ListParser::defaultBranch() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::DefaultCase);
  cursor_.advance();
  endHeader(node, true, TokenKind::Colon);
  ChildList(tree_, node).add(list(false));
  closeNode(tree_, cursor_, node);
  return node;
}

}  // namespace cobot_command::rapid
