// Data of modules, each after the constants that it names.
//
// They may name each other in any order, also of other modules. A chain of constants may be as long as a
// file, so the order is found with a stack of its own.
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "data_declaration.h"
#include "linking/linker.h"

namespace cobot_command::rapid {

namespace {

class ModuleData {
 public:
  ModuleData(Draft& draft, LinkedFiles& files) : draft_(draft), files_(files) {
    for (const LinkedModule& module : files_.modules) is_system_[module.symbol] = module.is_system;
  }

  void run() {
    for (const LinkedModule& module : files_.modules) {
      for (const NodeIndex node : files_.file(module.file).tree().children(module.node)) {
        const SymbolIndex symbol = files_.file(module.file).at(node).symbol;
        if (symbol != kNoSymbol && draft_.symbol(symbol).kind == SymbolKind::Data) declare(symbol);
      }
    }
  }

 private:
  struct Step {
    SymbolIndex symbol;
    std::vector<SymbolIndex> open;  ///< constants that its declaration names, the first one last
  };

  void declare(SymbolIndex symbol) {
    begin(symbol);
    while (!stack_.empty()) {
      Step& step = stack_.back();
      if (!step.open.empty()) {
        const SymbolIndex next = step.open.back();
        step.open.pop_back();
        begin(next);
        continue;
      }
      finish(step.symbol);
      stack_.pop_back();
    }
  }

  void begin(SymbolIndex symbol) {
    if (draft_.ready[symbol] != 0 || !begun_.insert(symbol).second) return;
    Step step{symbol, {}};
    const Symbol& at = draft_.symbol(symbol);
    FileDraft& file = files_.file(at.file);
    enter(at);
    collect(file, at.node, step.open);
    stack_.push_back(std::move(step));
  }

  void enter(const Symbol& symbol) { files_.namesOf(symbol.file).enterModule(symbol.owner); }

  /// The depth of a tree is bounded.
  void collect(FileDraft& file, NodeIndex node, std::vector<SymbolIndex>& named) {
    for (const NodeIndex child : file.tree().children(node)) {
      if (file[child].kind == NodeKind::Number) continue;
      collect(file, child, named);
      if (file[child].kind != NodeKind::Reference) continue;
      const SymbolIndex found = files_.namesOf(file.file()).find(file[child].name);
      if (found == kNoSymbol || draft_.symbol(found).file < files_.first) continue;
      const Symbol& symbol = draft_.symbol(found);
      const bool is_constant = symbol.kind == SymbolKind::Data && symbol.word == TokenKind::Const;
      if (is_constant && draft_.ready[found] == 0) named.push_back(found);
    }
  }

  void finish(SymbolIndex symbol) {
    const Symbol& at = draft_.symbol(symbol);
    enter(at);
    ExpressionCheck expressions(files_.file(at.file), files_.namesOf(at.file));
    DataDeclaration(expressions).declare(symbol, is_system_[at.owner]);
  }

  Draft& draft_;
  LinkedFiles& files_;
  std::map<SymbolIndex, bool> is_system_;
  std::set<SymbolIndex> begun_;
  std::vector<Step> stack_;
};

}  // namespace

void declareModuleData(Draft& draft, LinkedFiles& files) {
  ModuleData(draft, files).run();
}

}  // namespace cobot_command::rapid
