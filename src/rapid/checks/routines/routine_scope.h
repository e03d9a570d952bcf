// The names of a routine: parameters, data, labels, loop counters.
#pragma once

#include <vector>

#include "draft.h"
#include "names.h"

namespace cobot_command::rapid {

class RoutineScope {
 public:
  RoutineScope(FileDraft& file, Names& names) : file_(file), names_(names), draft_(file.draft()) {}

  /// Declares all names of a routine, except for loop counters. Reports E301, E305, E318, W319.
  void enter(SymbolIndex routine);

  /// Reports E601, E602 of a Goto and binds it. `blocks`: the lists around it, the outer one first.
  void bindGoto(NodeIndex node, const std::vector<NodeIndex>& blocks);

 private:
  struct Label {
    SymbolIndex symbol = kNoSymbol;
    NodeIndex block = kNoNode;  ///< where it is
  };

  void parameters();
  void instructions(NodeIndex node, NodeIndex block);
  void data(NodeIndex node);
  void label(NodeIndex node, NodeIndex block);
  void declare(NodeIndex node, SymbolIndex symbol);
  [[nodiscard]] std::string nearestLabel(TokenIndex name) const;

  FileDraft& file_;
  Names& names_;
  Draft& draft_;
  SymbolIndex routine_ = kNoSymbol;
  std::map<NameIndex, Label> labels_;
};

}  // namespace cobot_command::rapid
