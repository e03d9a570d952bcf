#include "cobot_command/rapid/source/source.h"

#include <algorithm>
#include <utility>

#include "lexer/decoding.h"
#include "lexer/lexer.h"
#include "parser/cursor.h"
#include "parser/file_parser.h"
#include "reporting.h"

#include "cobot_command/common/utf8.h"

namespace cobot_command::rapid {

namespace {

LineEnd firstLineEnd(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos || text[end] == '\n') return LineEnd::Lf;
  return text.substr(end, 2) == "\r\n" ? LineEnd::CrLf : LineEnd::Cr;
}

}  // namespace

Source Source::unreadable(std::string_view reason) {
  Source source;
  Findings findings;
  findings.add(finding(kinds::kUnreadable, {}, quoted(reason)));
  source.parse({}, findings);
  return source;
}

/// Of text_ and dialect_.
void Source::parse(const ReadOptions& options, Findings& findings) {
  Lexed lexed = lex(text_, dialect_, names_, findings);
  tree_.reserve(lexed.tokens.size() / 8 * 5 + 1);
  Cursor cursor(text_, lexed, dialect_, findings);
  FileParser(cursor, tree_, options.has_bodies).file();
  steps_ = cursor.steps();
  tokens_ = std::move(lexed.tokens);
  line_starts_ = std::move(lexed.line_starts);
  findings_ = findings.take();
}

bool Source::isBroken() const {
  return std::any_of(findings_.begin(), findings_.end(), [](const Finding& finding) {
    const char hundreds = finding.id[1];
    return finding.severity() == Severity::Error &&
           std::string_view("1289").find(hundreds) != std::string_view::npos;
  });
}

std::string_view Source::textOf(TokenIndex token) const {
  if (token == kNoToken) return {};
  const Token& at = tokens_[token];
  return text().substr(at.begin, at.end - at.begin);
}

std::string_view Source::nameOf(NodeIndex node) const {
  const TokenIndex name = tree_[node].name;
  if (name == kNoToken || tokens_[name].kind != TokenKind::Name) return {};
  return names_.folded(tokens_[name].name);
}

Span Source::spanOf(NodeIndex node) const {
  const Node& at = tree_[node];
  const std::uint32_t begin = tokens_[at.first].begin;
  const bool is_empty = at.last == kNoToken || at.last < at.first;
  return {begin, is_empty ? begin : tokens_[at.last].end};
}

Place Source::placeOf(std::uint32_t offset) const {
  const std::uint32_t line = lineAt(line_starts_, offset);
  const std::string_view before = text().substr(line_starts_[line], offset - line_starts_[line]);
  return {static_cast<int>(line) + 1, static_cast<int>(countCharacters(before)) + 1};
}

std::string_view Source::lineAround(std::uint32_t offset) const {
  const std::string_view from = text().substr(line_starts_[lineAt(line_starts_, offset)]);
  return from.substr(0, from.find_first_of("\r\n"));
}

Source readSource(std::string_view bytes, const ReadOptions& options) {
  Source source;
  source.dialect_ = options.dialect;
  Findings findings;
  if (auto text = decoded(bytes)) {
    source.encoding_ = text->encoding;
    source.text_ = std::move(text->text);
    source.line_end_ = firstLineEnd(source.text_);
  } else {
    findings.add(std::move(text.error()));
  }
  source.parse(options, findings);
  return source;
}

std::string describe(const Source& source, const Finding& finding, std::string_view file) {
  const Place place = source.placeOf(finding.span.begin);
  return fmt::format("{}:{}:{}: {} {}: {}", foreignText(file), place.line, place.column,
                     toString(finding.severity()), finding.id, finding.text);
}

}  // namespace cobot_command::rapid
