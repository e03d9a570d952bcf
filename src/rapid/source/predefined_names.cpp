#include "cobot_command/rapid/source/predefined_names.h"

namespace cobot_command::rapid {

namespace {

DeclaredName foundIn(const std::unordered_map<std::string, DeclaredName>& declarations,
                     std::string_view name) {
  const auto found = declarations.find(std::string(name));
  return found == declarations.end() ? DeclaredName{} : found->second;
}

}  // namespace

PredefinedNames::PredefinedNames(const std::vector<const Source*>& sources,
                                 const std::vector<std::string_view>& others) {
  for (const Source* source : sources) {
    const Tree& tree = source->tree();
    for (const NodeIndex module : tree.children(Tree::kRoot)) {
      for (const NodeIndex node : tree.children(module)) {
        const std::string_view name = source->nameOf(node);
        if (name.empty()) continue;
        const bool is_type = tree[node].kind == NodeKind::Record || tree[node].kind == NodeKind::Alias;
        const DeclaredName declared{source->textOf(tree[node].name), source, node};
        (is_type ? types_ : others_).emplace(name, declared);
      }
    }
  }
  for (const std::string_view name : others) {
    const DeclaredName known{name, nullptr, kNoNode};
    types_.emplace(folded(name), known);
    others_.emplace(folded(name), known);
  }
}

DeclaredName PredefinedNames::find(std::string_view folded) const {
  return foundIn(others_, folded);
}

DeclaredName PredefinedNames::findType(std::string_view folded) const {
  return foundIn(types_, folded);
}

}  // namespace cobot_command::rapid
