#include "draft.h"

#include <utility>

namespace cobot_command::rapid {

namespace {

constexpr std::uint32_t kCellsPerMebibyte = (1U << 20U) / sizeof(Cell);

}  // namespace

SymbolIndex Draft::add(const Symbol& symbol) {
  parts.symbols.push_back(symbol);
  ready.push_back(0);
  return static_cast<SymbolIndex>(parts.symbols.size() - 1);
}

ConstantIndex Draft::reserve(std::uint32_t cells) {
  if (!takeData(cells)) return kNoConstant;
  const auto place = static_cast<ConstantIndex>(parts.constants.size());
  parts.constants.resize(place + cells);
  return place;
}

bool Draft::takeData(std::uint32_t cells) {
  data_cells += cells;
  return data_cells <= kMostCells;
}

Symbol FileDraft::symbolOf(SymbolKind kind, NodeIndex node, SymbolIndex owner) const {
  Symbol symbol;
  symbol.kind = kind;
  symbol.file = file_;
  symbol.node = node;
  symbol.owner = owner;
  if (isName(tree_[node].name)) symbol.name = source_.textOf(tree_[node].name);
  return symbol;
}

SymbolIndex FileDraft::declare(const Symbol& symbol) {
  return at(symbol.node).symbol = draft_.add(symbol);
}

void FileDraft::reportNear(const FindingKind& kind, TokenIndex token, const std::string& meant) {
  const Token& at = source_.tokens()[token];
  Finding found = finding(kind, {at.begin, at.end}, quotedAt(token));
  if (!meant.empty()) found.text += "; did you mean " + quoted(meant) + "?";
  add(std::move(found));
}

void FileDraft::reportTooLarge(TokenIndex token) {
  if (std::exchange(draft_.is_too_large, true)) return;
  report(kinds::kLargeProgram, token, kMostCells / kCellsPerMebibyte);
}

void FileDraft::add(Finding finding) {
  if (finding.severity() == Severity::Error) ++errors_;
  draft_.findings[file_].add(std::move(finding));
}

}  // namespace cobot_command::rapid
