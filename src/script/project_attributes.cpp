#include "cobot_command/script/project_attributes.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "call_text.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::script {
namespace {

struct Row {
  std::string_view object;
  std::string_view attribute;
  int channel;
  std::size_t numbers;
};

/// In the order of ProjectAttribute.
constexpr std::array<Row, 5> kRows{{
    {"TCP", "Value", 90, 6},
    {"TCP", "Mass", 91, 1},
    {"TCP", "MOI", 92, 3},
    {"TCP", "MCF", 93, 6},
    {"Base", "Value", 90, 6},
}};

const Row& rowOf(ProjectAttribute attribute) {
  return kRows.at(static_cast<std::size_t>(attribute));
}

/// TCP["gripper"].Value
std::string attributeText(ProjectAttribute attribute, const std::string& name) {
  assert(isAttributeKey(name));
  const Row& row = rowOf(attribute);
  std::string text(row.object);
  text += '[';
  appendQuoted(text, name);
  return text.append("].").append(row.attribute);
}

template <class Line>
void appendLine(std::string& script, const Line& line) {
  if (!script.empty()) script += "\r\n";
  script += line;
}

}  // namespace

std::size_t numbersOf(ProjectAttribute attribute) {
  return rowOf(attribute).numbers;
}

int channelOf(ProjectAttribute attribute) {
  return rowOf(attribute).channel;
}

bool isAttributeChannel(int channel) {
  return std::any_of(kRows.begin(), kRows.end(), [&](const Row& row) { return row.channel == channel; });
}

bool isAttributeKey(std::string_view name) {
  return isName(name) && std::count(name.begin(), name.end(), '\'') < 2;
}

std::string describe(const AttributeRead& read) {
  const Row& row = rowOf(read.attribute);
  return fmt::format("{}[\"{}\"].{}", row.object, foreignText(read.name, kQuoteLimit), row.attribute);
}

std::string toText(const AttributeRead& read) {
  return fmt::format("ListenSend({},{})", channelOf(read.attribute),
                     attributeText(read.attribute, read.name));
}

std::string toText(const AttributeWrite& write) {
  assert(write.numbers.size() == numbersOf(write.attribute));
  std::string text = attributeText(write.attribute, write.name) + '=';
  const bool is_array = write.numbers.size() > 1;
  if (is_array) text += '{';
  for (std::size_t i = 0; i < write.numbers.size(); ++i) {
    if (i > 0) text += ',';
    appendNumber(text, write.numbers[i]);
  }
  if (is_array) text += '}';
  return text;
}

std::string toText(const ReadingScript& script) {
  assert(isAttributeKey(script.mark));
  std::string text = fmt::format("ListenSend({},", kMarkChannel);
  appendQuoted(text, script.mark);
  text += ')';
  for (const AttributeRead& read : script.reads) appendLine(text, toText(read));
  return text;
}

std::string toText(const std::vector<AttributeWrite>& script) {
  std::string text;
  for (const AttributeWrite& write : script) appendLine(text, toText(write));
  return text;
}

}  // namespace cobot_command::script
