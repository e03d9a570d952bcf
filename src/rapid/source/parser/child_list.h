// Adds nodes to a tree, and children to a node.
#pragma once

#include "parser/cursor.h"

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

/// The children of a node, which are added one after the other.
class ChildList {
 public:
  ChildList(Tree& tree, NodeIndex parent) : tree_(tree), parent_(parent) {}

  /// kNoNode adds nothing.
  void add(NodeIndex child) {
    if (child == kNoNode) return;
    (last_ == kNoNode ? tree_[parent_].child : tree_[last_].next) = child;
    last_ = child;
  }
  /// kNoNode if there is none.
  [[nodiscard]] NodeIndex last() const { return last_; }

 private:
  Tree& tree_;
  NodeIndex parent_;
  NodeIndex last_ = kNoNode;
};

/// A node that begins at the token here. close() sets its end.
[[nodiscard]] inline NodeIndex openNode(Tree& tree, const Cursor& cursor, NodeKind kind) {
  Node node;
  node.kind = kind;
  node.word = cursor.kind();
  node.first = cursor.index();
  node.last = cursor.index();
  return tree.add(node);
}

/// The node ends with the token before.
inline void closeNode(Tree& tree, const Cursor& cursor, NodeIndex node) {
  tree[node].last = cursor.previous();
}

/// A node of the one token here, which is its name.
[[nodiscard]] inline NodeIndex takeLeaf(Tree& tree, Cursor& cursor, NodeKind kind) {
  const NodeIndex leaf = openNode(tree, cursor, kind);
  tree[leaf].name = cursor.index();
  cursor.advance();
  return leaf;
}

}  // namespace cobot_command::rapid
