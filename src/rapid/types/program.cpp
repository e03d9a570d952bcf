#include "cobot_command/rapid/types/program.h"

namespace cobot_command::rapid {

SymbolIndex foundIn(const NameMap& names, std::string_view folded) {
  const auto found = names.find(folded);
  return found == names.end() ? kNoSymbol : found->second;
}

SymbolIndex NameSpace::inModule(SymbolIndex module, std::string_view folded) const {
  const auto own = modules.find(module);
  return own == modules.end() ? kNoSymbol : foundIn(own->second, folded);
}

SymbolIndex NameSpace::find(SymbolIndex module, std::string_view folded) const {
  const SymbolIndex own = inModule(module, folded);
  if (own != kNoSymbol) return own;
  const SymbolIndex global = foundIn(globals, folded);
  return global != kNoSymbol ? global : foundIn(predefined, folded);
}

std::vector<NodeIndex> Program::argumentsOf(FileIndex file, NodeIndex call) const {
  const Symbol& routine = symbol(at(file, call).symbol);
  const Tree& tree = source(file).tree();
  std::vector<NodeIndex> arguments(routine.parameters, kNoNode);
  std::uint32_t position = 0;
  const auto is_optional = [&] { return symbol(routine.first_parameter + position).has(Symbol::Optional); };
  for (const NodeIndex child : tree.children(call)) {
    if (tree[child].kind == NodeKind::Argument) {
      const SymbolIndex parameter = at(file, child).symbol;
      if (parameter == kNoSymbol) continue;
      arguments[parameter - routine.first_parameter] = child;
      if (tree[child].has(Node::Optional)) continue;
      position = parameter - routine.first_parameter + 1;
    } else {
      while (position < routine.parameters && is_optional()) ++position;
      if (position < routine.parameters) arguments[position++] = child;
    }
  }
  return arguments;
}

}  // namespace cobot_command::rapid
