#include "tree_text.h"

#include <array>

#include <fmt/format.h>

namespace cobot_command::rapid {

namespace {

/// In the order of NodeKind.
constexpr std::array kKinds{
    "File",       "Header",      "Module",     "Attribute", "Record",     "Component",    "Alias",
    "Data",       "Routine",     "Parameters", "Parameter", "Handler",    "ErrorNumbers", "TypeName",
    "Dimensions", "List",        "Assignment", "Call",      "LateCall",   "Label",        "If",
    "Elseif",     "Else",        "CompactIf",  "For",       "Step",       "While",        "Test",
    "Case",       "DefaultCase", "Goto",       "Return",    "Raise",      "Retry",        "Trynext",
    "Exit",       "Connect",     "Unread",     "Argument",  "Operation",  "Index",        "Part",
    "Number",     "String",      "Bool",       "Reference", "Function",   "Aggregate",    "Parentheses",
    "Sign",       "Not",         "Chain",      "Star",      "Placeholder"};

bool hasWord(NodeKind kind) {
  switch (kind) {
    case NodeKind::Data:
    case NodeKind::Routine:
    case NodeKind::Parameter:
    case NodeKind::Handler:
    case NodeKind::Operation:
    case NodeKind::Sign:
      return true;
    default:
      return false;
  }
}

std::string flagsText(const Node& node) {
  std::string text;
  for (const auto& [flag, sign] :
       {std::pair(Node::Faulty, "!"), std::pair(Node::Local, "local "), std::pair(Node::Task, "task "),
        std::pair(Node::Optional, "\\"), std::pair(Node::Excludes, "|"), std::pair(Node::Conditional, "?")}) {
    if (node.has(flag)) text += sign;
  }
  return text;
}

}  // namespace

std::string treeText(const Source& source, NodeIndex node) {
  const Node& at = source.tree()[node];
  std::string text = flagsText(at) + kKinds.at(static_cast<std::size_t>(at.kind));
  if (hasWord(at.kind) && !toString(at.word).empty()) text += ' ' + std::string(toString(at.word));
  if (at.name != kNoToken) text += ' ' + std::string(source.textOf(at.name));
  std::string children;
  for (const NodeIndex child : source.tree().children(node)) {
    children += (children.empty() ? "" : ", ") + treeText(source, child);
  }
  return children.empty() ? text : text + '(' + children + ')';
}

std::string repeated(std::size_t times, const std::string& text) {
  std::string all;
  all.reserve(times * text.size());
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string inRoutine(const std::string& lines, const std::string& declarations) {
  return "MODULE m\n" + declarations + "PROC p()\n" + lines + "\nENDPROC\nENDMODULE\n";
}

NodeIndex bodyOf(const Source& source) {
  const Tree& tree = source.tree();
  const NodeIndex module = tree.childOf(Tree::kRoot, NodeKind::Module);
  return tree.childOf(tree.childOf(module, NodeKind::Routine), NodeKind::List);
}

std::string instructionText(const std::string& line, Dialect dialect) {
  const Source source = readSource(inRoutine(line), {dialect});
  const NodeIndex first = source.tree()[bodyOf(source)].child;
  return first == kNoNode ? "nothing" : treeText(source, first);
}

std::string expressionText(const std::string& expression) {
  const Source source = readSource(inRoutine("a:=" + expression + ";"));
  const NodeIndex assignment = source.tree()[bodyOf(source)].child;
  const NodeIndex target = source.tree()[assignment].child;
  const NodeIndex value = source.tree()[target].next;
  return value == kNoNode ? "nothing" : treeText(source, value);
}

std::vector<std::string> idsAndPlaces(const Source& source) {
  std::vector<std::string> found;
  for (const Finding& finding : source.findings()) {
    const Place place = source.placeOf(finding.span.begin);
    found.push_back(fmt::format("{} {}:{}", finding.id, place.line, place.column));
  }
  return found;
}

std::vector<std::string> findingsOf(const std::string& text, Dialect dialect) {
  return idsAndPlaces(readSource(text, {dialect}));
}

std::vector<std::string> tokenTexts(const Source& source) {
  std::vector<std::string> texts;
  for (TokenIndex token = 0; token < source.tokens().size(); ++token) {
    const TokenKind kind = source.tokens()[token].kind;
    const bool has_case = kind == TokenKind::Comment || kind == TokenKind::Text || kind == TokenKind::Number;
    const std::string text(source.textOf(token));
    texts.push_back(fmt::format("{} {}", static_cast<int>(kind), has_case ? text : folded(text)));
  }
  return texts;
}

}  // namespace cobot_command::rapid
