// Names that are declared in one place: a file, a module, a routine.
#pragma once

#include <vector>

#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

class Scope {
 public:
  /// `names`: number of names of the source.
  explicit Scope(std::size_t names) : nodes_(names, kNoNode) {}

  /// The first declaration of a name counts.
  void declare(NameIndex name, NodeIndex node) {
    if (nodes_[name] == kNoNode) replace(name, node);
  }
  /// Returns what it replaces, so that it can be restored.
  NodeIndex replace(NameIndex name, NodeIndex node) {
    const NodeIndex before = nodes_[name];
    nodes_[name] = node;
    declared_.push_back(name);
    return before;
  }
  [[nodiscard]] NodeIndex find(NameIndex name) const { return nodes_[name]; }
  void clear() {
    for (const NameIndex name : declared_) nodes_[name] = kNoNode;
    declared_.clear();
  }

 private:
  std::vector<NodeIndex> nodes_;  ///< by name
  std::vector<NameIndex> declared_;
};

}  // namespace cobot_command::rapid
