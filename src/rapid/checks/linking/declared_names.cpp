// Names of modules, and what they declare.
#include <utility>

#include "linking/linker.h"
#include <fmt/format.h>

namespace cobot_command::rapid {

namespace {

constexpr std::string_view kMainName = "main";

SymbolKind kindOf(const Node& node) {
  switch (node.kind) {
    case NodeKind::Record:
    case NodeKind::Alias:
      return SymbolKind::Type;
    case NodeKind::Data:
      return SymbolKind::Data;
    default:
      return node.word == TokenKind::Proc   ? SymbolKind::Procedure
             : node.word == TokenKind::Func ? SymbolKind::Function
                                            : SymbolKind::Trap;
  }
}

bool isDeclaration(NodeKind kind) {
  return kind == NodeKind::Record || kind == NodeKind::Alias || kind == NodeKind::Data ||
         kind == NodeKind::Routine;
}

class NameDeclarations {
 public:
  NameDeclarations(Draft& draft, LinkedFiles& files) : draft_(draft), files_(files) {}

  void run() {
    for (FileDraft& file : files_.files) {
      for (const NodeIndex node : file.tree().children(Tree::kRoot)) {
        if (file[node].kind == NodeKind::Module) module(file, node);
      }
    }
    for (const LinkedModule& module : files_.modules) moduleName(module);
    if (!draft_.is_library) requireMain();
  }

 private:
  void module(FileDraft& file, NodeIndex node) {
    if (files_.modules.size() == kMostModules) {
      if (!std::exchange(has_too_many_, true)) {
        file.report(kinds::kManyModules, file[node].first, kMostModules);
      }
      return;
    }
    const SymbolIndex symbol = file.declare(file.symbolOf(SymbolKind::Module, node, kNoSymbol));
    LinkedModule linked{symbol, file.file(), node, false};
    for (const NodeIndex child : file.tree().children(node)) {
      linked.is_system = linked.is_system || file[child].word == TokenKind::Sysmodule;
      if (isDeclaration(file[child].kind)) declaration(file, child, linked.symbol);
    }
    files_.modules.push_back(linked);
  }

  void declaration(FileDraft& file, NodeIndex node, SymbolIndex module) {
    const Node& at = file[node];
    if (!file.isName(at.name)) return;
    Symbol symbol = file.symbolOf(kindOf(at), node, module);
    symbol.word = at.kind == NodeKind::Data ? at.word : TokenKind::End;
    symbol.flags = static_cast<std::uint8_t>((at.has(Node::Local) ? Symbol::Local : 0) |
                                             (at.has(Node::Faulty) ? Symbol::Faulty : 0) |
                                             (symbol.word == TokenKind::Const ? Symbol::ReadOnly : 0));
    const SymbolIndex index = file.declare(symbol);
    const bool is_main = symbol.kind == SymbolKind::Procedure && file.foldedAt(at.name) == kMainName;
    if (is_main) return main(file, index, module);
    enter(file, index, module);
  }

  /// Into the names of its module and, if it is global, of the program.
  void enter(FileDraft& file, SymbolIndex index, SymbolIndex module) {
    const Symbol& symbol = draft_.symbol(index);
    const TokenIndex name = file[symbol.node].name;
    const std::string_view folded = file.foldedAt(name);
    const bool is_type = symbol.kind == SymbolKind::Type;
    NameSpace& space = is_type ? draft_.type_names : draft_.parts.names;
    // A type and a routine of one module, or of the program, must not have one name.
    const NameSpace& other = is_type ? draft_.parts.names : draft_.type_names;
    SymbolIndex first = space.modules[module].emplace(folded, index).first->second;
    if (first == index) first = other.inModule(module, folded);
    const bool is_global = !symbol.has(Symbol::Local);
    if (is_global && (first == index || first == kNoSymbol)) {
      first = space.globals.emplace(folded, index).first->second;
      if (first == index) first = foundIn(other.globals, folded);
    }
    if (first == index || first == kNoSymbol) return;
    file.report(kinds::kDeclaredAlready, name, file.quotedAt(name), placeOf(first, file.file()));
  }

  void main(FileDraft& file, SymbolIndex index, SymbolIndex module) {
    const NodeIndex node = draft_.symbol(index).node;
    const TokenIndex name = file[node].name;
    const NodeIndex parameters = file.tree().childOf(node, NodeKind::Parameters);
    const bool has_parameters = parameters != kNoNode && file[parameters].child != kNoNode;
    if (file[node].has(Node::Local) || has_parameters) file.report(kinds::kMainForm, name);
    if (draft_.parts.main != kNoSymbol) return file.report(kinds::kMain, name, "a second");
    draft_.parts.main = index;
    enter(file, index, module);
  }

  void moduleName(const LinkedModule& module) {
    FileDraft& file = files_.file(module.file);
    const TokenIndex name = file[module.node].name;
    if (!file.isName(name)) return;
    const std::string_view folded = file.foldedAt(name);
    const bool is_new = draft_.parts.names.globals.emplace(folded, module.symbol).second;
    if (!is_new || draft_.type_names.globals.count(folded) > 0) {
      file.report(kinds::kModuleName, name, file.quotedAt(name));
    }
  }

  void requireMain() {
    if (draft_.parts.main != kNoSymbol || files_.modules.empty()) return;
    // An error of reading may have hidden it.
    for (const FileDraft& file : files_.files) {
      if (file.source().isBroken() && file.source().names().find(kMainName)) return;
    }
    const LinkedModule& first = files_.modules.front();
    files_.file(first.file).report(kinds::kMain, files_.file(first.file)[first.node].first, "no");
  }

  [[nodiscard]] std::string placeOf(SymbolIndex symbol, FileIndex from) const {
    const Symbol& at = draft_.symbol(symbol);
    const Source& source = *draft_.parts.files[at.file].source;
    const Place place = source.placeOf(source.tokens()[source.tree()[at.node].name].begin);
    const std::string text = fmt::format("{}:{}", place.line, place.column);
    return at.file == from ? text : quoted(draft_.file_names[at.file]) + ":" + text;
  }

  Draft& draft_;
  LinkedFiles& files_;
  bool has_too_many_ = false;
};

}  // namespace

void declareNames(Draft& draft, LinkedFiles& files) {
  NameDeclarations(draft, files).run();
}

}  // namespace cobot_command::rapid
