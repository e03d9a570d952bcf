// Records and aliases.
//
// They may refer to each other in any order, and in circles: each is resolved after those that it names, with
// a stack of its own, because a chain of aliases may be as long as a file.
#include "linking/linker.h"
#include "type_reference.h"

namespace cobot_command::rapid {

namespace {

class TypeDeclarations {
 public:
  TypeDeclarations(Draft& draft, LinkedFiles& files) : draft_(draft), files_(files) {}

  void run() {
    for (const LinkedModule& module : files_.modules) {
      for (const NodeIndex node : files_.file(module.file).tree().children(module.node)) {
        const SymbolIndex symbol = files_.file(module.file).at(node).symbol;
        if (symbol != kNoSymbol && draft_.symbol(symbol).kind == SymbolKind::Type) resolve(symbol);
      }
    }
  }

 private:
  enum class State : std::uint8_t { Open, Ready };
  struct Step {
    SymbolIndex symbol;
    NodeIndex next;  ///< the TypeName that is looked at next
  };

  /// The symbol of a TypeName in the module of `from`; kNoSymbol if it is no type.
  SymbolIndex symbolOf(const Symbol& from, NodeIndex type_name) {
    Names& names = files_.namesOf(from.file);
    names.enterModule(from.owner);
    return names.findType(files_.file(from.file)[type_name].name);
  }

  /// The parts of a type that name other types: components of a record, the alias itself.
  static NodeIndex firstPart(const FileDraft& file, NodeIndex type) {
    return file[type].kind == NodeKind::Alias ? type : file[type].child;
  }
  static NodeIndex nextPart(const FileDraft& file, NodeIndex type, NodeIndex part) {
    return part == type ? kNoNode : file[part].next;
  }

  void resolve(SymbolIndex symbol) {
    begin(symbol);
    while (!stack_.empty()) {
      Step& step = stack_.back();
      const Symbol& at = draft_.symbol(step.symbol);
      FileDraft& file = files_.file(at.file);
      if (step.next == kNoNode) {
        finish(step.symbol);
        stack_.pop_back();
        continue;
      }
      const NodeIndex part = step.next;
      step.next = nextPart(file, at.node, part);
      const NodeIndex name = file.tree().childOf(part, NodeKind::TypeName);
      if (name != kNoNode) begin(symbolOf(at, name));
    }
  }

  void begin(SymbolIndex symbol) {
    if (symbol == kNoSymbol || states_.count(symbol) > 0) return;
    const Symbol& at = draft_.symbol(symbol);
    if (at.file < files_.first || at.node == kNoNode) return;
    FileDraft& file = files_.file(at.file);
    states_[symbol] = State::Open;
    if (file[at.node].kind == NodeKind::Record) {
      draft_.symbol(symbol).type = draft_.parts.types.addRecord(at.name);
    }
    stack_.push_back({symbol, firstPart(file, at.node)});
  }

  void finish(SymbolIndex symbol) {
    const Symbol at = draft_.symbol(symbol);
    FileDraft& file = files_.file(at.file);
    if (file[at.node].kind == NodeKind::Alias) {
      draft_.symbol(symbol).type = partType(file, at, at.node, file[at.node].name);
    } else {
      record(file, at);
    }
    states_[symbol] = State::Ready;
  }

  void record(FileDraft& file, const Symbol& record) {
    std::vector<Component> components;
    std::map<std::string_view, NodeIndex> seen;
    for (const NodeIndex node : file.tree().children(record.node)) {
      const TokenIndex name = file[node].name;
      const NodeIndex type_name = file.tree().childOf(node, NodeKind::TypeName);
      if (file[node].kind != NodeKind::Component || !file.isName(name) || type_name == kNoNode) continue;
      const std::string_view folded = file.foldedAt(name);
      if (!seen.emplace(folded, node).second) {
        file.report(kinds::kComponentTwice, name, file.quotedAt(name));
        continue;
      }
      const TypeIndex type = partType(file, record, node, file[type_name].name);
      components.push_back({folded, type});
    }
    draft_.parts.types.setComponents(record.type, std::move(components));
    if (draft_.types()[record.type].cells > kMostCells) file.reportTooLarge(file[record.node].name);
  }

  /// `place`: where E316 is reported.
  TypeIndex partType(FileDraft& file, const Symbol& owner, NodeIndex part, TokenIndex place) {
    const NodeIndex node = file.tree().childOf(part, NodeKind::TypeName);
    if (node == kNoNode) return kNoType;
    Names& names = files_.namesOf(owner.file);
    names.enterModule(owner.owner);
    const SymbolIndex symbol = names.findType(file[node].name);
    const auto state = states_.find(symbol);
    if (state != states_.end() && state->second == State::Open) {
      if (!file[part].has(Node::Faulty)) file.report(kinds::kContainsItself, place, quoted(owner.name));
      return kNoType;
    }
    const TypeIndex type = typeNamed(file, names, node);
    if (type != kSwitch) return type;
    file.report(kinds::kSwitchParameter, file[node].name);
    return kNoType;
  }

  Draft& draft_;
  LinkedFiles& files_;
  std::map<SymbolIndex, State> states_;
  std::vector<Step> stack_;
};

}  // namespace

void declareTypes(Draft& draft, LinkedFiles& files) {
  TypeDeclarations(draft, files).run();
}

}  // namespace cobot_command::rapid
