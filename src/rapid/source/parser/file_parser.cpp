#include "parser/file_parser.h"

#include <algorithm>
#include <array>

#include "parser/recovery.h"

#include "cobot_command/rapid/source/name_table.h"

namespace cobot_command::rapid {

namespace {

constexpr std::array<TokenKind, 5> kAttributes{TokenKind::Sysmodule, TokenKind::Noview, TokenKind::Nostepin,
                                               TokenKind::Viewonly, TokenKind::Readonly};

/// NOVIEW is alone or after SYSMODULE; otherwise the order is that of kAttributes. `seen`: bits of these.
bool mayFollow(std::size_t attribute, unsigned seen) {
  constexpr unsigned kSysmodule = 1U;
  constexpr unsigned kNoview = 2U;
  const bool is_in_order = seen < (1U << attribute);
  const bool is_noview = kAttributes.at(attribute) == TokenKind::Noview;
  return is_in_order && (seen & kNoview) == 0 && (!is_noview || seen <= kSysmodule);
}

}  // namespace

void FileParser::file() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::File);
  ChildList children(tree_, node);
  while (!cursor_.is(TokenKind::End)) {
    if (cursor_.is(TokenKind::HeaderMark)) {
      children.add(header());
    } else if (cursor_.is(TokenKind::Module)) {
      children.add(module());
    } else {
      outside();
    }
  }
  closeNode(tree_, cursor_, node);
}

NodeIndex FileParser::header() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Header);
  const TokenIndex mark = cursor_.index();
  cursor_.advance();
  if (!headerWords()) {
    cursor_.report(kinds::kHeader, mark);
    while (!cursor_.is(TokenKind::End) && !cursor_.is(TokenKind::Module) &&
           !cursor_.take(TokenKind::HeaderMark)) {
      cursor_.advance();
    }
  }
  closeNode(tree_, cursor_, node);
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
  return node;
}

/// VERSION:1 LANGUAGE:ENGLISH %%%
bool FileParser::headerWords() {
  const auto take = [this](std::initializer_list<std::string_view> words) {
    const std::string word = folded(cursor_.text());
    if (std::find(words.begin(), words.end(), word) == words.end()) return false;
    cursor_.advance();
    return true;
  };
  return take({"version"}) && take({":"}) && take({"1"}) && take({"language"}) && take({":"}) &&
         take({"english", "german", "french"}) && cursor_.take(TokenKind::HeaderMark);
}

void FileParser::outside() {
  cursor_.report(kinds::kOutsideModule, cursor_.index(), quoted(cursor_.text()));
  while (!cursor_.is(TokenKind::End) && !cursor_.is(TokenKind::Module) &&
         !cursor_.is(TokenKind::HeaderMark)) {
    cursor_.advance();
  }
  static_cast<void>(cursor_.takeFaulty());
}

NodeIndex FileParser::module() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Module);
  ChildList children(tree_, node);
  const TokenIndex word = cursor_.index();
  cursor_.advance();
  tree_[node].name = takeName(cursor_, "the name of a module");
  if (cursor_.is(TokenKind::LeftParenthesis)) attributes(children);
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
  items(children);
  if (!cursor_.take(TokenKind::Endmodule)) {
    cursor_.reportHarmless(kinds::kNotClosed, word, "MODULE", "ENDMODULE");
  }
  closeNode(tree_, cursor_, node);
  return node;
}

void FileParser::attributes(ChildList& module) {
  cursor_.advance();
  unsigned seen = 0;
  do {
    if (!attribute(module, seen)) return skipLine(cursor_);
  } while (cursor_.take(TokenKind::Comma));
  if (cursor_.take(TokenKind::RightParenthesis)) return;
  cursor_.reportExpected("',' or ')'");
  skipLine(cursor_);
}

/// False if nothing like an attribute is here.
bool FileParser::attribute(ChildList& module, unsigned& seen) {
  const auto* const found = std::find(kAttributes.begin(), kAttributes.end(), cursor_.kind());
  const auto number = static_cast<std::size_t>(found - kAttributes.begin());
  const bool is_one = found != kAttributes.end();
  if (!is_one && !cursor_.is(TokenKind::Name) && !isReservedWord(cursor_.kind())) {
    const bool is_missing = cursor_.is(TokenKind::Comma) || cursor_.is(TokenKind::RightParenthesis);
    is_missing ? cursor_.report(kinds::kSomethingMissing, cursor_.index())
               : cursor_.reportExpected("an attribute");
    return false;
  }
  if (!is_one || !mayFollow(number, seen)) {
    cursor_.report(kinds::kNoAttribute, cursor_.index(), quoted(cursor_.text()));
  }
  if (is_one) seen |= 1U << number;
  module.add(takeLeaf(tree_, cursor_, NodeKind::Attribute));
  return true;
}

void FileParser::items(ChildList& module) {
  bool has_routine = false;
  while (!cursor_.is(TokenKind::End) && !cursor_.is(TokenKind::Endmodule) && !cursor_.is(TokenKind::Module)) {
    const TokenIndex first = cursor_.index();
    item(module, has_routine);
    if (cursor_.index() == first) cursor_.advance();
    static_cast<void>(cursor_.takeFaulty());
  }
}

