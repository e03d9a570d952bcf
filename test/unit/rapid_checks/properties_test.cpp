// Properties of any text: the check ends, with findings within the limits.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "checked_text.h"
#include "source_tree.h"
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {
namespace {

using Text = std::string;

void checkAnyText(const Text& text) {
  for (const Dialect dialect : {Dialect::Irc5, Dialect::S4c}) {
    const CheckedProgram checked = checkedText(text, {}, dialect);
    const std::vector<Finding>& findings = checked.findings.front();
    bool has_error = false;
    RC_ASSERT(findings.size() <= kMostFindings + 1);
    for (const Finding& finding : findings) {
      RC_ASSERT(finding.text == escaped(finding.text));
      RC_ASSERT(finding.text.size() < 500);
      has_error = has_error || finding.severity() == Severity::Error;
    }
    RC_ASSERT((checked.program == nullptr) == has_error);
  }
}

std::vector<Text> fixtureModules() {
  std::vector<Text> texts;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test_support::inSourceTree("test/data/rapid"))) {
    if (entry.path().extension() != ".mod") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

const std::vector<Text>& modules() {
  static const std::vector<Text> all = fixtureModules();
  return all;
}

RC_GTEST_PROP(RapidCheckProperties, anyBytesEndInFindings, (const Text& bytes)) {
  checkAnyText(bytes);
}

RC_GTEST_PROP(RapidCheckProperties, damagedFixturesEndInFindings, ()) {
  Text text = *rc::gen::elementOf(modules());
  for (int more = *rc::gen::inRange(1, 6); more > 0; --more) {
    const auto at = static_cast<std::size_t>(*rc::gen::inRange<std::size_t>(0, text.size() + 1));
    const auto size = static_cast<std::size_t>(*rc::gen::inRange(0, 12));
    const auto other = *rc::gen::elementOf(std::vector<Text>{";",
                                                             "(",
                                                             ")",
                                                             "]",
                                                             "{",
                                                             "\"",
                                                             "\n",
                                                             "ENDIF",
                                                             " IF ",
                                                             ":=",
                                                             "%",
                                                             "\\",
                                                             "num ",
                                                             "clock ",
                                                             "1",
                                                             "a",
                                                             "main",
                                                             "tool0",
                                                             "{1}",
                                                             ".x",
                                                             "[1,2,3]",
                                                             "1E38*1E38",
                                                             "\xE2\x82\xAC",
                                                             ""});
    text.replace(at, size, other);
  }
  checkAnyText(text);
}

/// Parts of fixtures in other places: names and types that do not fit.
RC_GTEST_PROP(RapidCheckProperties, mixedFixturesEndInFindings, ()) {
  Text text = *rc::gen::elementOf(modules());
  const Text other = *rc::gen::elementOf(modules());
  for (int more = *rc::gen::inRange(1, 4); more > 0; --more) {
    const auto from = static_cast<std::size_t>(*rc::gen::inRange<std::size_t>(0, other.size()));
    const auto at = static_cast<std::size_t>(*rc::gen::inRange<std::size_t>(0, text.size() + 1));
    text.insert(at, other.substr(from, 60));
  }
  checkAnyText(text);
}

}  // namespace
}  // namespace cobot_command::rapid
