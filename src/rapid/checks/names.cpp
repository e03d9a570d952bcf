#include "names.h"

#include <algorithm>
#include <bitset>
#include <cstdlib>

#include "cobot_command/common/nearest.h"
#include "cobot_command/rapid/source/name_table.h"

namespace cobot_command::rapid {

namespace {

constexpr std::size_t kMostEdits = 2;

using Letters = std::bitset<64>;

Letters lettersOf(std::string_view name) {
  Letters letters;
  for (const char c : name) letters.set(static_cast<unsigned char>(c) % letters.size());
  return letters;
}

/// False if more than kMostEdits are needed for sure: each one changes the length by one, and the set of
/// letters by two.
bool mayBeNear(std::string_view left, const Letters& letters, std::string_view right) {
  const auto difference = static_cast<std::int64_t>(left.size()) - static_cast<std::int64_t>(right.size());
  return std::abs(difference) <= static_cast<std::int64_t>(kMostEdits) &&
         (letters ^ lettersOf(right)).count() <= 2 * kMostEdits;
}

}  // namespace

std::string nearestName(std::string_view written, const std::vector<std::string_view>& names) {
  constexpr std::size_t kShortest = 3;  // of two letters almost every name is near
  const std::string word = folded(written);
  if (word.size() < kShortest) return {};
  const Letters letters = lettersOf(word);
  std::vector<std::string> candidates;
  std::vector<std::string_view> as_written;
  for (const std::string_view name : names) {
    std::string candidate = folded(name);
    if (!mayBeNear(word, letters, candidate)) continue;
    candidates.push_back(std::move(candidate));
    as_written.push_back(name);
  }
  const std::string nearest = nearestOf(word, candidates, kMostEdits);
  const auto found = std::find(candidates.begin(), candidates.end(), nearest);
  return found == candidates.end()
             ? std::string()
             : std::string(as_written[static_cast<std::size_t>(found - candidates.begin())]);
}

Names::Names(FileDraft& file)
    : file_(file), known_(file.source().names().size()), routine_(file.source().names().size(), kNoSymbol) {}

void Names::enterModule(SymbolIndex module) {
  leaveRoutine();
  if (module == module_) return;
  module_ = module;
  ++module_number_;
}

const Names::Known& Names::known(NameIndex name) {
  Known& known = known_[name];
  if (known.module_number == module_number_) return known;
  const Draft& draft = file_.draft();
  const std::string_view folded = file_.source().names().folded(name);
  known = {module_number_, draft.parts.names.find(module_, folded), draft.type_names.find(module_, folded)};
  return known;
}

SymbolIndex Names::find(TokenIndex name) {
  if (!file_.isName(name)) return kNoSymbol;
  const NameIndex index = file_.nameAt(name);
  return routine_[index] != kNoSymbol ? routine_[index] : known(index).symbol;
}

SymbolIndex Names::findType(TokenIndex name) {
  return file_.isName(name) ? known(file_.nameAt(name)).type : kNoSymbol;
}

SymbolIndex Names::set(NameIndex name, SymbolIndex symbol) {
  if (symbol != kNoSymbol) routine_names_.push_back(name);
  return std::exchange(routine_[name], symbol);
}

void Names::leaveRoutine() {
  for (const NameIndex name : routine_names_) routine_[name] = kNoSymbol;
  routine_names_.clear();
}

bool Names::isMeant(const Symbol& symbol, Meant meant) const {
  switch (meant) {
    case Meant::Value:
      return symbol.isData() || symbol.kind == SymbolKind::Function;
    case Meant::Procedure:
      return symbol.kind == SymbolKind::Procedure;
    case Meant::Trap:
      return symbol.kind == SymbolKind::Trap;
    case Meant::Type:
      return symbol.kind == SymbolKind::Type;
    case Meant::Signal:
      return symbol.kind == SymbolKind::Signal;
  }
  return false;
}

std::string Names::nearest(TokenIndex name, Meant meant) {
  if (!file_.maySearch()) return {};
  const Draft& draft = file_.draft();
  std::vector<std::string_view> names;
  const auto add = [&](SymbolIndex index) {
    const Symbol& symbol = draft.symbol(index);
    if (isMeant(symbol, meant)) names.push_back(symbol.name);
  };
  for (const NameIndex local : routine_names_) {
    if (routine_[local] != kNoSymbol) add(routine_[local]);
  }
  const NameSpace& space = meant == Meant::Type ? draft.type_names : draft.parts.names;
  const auto add_all = [&](const NameMap& map) {
    for (const auto& [folded, symbol] : map) add(symbol);
  };
  const auto own = space.modules.find(module_);
  if (own != space.modules.end()) add_all(own->second);
  add_all(space.globals);
  add_all(space.predefined);
  return nearestName(file_.source().textOf(name), names);
}

}  // namespace cobot_command::rapid
