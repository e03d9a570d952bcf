#include "predefined_draft.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>

#include "linking/linker.h"

#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {

namespace {

constexpr std::array<std::string_view, 7> kChangeable{"reg1", "reg2",   "reg3", "reg4",
                                                      "reg5", "clock1", "wobj1"};

void addFile(Draft& draft, const Source& source) {
  // It lives as long as the program.
  std::shared_ptr<const Source> shared(&source, [](const Source*) {});
  draft.parts.files.push_back({std::move(shared), std::vector<Meaning>(source.tree().size())});
  draft.file_names.emplace_back("predefined");
  draft.findings.emplace_back();
}

void addAtomicTypes(Draft& draft) {
  for (TypeIndex type = kNum; type < draft.types().size(); ++type) {
    Symbol symbol;
    symbol.kind = SymbolKind::Type;
    symbol.type = type;
    symbol.name = draft.types()[type].name;
    draft.type_names.predefined.emplace(symbol.name, draft.add(symbol));
  }
}

/// Routines and types alike.
void addRefusals(Draft& draft) {
  static const std::vector<std::string> folded_names = [] {
    std::vector<std::string> names;
    for (const Refusal& refusal : refusals()) names.push_back(folded(refusal.name));
    return names;
  }();
  for (std::uint32_t i = 0; i < refusals().size(); ++i) {
    Symbol symbol;
    symbol.kind = SymbolKind::Refused;
    symbol.index = i;
    symbol.name = refusals()[i].name;
    const SymbolIndex added = draft.add(symbol);
    draft.parts.names.predefined.emplace(folded_names[i], added);
    draft.type_names.predefined.emplace(folded_names[i], added);
  }
}

void setFlags(Draft& draft, std::string_view folded_name, SymbolIndex index) {
  Symbol& symbol = draft.symbol(index);
  unsigned flags = symbol.flags;
  const bool is_changeable =
      std::find(kChangeable.begin(), kChangeable.end(), folded_name) != kChangeable.end();
  if (symbol.kind == SymbolKind::Data && !is_changeable) flags |= Symbol::ReadOnly;
  if (symbol.isRoutine() && isNotBuilt(symbol.node)) flags |= Symbol::NotBuilt;
  if (isOfIrc5Alone(folded_name)) flags |= Symbol::Irc5Only;
  symbol.flags = static_cast<std::uint8_t>(flags);
}

/// What the predefined modules declare belongs to no module of the program.
void hideModules(Draft& draft) {
  for (const auto& [name, index] : draft.parts.names.globals) {
    if (draft.symbol(index).kind == SymbolKind::Module) continue;
    setFlags(draft, name, index);
    draft.parts.names.predefined.emplace(name, index);
  }
  draft.type_names.predefined.merge(draft.type_names.globals);
  draft.parts.names.globals.clear();
  draft.parts.names.modules.clear();
  draft.type_names.globals.clear();
  draft.type_names.modules.clear();
}

Draft made() {
  Draft draft;
  draft.is_library = true;
  draft.parts.signals = std::make_shared<const std::vector<Signal>>();
  addFile(draft, predefinedData());
  addFile(draft, catalogue());
  assert(draft.parts.files.size() == kPredefinedFiles);
  addAtomicTypes(draft);
  addRefusals(draft);
  static_cast<void>(link(draft, 0));
  hideModules(draft);
  const auto type_of = [&](std::string_view name) {
    return draft.symbol(draft.type_names.predefined.at(name)).type;
  };
  draft.known = {type_of("pos"), type_of("orient"), type_of("confdata")};
  return draft;
}

}  // namespace

const Draft& predefinedDraft() {
  static const Draft draft = made();
  return draft;
}

}  // namespace cobot_command::rapid
