// A program while it is checked.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "check_kinds.h"
#include "reporting.h"

#include "cobot_command/rapid/checks/check.h"
#include "cobot_command/rapid/source/limits.h"
#include "cobot_command/rapid/types/program.h"

namespace cobot_command::rapid {

/// Predefined records whose aggregates or operations have rules of their own.
struct KnownTypes {
  TypeIndex pos = kNoType;
  TypeIndex orient = kNoType;
  TypeIndex confdata = kNoType;
};

struct Draft {
  ProgramParts parts;
  NameSpace type_names;
  KnownTypes known;
  bool is_library = false;
  std::map<std::string, bool> skipped;  ///< names in small letters; true once one was passed over
  Dialect dialect = Dialect::Irc5;
  std::vector<std::string> file_names;
  std::vector<Findings> findings;   ///< by file
  std::vector<std::uint8_t> ready;  ///< by symbol: 1 for data whose type and value are known
  std::uint64_t data_cells = 0;
  bool is_too_large = false;
  std::uint64_t steps = 0;

  [[nodiscard]] Symbol& symbol(SymbolIndex symbol) { return parts.symbols[symbol]; }
  [[nodiscard]] const Symbol& symbol(SymbolIndex symbol) const { return parts.symbols[symbol]; }
  [[nodiscard]] const TypeTable& types() const { return parts.types; }
  SymbolIndex add(const Symbol& symbol);
  /// Room for a value, with zeros; kNoConstant if the program would become too large.
  [[nodiscard]] ConstantIndex reserve(std::uint32_t cells);
  [[nodiscard]] Cell* cells(ConstantIndex place) { return parts.constants.data() + place; }
  /// Counts the cells of data. False if the program would become too large.
  [[nodiscard]] bool takeData(std::uint32_t cells);
};

/// A file of a draft: its tree, the meanings of its nodes, and its findings.
class FileDraft {
 public:
  FileDraft(Draft& draft, FileIndex file)
      : draft_(draft), file_(file), source_(*draft.parts.files[file].source), tree_(source_.tree()) {}

  [[nodiscard]] Draft& draft() const { return draft_; }
  [[nodiscard]] FileIndex file() const { return file_; }
  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] const Tree& tree() const { return tree_; }
  [[nodiscard]] const Node& operator[](NodeIndex node) const { return tree_[node]; }
  [[nodiscard]] Meaning& at(NodeIndex node) const { return draft_.parts.files[file_].meanings[node]; }

  /// A name that was read: no reserved word, no placeholder.
  [[nodiscard]] bool isName(TokenIndex token) const {
    return token != kNoToken && source_.tokens()[token].kind == TokenKind::Name;
  }
  [[nodiscard]] NameIndex nameAt(TokenIndex token) const { return source_.tokens()[token].name; }
  [[nodiscard]] std::string_view foldedAt(TokenIndex token) const {
    return source_.names().folded(nameAt(token));
  }
  /// The text of a token as it is shown in a finding.
  [[nodiscard]] std::string quotedAt(TokenIndex token) const { return quoted(source_.textOf(token)); }
  [[nodiscard]] std::string typeName(TypeIndex type) const { return quoted(draft_.types().nameOf(type)); }

  /// What a node declares, with its name; that is empty if it could not be read.
  [[nodiscard]] Symbol symbolOf(SymbolKind kind, NodeIndex node, SymbolIndex owner) const;
  /// Adds the symbol; its node means it.
  SymbolIndex declare(const Symbol& symbol);

  template <class... Values>
  void report(const FindingKind& kind, TokenIndex token, const Values&... values) {
    const Token& at = source_.tokens()[token];
    add(finding(kind, {at.begin, at.end}, values...));
  }
  template <class... Values>
  void reportAt(const FindingKind& kind, Span span, const Values&... values) {
    add(finding(kind, span, values...));
  }
  /// At the first token of a node; the span is the whole node.
  template <class... Values>
  void reportNode(const FindingKind& kind, NodeIndex node, const Values&... values) {
    add(finding(kind, source_.spanOf(node), values...));
  }
  /// With a question "did you mean", if `meant` is not empty.
  void reportNear(const FindingKind& kind, TokenIndex token, const std::string& meant);
  void reportTooLarge(TokenIndex token);
  /// False if enough names were searched: the findings of a file are bounded, and a search is slow.
  [[nodiscard]] bool maySearch() { return ++searches_ <= 2 * static_cast<int>(kMostFindings); }

  [[nodiscard]] std::uint64_t errors() const { return errors_; }
  void countStep() const { ++draft_.steps; }

 private:
  void add(Finding finding);

  Draft& draft_;
  FileIndex file_;
  const Source& source_;
  const Tree& tree_;
  std::uint64_t errors_ = 0;
  int searches_ = 0;
};

}  // namespace cobot_command::rapid
