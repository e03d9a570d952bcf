#include "printer/layout.h"

#include <utility>

namespace cobot_command::rapid {

namespace {

using Kind = LineStart::Kind;
using Mark = MarkedToken::Mark;

class Walk {
 public:
  explicit Walk(const Source& source) : source_(source), tree_(source.tree()) {}

  Layout run() {
    for (const NodeIndex child : tree_.children(Tree::kRoot)) {
      tree_[child].kind == NodeKind::Header ? header(child) : module(child);
    }
    line(static_cast<TokenIndex>(source_.tokens().size() - 1), 0);
    return std::move(layout_);
  }

 private:
  void line(TokenIndex token, int level, Kind kind = Kind::Plain) {
    layout_.lines.push_back({token, level, kind});
  }
  void mark(TokenIndex token, Mark mark) { layout_.marked.push_back({token, mark}); }

  /// Four lines.
  void header(NodeIndex node) {
    line(tree_[node].first, 0);
    int names = 0;
    for (TokenIndex token = tree_[node].first; token < tree_[node].last; ++token) {
      if (source_.tokens()[token].kind != TokenKind::Name) continue;
      const bool is_value = ++names > 2;  // ENGLISH, after VERSION and LANGUAGE
      if (!is_value) line(token, 1);
    }
    line(tree_[node].last, 0);
  }

  void module(NodeIndex node) {
    line(tree_[node].first, 0);
    for (const NodeIndex child : tree_.children(node)) {
      if (tree_[child].kind == NodeKind::Routine) {
        routine(child);
      } else if (tree_[child].kind != NodeKind::Attribute) {
        instruction(child, 1);
      }
    }
    line(tree_[node].last, 0, Kind::Closing);
  }

  void routine(NodeIndex node) {
    line(tree_[node].first, 1, Kind::Routine);
    for (const NodeIndex child : tree_.children(node)) {
      if (tree_[child].kind == NodeKind::List) list(child, 2);
      if (tree_[child].kind == NodeKind::Handler) branch(child, 1);
    }
    line(tree_[node].last, 1, Kind::Closing);
  }

  void list(NodeIndex node, int level) {
    for (const NodeIndex child : tree_.children(node)) instruction(child, level);
  }

  /// What begins with a word on the level of its block, and has a list: ELSE, CASE, ERROR.
  void branch(NodeIndex node, int level) {
    line(tree_[node].first, level, Kind::Closing);
    list(tree_.childOf(node, NodeKind::List), level + 1);
  }

  /// Also a declaration. On a line of its own.
  void instruction(NodeIndex node, int level) {
    const bool is_label = tree_[node].kind == NodeKind::Label;
    line(tree_[node].first, is_label ? level - 1 : level, is_label ? Kind::Closing : Kind::Plain);
    parts(node, level);
  }

  void parts(NodeIndex node, int level) {
    switch (tree_[node].kind) {
      case NodeKind::Call:
        return mark(tree_[node].name, Mark::Procedure);
      case NodeKind::LateCall:
        return lateCall(node);
      case NodeKind::CompactIf:
        return parts(compactInstruction(node), level);
      case NodeKind::If:
      case NodeKind::For:
      case NodeKind::While:
      case NodeKind::Test:
        return block(node, level);
      case NodeKind::Record:
        return record(node, level);
      default:
        return;
    }
  }

  [[nodiscard]] NodeIndex compactInstruction(NodeIndex node) const {
    return tree_[tree_[node].child].next;  // after the condition
  }

  void lateCall(NodeIndex node) {
    mark(tree_[node].first, Mark::OpeningPercent);
    TokenIndex closing = tree_[tree_[node].child].last + 1;
    while (source_.tokens()[closing].kind != TokenKind::Percent) ++closing;
    mark(closing, Mark::ClosingPercent);
  }

  void block(NodeIndex node, int level) {
    for (const NodeIndex child : tree_.children(node)) {
      switch (tree_[child].kind) {
        case NodeKind::List:
          list(child, level + 1);
          break;
        case NodeKind::Elseif:
        case NodeKind::Else:
        case NodeKind::Case:
        case NodeKind::DefaultCase:
          branch(child, level);
          break;
        case NodeKind::Placeholder:
          // The place of a branch; in a FOR or an IF an expression.
          if (tree_[node].kind == NodeKind::Test && child != tree_[node].child) {
            line(tree_[child].first, level, Kind::Closing);
          }
          break;
        default:
          break;
      }
    }
    line(tree_[node].last, level, Kind::Closing);
  }

  void record(NodeIndex node, int level) {
    for (const NodeIndex child : tree_.children(node)) line(tree_[child].first, level + 1);
    TokenIndex end = tree_[node].last;
    while (source_.tokens()[end].kind != TokenKind::Endrecord) --end;
    line(end, level, Kind::Closing);
  }

  const Source& source_;
  const Tree& tree_;
  Layout layout_;
};

}  // namespace

Layout layoutOf(const Source& source) {
  return Walk(source).run();
}

}  // namespace cobot_command::rapid
