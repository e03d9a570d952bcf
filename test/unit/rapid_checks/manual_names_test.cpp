// The names of the manual: of its summary and its chapters on types, system data, instructions and functions.
// None of them is unknown. doc/rapid-names.md lists what happens to each of them:
//
//   COBOT_MAKE_PAGES=1 build/test/unit/rapid_checks/test_rapid_checks --gtest_filter='*Page*'
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "checked_text.h"
#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {
namespace {

std::vector<std::string> manualNames() {
  std::ifstream file(test_support::inSourceTree("test/data/rapid/manual_names.txt"));
  return {std::istream_iterator<std::string>(file), std::istream_iterator<std::string>()};
}

bool isReserved(const std::string& name) {
  const auto found = NameTable().find(name);
  return found && *found < static_cast<NameIndex>(kReservedWords);
}

/// "not declared" in any of its forms.
bool isUnknown(const Finding& finding) {
  return finding.id == "E401" || finding.id == "E501" || finding.id == "E310" || finding.id == "E419";
}

TEST(RapidManualNames, areNeverCalledUnknown) {
  ASSERT_GT(manualNames().size(), 280U);
  for (const std::string& name : manualNames()) {
    if (isReserved(name)) continue;
    const bool is_type = !predefinedNames().findType(folded(name)).written.empty();
    const std::string as_type = "VAR " + name + " x;\n";
    for (const std::string& text :
         {withMain(name + ";"), withMain("reg1:=" + name + ";"), withMain("reg1:=" + name + "(1);"),
          withMain(name + " 1;"), is_type ? withMain("", as_type) : withMain("")}) {
      const CheckedProgram checked = checkedText(text);
      for (const Finding& finding : checked.findings.front()) {
        EXPECT_FALSE(isUnknown(finding)) << name << ": " << finding.text;
      }
    }
  }
}

/// What happens to a name.
std::string fateOf(const std::string& name) {
  if (isReserved(name)) return "reserved word: checked";
  const std::string small = folded(name);
  for (const Refusal& refusal : refusals()) {
    if (folded(refusal.name) == small) {
      return "refused (E502): `" + std::string(refusal.reason) + "; " + std::string(refusal.way_around) + "`";
    }
  }
  const DeclaredName routine = predefinedNames().find(small);
  if (routine.source == &catalogue()) {
    return isNotBuilt(routine.node) ? "refused (E502): not built yet" : "checked";
  }
  if (!predefinedNames().findType(small).written.empty()) return "data type: checked";
  return routine.source == &predefinedData() ? "predefined data: checked" : "unknown";
}

std::string rows() {
  std::string table;
  for (const std::string& name : manualNames()) table += "| " + name + " | " + fateOf(name) + " |\n";
  return table;
}

TEST(RapidNamesPage, isMadeOfTheListOfNames) {
  const std::string path = test_support::inSourceTree("doc/rapid-names.md");
  std::ifstream file(path);
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string head = "| name | `rapid check` |\n|---|---|\n";
  const std::size_t begin = page.find(head);
  ASSERT_NE(begin, std::string::npos);
  const std::string made = page.substr(0, begin) + head + rows();
  EXPECT_EQ(made.find("| unknown |"), std::string::npos);
  if (std::getenv("COBOT_MAKE_PAGES") != nullptr) {
    std::ofstream(path) << made;
  } else {
    EXPECT_EQ(page, made) << "see the first lines of " << __FILE__;
  }
}

}  // namespace
}  // namespace cobot_command::rapid