void FileParser::item(ChildList& module, bool& has_routine) {
  Prefix prefix{cursor_.index()};
  if (cursor_.take(TokenKind::Local)) prefix.flags = Node::Local;
  switch (cursor_.kind()) {
    case TokenKind::Proc:
    case TokenKind::Func:
    case TokenKind::Trap:
      has_routine = true;
      return module.add(routine(prefix));
    case TokenKind::Placeholder:
      cursor_.report(kinds::kPlaceholder, cursor_.index());
      module.add(takeLeaf(tree_, cursor_, NodeKind::Placeholder));
      cursor_.take(TokenKind::Semicolon);
      return;
    default:
      return declarations_.isData() || declarations_.isType() ? declaration(module, prefix, has_routine)
                                                              : stray();
  }
}

void FileParser::declaration(ChildList& module, Prefix prefix, bool is_late) {
  if (is_late) cursor_.reportHarmless(kinds::kLateDeclaration, cursor_.index());
  module.add(declarations_.isData() ? declarations_.data(prefix) : declarations_.type(prefix));
}

/// What is neither a declaration nor the end of the module.
void FileParser::stray() {
  const bool is_instruction = InstructionParser::canBegin(cursor_.kind());
  if (isAnchor(cursor_.kind()) && !is_instruction) {
    cursor_.report(kinds::kEndsNothing, cursor_.index(), toString(cursor_.kind()));
    cursor_.advance();
    return skipLine(cursor_);
  }
  cursor_.reportExpected("a declaration");
  // Also over a word at the start of this line, such as IF.
  cursor_.advance();
  recover(cursor_);
}

NodeIndex FileParser::routine(Prefix prefix) {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Routine);
  tree_[node].first = prefix.first;
  tree_[node].flags = prefix.flags;
  const TokenIndex word = cursor_.index();
  const TokenKind kind = cursor_.kind();
  ChildList parts(tree_, node);
  cursor_.advance();
  if (!routineHeader(node, parts)) skipLine(cursor_);
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
  if (has_bodies_) {
    parts.add(lists_.body());
    handlers(parts, kind);
    endRoutine(word, kind == TokenKind::Proc   ? TokenKind::Endproc
                     : kind == TokenKind::Func ? TokenKind::Endfunc
                                               : TokenKind::Endtrap);
  }
  closeNode(tree_, cursor_, node);
  return node;
}

/// Type, name and parameters. False after an error that is not the name.
bool FileParser::routineHeader(NodeIndex node, ChildList& parts) {
  const TokenKind kind = tree_[node].word;
  if (kind == TokenKind::Func) {
    const NodeIndex type = declarations_.typeName();
    parts.add(type);
    if (type == kNoNode) return false;
  }
  tree_[node].name = takeName(cursor_, "the name of a routine");
  const bool has_name = tree_[node].name != kNoToken;
  if (kind == TokenKind::Trap || (!has_name && !cursor_.is(TokenKind::LeftParenthesis))) return has_name;
  return declarations_.parameters(parts);
}

void FileParser::handlers(ChildList& parts, TokenKind routine) {
  // In the order in which they must be; their values are those of TokenKind.
  TokenKind last = TokenKind::Alias;
  while (lists_.isHandler()) {
    const TokenIndex word = cursor_.index();
    const TokenKind kind = cursor_.is(TokenKind::Name) ? TokenKind::Undo : cursor_.kind();
    const bool is_of_proc = routine == TokenKind::Proc || kind != TokenKind::Backward;
    if (!is_of_proc) {
      cursor_.report(kinds::kBackwardOfProc, word);
    } else if (kind <= last) {
      cursor_.report(kinds::kHandlerOrder, word, toString(kind));
    }
    if (cursor_.is(TokenKind::Name)) cursor_.report(kinds::kNotInS4c, word, "UNDO");
    last = std::max(last, kind);
    parts.add(handler());
  }
}

NodeIndex FileParser::handler() {
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::Handler);
  const TokenIndex word = cursor_.index();
  const bool is_error = cursor_.is(TokenKind::Error);
  if (cursor_.is(TokenKind::Name)) tree_[node].word = TokenKind::Undo;
  ChildList parts(tree_, node);
  cursor_.advance();
  if (is_error && cursor_.is(TokenKind::LeftParenthesis)) errorNumbers(parts, word);
  if (cursor_.takeFaulty()) tree_[node].flags |= Node::Faulty;
  parts.add(lists_.handler());
  closeNode(tree_, cursor_, node);
  return node;
}

void FileParser::errorNumbers(ChildList& parts, TokenIndex word) {
  if (cursor_.dialect() == Dialect::S4c) cursor_.report(kinds::kNotInS4c, word, "ERROR (n,m)");
  const NodeIndex node = openNode(tree_, cursor_, NodeKind::ErrorNumbers);
  parts.add(node);
  cursor_.advance();
  if (!expressions_.elements(node, TokenKind::RightParenthesis)) skipLine(cursor_);
}

void FileParser::endRoutine(TokenIndex opening, TokenKind closing) {
  const bool is_abandoned = lists_.takeAbandoned();
  if (cursor_.take(closing)) return;
  const bool is_mistaken =
      cursor_.is(TokenKind::Endproc) || cursor_.is(TokenKind::Endfunc) || cursor_.is(TokenKind::Endtrap);
  if (is_mistaken) {
    cursor_.reportExpected(toString(closing));
    cursor_.advance();
  } else if (!is_abandoned) {
    cursor_.reportHarmless(kinds::kNotClosed, opening, toString(cursor_.kindAt(opening)), toString(closing));
  }
}

}  // namespace cobot_command::rapid
