#include "routines/routine_scope.h"

#include <algorithm>

#include <fmt/format.h>

namespace cobot_command::rapid {

void RoutineScope::enter(SymbolIndex routine) {
  routine_ = routine;
  labels_.clear();
  names_.enterModule(draft_.symbol(routine).owner);
  parameters();
  const NodeIndex node = draft_.symbol(routine).node;
  for (const NodeIndex child : file_.tree().children(node)) {
    const NodeIndex list =
        file_[child].kind == NodeKind::Handler ? file_.tree().childOf(child, NodeKind::List) : child;
    if (list != kNoNode && file_[list].kind == NodeKind::List) instructions(list, list);
  }
}

void RoutineScope::parameters() {
  const Symbol routine = draft_.symbol(routine_);
  for (std::uint32_t i = 0; i < routine.parameters; ++i) {
    const SymbolIndex parameter = routine.first_parameter + i;
    declare(draft_.symbol(parameter).node, parameter);
  }
}

/// `block`: a GOTO to a label here must be in it. A compact IF is one that no GOTO is in.
void RoutineScope::instructions(NodeIndex node, NodeIndex block) {
  for (const NodeIndex child : file_.tree().children(node)) {
    file_.countStep();
    const NodeKind kind = file_[child].kind;
    if (kind == NodeKind::Data) data(child);
    if (kind == NodeKind::Label) label(child, block);
    if (!containsInstructions(kind)) continue;
    instructions(child, kind == NodeKind::List || kind == NodeKind::CompactIf ? child : block);
  }
}

void RoutineScope::data(NodeIndex node) {
  const Node& at = file_[node];
  if (at.word == TokenKind::Pers && !at.has(Node::Faulty)) {
    file_.report(kinds::kPersInRoutine, at.has(Node::Task) ? at.first + 1 : at.first);
  }
  if (!file_.isName(at.name)) return;
  Symbol symbol = file_.symbolOf(SymbolKind::Data, node, routine_);
  symbol.word = at.word;
  symbol.flags = static_cast<std::uint8_t>((at.word == TokenKind::Const ? Symbol::ReadOnly : 0) |
                                           (at.has(Node::Faulty) ? Symbol::Faulty : 0));
  declare(node, file_.declare(symbol));
}

/// A parameter or data. A name that is there already keeps its first meaning.
void RoutineScope::declare(NodeIndex node, SymbolIndex symbol) {
  const TokenIndex name = file_[node].name;
  if (!file_.isName(name)) return;
  const NameIndex index = file_.nameAt(name);
  const SymbolIndex first = names_.inRoutine(index);
  if (first != kNoSymbol) {
    const Token& token = file_.source().tokens()[file_[draft_.symbol(first).node].name];
    const Place place = file_.source().placeOf(token.begin);
    return file_.report(kinds::kDeclaredAlready, name, file_.quotedAt(name),
                        fmt::format("{}:{}", place.line, place.column));
  }
  const SymbolIndex hidden = foundIn(draft_.parts.names.predefined, file_.foldedAt(name));
  const bool hides = hidden != kNoSymbol &&
                     (draft_.dialect == Dialect::Irc5 || !draft_.symbol(hidden).has(Symbol::Irc5Only));
  if (hides) file_.report(kinds::kHidesPredefined, name, file_.quotedAt(name));
  names_.set(index, symbol);
}

void RoutineScope::label(NodeIndex node, NodeIndex block) {
  const TokenIndex name = file_[node].name;
  if (!file_.isName(name)) return;
  const NameIndex index = file_.nameAt(name);
  if (names_.inRoutine(index) != kNoSymbol || labels_.count(index) > 0) {
    return file_.report(kinds::kLabelTwice, name, file_.quotedAt(name));
  }
  labels_[index] = {file_.declare(file_.symbolOf(SymbolKind::Label, node, routine_)), block};
}

void RoutineScope::bindGoto(NodeIndex node, const std::vector<NodeIndex>& blocks) {
  const TokenIndex name = file_[node].name;
  if (!file_.isName(name)) return;
  const auto found = labels_.find(file_.nameAt(name));
  if (found == labels_.end()) return file_.reportNear(kinds::kNoLabel, name, nearestLabel(name));
  file_.at(node).symbol = found->second.symbol;
  if (std::find(blocks.begin(), blocks.end(), found->second.block) == blocks.end()) {
    file_.report(kinds::kLabelInside, name, file_.quotedAt(name));
  }
}

std::string RoutineScope::nearestLabel(TokenIndex name) const {
  if (!file_.maySearch()) return {};
  std::vector<std::string_view> names;
  for (const auto& [index, label] : labels_) names.push_back(draft_.symbol(label.symbol).name);
  return nearestName(file_.source().textOf(name), names);
}

}  // namespace cobot_command::rapid
