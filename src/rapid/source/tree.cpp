#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

NodeIndex Tree::childOf(NodeIndex node, NodeKind kind) const {
  for (const NodeIndex child : children(node)) {
    if (nodes_[child].kind == kind) return child;
  }
  return kNoNode;
}

NodeIndex Tree::expressionOf(NodeIndex node) const {
  for (const NodeIndex child : children(node)) {
    if (isExpression(nodes_[child].kind)) return child;
  }
  return kNoNode;
}

}  // namespace cobot_command::rapid
