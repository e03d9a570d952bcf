#include "cobot_command/tm_script/parser.h"

#include <algorithm>
#include <array>

#include "grammar/grammar.h"
#include "grammar/source_lines.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::tm_script {

namespace {

/// Words of TMscript, the language of whole programs since TMflow 2.
constexpr std::array<std::string_view, 20> kProgramWords{
    "if",     "else",   "for",  "while",     "do",        "switch", "case", "default", "break", "continue",
    "return", "define", "main", "closestop", "errorstop", "void",   "var",  "const",   "goto",  "try"};

bool isOfPrograms(std::string_view word) {
  return std::find(kProgramWords.begin(), kProgramWords.end(), word) != kProgramWords.end();
}

std::string_view firstWord(std::string_view line) {
  const std::size_t start = line.find_first_not_of(" \t\r}");
  if (start == std::string_view::npos) return {};
  line.remove_prefix(start);
  constexpr const char* kWord = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
  return line.substr(0, line.find_first_not_of(kWord));
}

}  // namespace

Fault faultOf(int line, std::string_view reason) {
  constexpr std::size_t kLongestReason = 1024;  // [bytes]; one lists all forms of a function
  return {line, foreignText(reason, kLongestReason)};
}

bool isReservedWord(std::string_view word) {
  return isConstant(word) || isOfPrograms(word);
}

ParsedScript parse(std::string_view text) {
  ParsedScript script;
  const SourceLines source = splitLines(text);
  for (const SourceLine& line : source.lines) {
    const std::string_view word = firstWord(line.text);
    if (isOfPrograms(word)) {
      script.faults.push_back(faultOf(
          line.number,
          fmt::format("\"{}\" belongs to the programs of TMflow 2; a script of the Listen node is made of "
                      "declarations, assignments and calls",
                      word)));
      continue;
    }
    auto statement = parseLine(line.text);
    if (!statement) {
      script.faults.push_back(faultOf(line.number, statement.error()));
    } else if (*statement) {
      (*statement)->line = line.number;
      script.statements.push_back(std::move(**statement));
    }
  }
  return script;
}

}  // namespace cobot_command::tm_script
