// Results and parameters of routines.
#include "linking/linker.h"
#include "type_reference.h"

#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {

namespace {

class RoutineDeclaration {
 public:
  RoutineDeclaration(FileDraft& file, Names& names, SymbolIndex routine)
      : file_(file), names_(names), draft_(file.draft()), routine_(routine) {}

  void run() {
    const NodeIndex node = draft_.symbol(routine_).node;
    if (file_[node].word == TokenKind::Func) result(node);
    const NodeIndex parameters = file_.tree().childOf(node, NodeKind::Parameters);
    draft_.symbol(routine_).first_parameter = static_cast<SymbolIndex>(draft_.parts.symbols.size());
    if (parameters == kNoNode) return;
    for (const NodeIndex child : file_.tree().children(parameters)) {
      if (file_[child].kind == NodeKind::Parameter) parameter(child);
    }
  }

 private:
  void result(NodeIndex routine) {
    const NodeIndex node = file_.tree().childOf(routine, NodeKind::TypeName);
    const TypeIndex type = node == kNoNode ? kNoType : typeNamed(file_, names_, node);
    const Type& at = draft_.types()[type];
    draft_.symbol(routine_).type = type;
    const bool can_be_returned = at.has_values && at.kind != TypeKind::SemiValue;
    if (!can_be_returned) file_.report(kinds::kResultType, file_[node].name, quoted(at.name));
  }

  void parameter(NodeIndex node) {
    const Node& at = file_[node];
    Symbol symbol = file_.symbolOf(SymbolKind::Parameter, node, routine_);
    symbol.flags = static_cast<std::uint8_t>((at.has(Node::Optional) ? Symbol::Optional : 0) |
                                             (at.has(Node::Excludes) ? Symbol::Excludes : 0));
    symbol.word = at.word;
    symbol.index = draft_.symbol(routine_).parameters++;
    symbol.type = withDimensions(typeOfParameter(file_, names_, node), node);
    static_cast<void>(file_.declare(symbol));
  }

  TypeIndex withDimensions(TypeIndex element, NodeIndex parameter) {
    const NodeIndex node = file_.tree().childOf(parameter, NodeKind::Dimensions);
    if (node == kNoNode) return element;
    int dimensions = 0;
    for (const NodeIndex star : file_.tree().children(node)) {
      if (++dimensions == kMostDimensions + 1) file_.reportNode(kinds::kThreeDimensions, star);
    }
    if (element == kNoType || dimensions > kMostDimensions) return kNoType;
    return draft_.parts.types.arrayOf(element, static_cast<std::uint8_t>(dimensions), {});
  }

  FileDraft& file_;
  Names& names_;
  Draft& draft_;
  SymbolIndex routine_;
};

}  // namespace

void declareRoutines(Draft& draft, LinkedFiles& files) {
  for (const LinkedModule& module : files.modules) {
    FileDraft& file = files.file(module.file);
    Names& names = files.namesOf(module.file);
    names.enterModule(module.symbol);
    for (const NodeIndex node : file.tree().children(module.node)) {
      const SymbolIndex symbol = file.at(node).symbol;
      if (symbol == kNoSymbol || !draft.symbol(symbol).isRoutine()) continue;
      RoutineDeclaration(file, names, symbol).run();
    }
  }
}

}  // namespace cobot_command::rapid
