// Names in expressions, with what is selected of them.
#include <cmath>

#include "expressions/expression_check.h"
#include "type_reference.h"
#include <fmt/format.h>

namespace cobot_command::rapid {

namespace {

std::string_view described(SymbolKind kind, TokenKind word) {
  switch (kind) {
    case SymbolKind::Module:
      return "a module";
    case SymbolKind::Type:
      return "a data type";
    case SymbolKind::Procedure:
      return "a procedure";
    case SymbolKind::Function:
      return "a function";
    case SymbolKind::Trap:
      return "a trap";
    case SymbolKind::Label:
      return "a label";
    case SymbolKind::Signal:
      return "a signal";
    case SymbolKind::Counter:
      return "a loop counter";
    case SymbolKind::Parameter:
      return "a parameter";
    default:
      return word == TokenKind::Const  ? "a constant"
             : word == TokenKind::Pers ? "a persistent"
                                       : "a variable";
  }
}

/// Why data cannot be changed; empty if it can.
std::string_view whyFixed(const Symbol& symbol) {
  if (symbol.kind == SymbolKind::Counter) return "loop counter";
  if (symbol.word == TokenKind::Const) return "CONST";
  const bool is_read_only = symbol.kind == SymbolKind::Signal || symbol.has(Symbol::ReadOnly);
  return is_read_only ? "read-only" : "";
}

}  // namespace

SymbolIndex ExpressionCheck::bind(TokenIndex name, const FindingKind& unknown, Meant meant) {
  if (!file_.isName(name)) return kNoSymbol;
  const SymbolIndex found = names_.find(name);
  if (found == kNoSymbol) {
    const SymbolIndex type = names_.findType(name);
    if (type == kNoSymbol || unknown.id == kinds::kNoSignal.id) {
      file_.reportNear(unknown, name, names_.nearest(name, meant));
    } else {
      reportWrongKind(name, draft_.symbol(type), meant == Meant::Value ? "a value" : "a procedure");
    }
    return kNoSymbol;
  }
  const Symbol& symbol = draft_.symbol(found);
  if (!symbol.has(Symbol::Irc5Only) || draft_.dialect == Dialect::Irc5) return found;
  file_.report(kinds::kNotInS4c, name, file_.quotedAt(name));
  return kNoSymbol;
}

void ExpressionCheck::reportWrongKind(TokenIndex name, const Symbol& symbol, std::string_view wanted) {
  if (symbol.kind == SymbolKind::Refused) return reportRefused(file_, name, symbol);
  file_.report(kinds::kWrongKind, name, file_.quotedAt(name), described(symbol.kind, symbol.word), wanted);
}

Referred ExpressionCheck::refer(NodeIndex reference, TypeIndex context) {
  const TokenIndex name = file_[reference].name;
  const bool is_signal = context != kNoContext && isSignalType(draft_.types()[context]);
  const SymbolIndex found =
      is_signal ? bind(name, kinds::kNoSignal, Meant::Signal) : bind(name, kinds::kNotDeclared, Meant::Value);
  Referred referred;
  if (found == kNoSymbol) {
    select(referred, reference);
    return referred;
  }
  const Symbol& symbol = draft_.symbol(found);
  file_.at(reference).symbol = found;
  if (symbol.isData()) {
    const bool is_constant = symbol.has(Symbol::ReadOnly) && symbol.kind == SymbolKind::Data;
    referred = {found, symbol.type, is_constant ? symbol.value : kNoConstant, true};
  } else {
    reportWrongKind(name, symbol, "a value");
  }
  select(referred, reference);
  file_.at(reference).type = referred.type;
  return referred;
}

Typed ExpressionCheck::reference(NodeIndex node, TypeIndex context) {
  const Referred referred = refer(node, context);
  return {referred.type, referred.constant};
}

void ExpressionCheck::select(Referred& referred, NodeIndex reference) {
  for (const NodeIndex selector : file_.tree().children(reference)) {
    referred.is_whole = false;
    if (file_[selector].kind == NodeKind::Index) {
      index(referred, reference, selector);
    } else {
      component(referred, selector);
    }
    file_.at(selector).type = referred.type;
    file_.at(selector).constant = referred.constant;
  }
}

void ExpressionCheck::index(Referred& referred, NodeIndex reference, NodeIndex index) {
  const Type array = draft_.types()[referred.type];
  const std::uint32_t dimensions = array.kind == TypeKind::Array ? array.dimensions : 0;
  std::uint32_t given = 0;
  std::uint32_t element = 0;
  bool is_known = true;
  for (const NodeIndex child : file_.tree().children(index)) {
    const Typed typed = expect(child, kNum);
    const std::uint32_t size = given < dimensions ? array.sizes.at(given) : 0;
    ++given;
    const Cell* const value = typed.type == kNum ? valueOf(typed) : nullptr;
    const bool is_whole = value != nullptr && *value == std::trunc(*value);
    is_known = is_known && is_whole && size > 0;
    if (!is_whole || size == 0) continue;
    if (*value < 1 || *value > static_cast<float>(size)) {
      file_.reportNode(kinds::kIndexRange, child, fmt::format("{:.7g}", *value), size);
      is_known = false;
    } else {
      element = element * size + static_cast<std::uint32_t>(*value) - 1;
    }
  }
  if (referred.type == kNoType) return;
  if (given != dimensions) {
    file_.report(kinds::kIndexCount, file_[index].first, file_.quotedAt(file_[reference].name), dimensions,
                 given);
    referred.type = kNoType;
    referred.constant = kNoConstant;
    return;
  }
  referred.type = array.element;
  const bool is_constant = is_known && referred.constant != kNoConstant;
  referred.constant =
      is_constant ? referred.constant + element * draft_.types()[array.element].cells : kNoConstant;
}

void ExpressionCheck::component(Referred& referred, NodeIndex part) {
  const TokenIndex name = file_[part].name;
  if (referred.type == kNoType || !file_.isName(name)) {
    referred.type = kNoType;
    return;
  }
  const auto position = draft_.types().componentNamed(referred.type, file_.foldedAt(name));
  if (!position) {
    file_.report(kinds::kNoComponent, name, file_.typeName(referred.type), file_.quotedAt(name));
    referred.type = kNoType;
    referred.constant = kNoConstant;
    return;
  }
  const Component& component = draft_.types()[referred.type].components[*position];
  file_.at(part).symbol = *position;
  referred.type = component.type;
  if (referred.constant != kNoConstant) referred.constant += component.offset;
}

TypeIndex ExpressionCheck::target(NodeIndex reference) {
  if (file_[reference].kind != NodeKind::Reference) return kNoType;
  const TokenIndex name = file_[reference].name;
  const SymbolIndex found = file_.isName(name) ? names_.find(name) : kNoSymbol;
  if (found != kNoSymbol && draft_.symbol(found).isRoutine()) {
    file_.report(kinds::kUnchangeable, name, file_.quotedAt(name), "routine");
    return kNoType;
  }
  const Referred referred = refer(reference);
  if (referred.symbol == kNoSymbol || referred.type == kNoType) return kNoType;
  const Symbol& symbol = draft_.symbol(referred.symbol);
  const Type& type = draft_.types()[referred.type];
  const std::string_view why = type.kind == TypeKind::SemiValue ? "read-only" : whyFixed(symbol);
  if (!type.has_values) {
    file_.report(kinds::kNoValues, name, file_.typeName(referred.type));
  } else if (!why.empty()) {
    file_.report(kinds::kUnchangeable, name, file_.quotedAt(name), why);
  } else {
    return referred.type;
  }
  return kNoType;
}

}  // namespace cobot_command::rapid
