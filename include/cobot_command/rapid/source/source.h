// Reads the text of a RAPID file: tokens, tree, and findings of what cannot be read. Any bytes are accepted.
//
//   const Source source = readSource(bytes, {Dialect::Irc5});
//   for (const Finding& finding : source.findings()) print(describe(source, finding, "robot.mod"));
//   for (NodeIndex module : source.tree().children(Tree::kRoot)) ...
//
// Reading finds the errors of characters and grammar in one pass, 1xx, 2xx and 8xx, and with them what the
// form of a declaration shows by itself (finding_kinds.h). It knows neither names nor types.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/dialect.h"
#include "cobot_command/rapid/source/encoding.h"
#include "cobot_command/rapid/source/finding.h"
#include "cobot_command/rapid/source/name_table.h"
#include "cobot_command/rapid/source/token.h"
#include "cobot_command/rapid/source/tree.h"

namespace cobot_command::rapid {

struct ReadOptions {
  Dialect dialect = Dialect::Irc5;
  /// False: routines are declared by their first line alone, without body and END word, as in a catalogue.
  bool has_bodies = true;
};

/// A position for people.
struct Place {
  int line = 1;    ///< from 1
  int column = 1;  ///< from 1, in characters; a tab is one
};

/// A file that was read. All positions in it are offsets and indices of 32 bits, so it can be moved.
class Source {
 public:
  /// Without a text, for a file that cannot be read: the finding E901 with the reason.
  [[nodiscard]] static Source unreadable(std::string_view reason);

  [[nodiscard]] Dialect dialect() const { return dialect_; }
  /// In UTF-8, without byte order mark. Empty if the file is no text.
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] Encoding encoding() const { return encoding_; }
  [[nodiscard]] LineEnd lineEnd() const { return line_end_; }
  /// The last one is End.
  [[nodiscard]] const std::vector<Token>& tokens() const { return tokens_; }
  [[nodiscard]] const NameTable& names() const { return names_; }
  [[nodiscard]] const Tree& tree() const { return tree_; }
  /// In the order of the text; see Findings.
  [[nodiscard]] const std::vector<Finding>& findings() const { return findings_; }
  /// How many tokens the parser looked at: a few for each one, whatever the text is. Tests count them,
  /// because a clock proves no linear time.
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  /// True if an error leaves open what a part of the text means, so that it must not be printed (1xx, 2xx,
  /// 8xx, 9xx).
  [[nodiscard]] bool isBroken() const;

  [[nodiscard]] std::string_view textOf(TokenIndex token) const;
  /// The name of a node in small letters; empty if it has none.
  [[nodiscard]] std::string_view nameOf(NodeIndex node) const;
  [[nodiscard]] Span spanOf(NodeIndex node) const;
  /// `offset`: in text(), at most its size.
  [[nodiscard]] Place placeOf(std::uint32_t offset) const;
  /// The whole line with the byte at `offset`, without its end.
  [[nodiscard]] std::string_view lineAround(std::uint32_t offset) const;

 private:
  friend Source readSource(std::string_view bytes, const ReadOptions& options);
  Source() = default;

  void parse(const ReadOptions& options, Findings& findings);

  Dialect dialect_ = Dialect::Irc5;
  Encoding encoding_ = Encoding::Utf8;
  LineEnd line_end_ = LineEnd::Lf;
  std::string text_;
  std::vector<Token> tokens_;
  std::vector<std::uint32_t> line_starts_;
  NameTable names_;
  Tree tree_;
  std::vector<Finding> findings_;
  std::uint64_t steps_ = 0;
};

/// `bytes`: a whole file, in UTF-8, UTF-16 with byte order mark, or ISO 8859-1. The time is linear in its
/// size.
[[nodiscard]] Source readSource(std::string_view bytes, const ReadOptions& options = {});

/// "robot.mod:12:5: error E202: ';' is missing"; `file` is treated as foreign text.
[[nodiscard]] std::string describe(const Source& source, const Finding& finding, std::string_view file);

}  // namespace cobot_command::rapid
