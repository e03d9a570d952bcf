// Calls of functions in expressions.
#include "expressions/call_check.h"
#include "type_reference.h"

namespace cobot_command::rapid {

Typed ExpressionCheck::function(NodeIndex node) {
  const TokenIndex name = file_[node].name;
  const SymbolIndex found = bind(name, kinds::kNotDeclared, Meant::Value);
  if (found == kNoSymbol) return {};
  const Symbol symbol = draft_.symbol(found);
  if (symbol.kind != SymbolKind::Function) {
    reportWrongKind(name, symbol, "a function");
    return {};
  }
  file_.at(node).symbol = found;
  if (symbol.has(Symbol::NotBuilt)) {
    reportRefused(file_, name, symbol);
  } else {
    CallCheck(*this).check(node, found);
  }
  return {symbol.type, kNoConstant};
}

}  // namespace cobot_command::rapid
