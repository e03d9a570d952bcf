// What each item of the status stream is needed for is in one table; doc/real-robot.md says the same.
#include "cobot_command/link/stream_items.h"

#include <regex>
#include <set>

#include "settings_page.h"
#include <gmock/gmock.h>

namespace cobot_command::link {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSubsetOf;

std::string tableOfItems() {
  std::string table = "| item | needed | consequence if it is missing |\n|---|---|---|\n";
  for (const StreamItem& item : streamItems()) {
    const char* needed = item.need == ItemNeed::Ready    ? "always, and to be ready"
                         : item.need == ItemNeed::Always ? "always"
                                                         : "by choice";
    table += "| `" + std::string(item.name) + "` | " + needed + " | " + std::string(item.without) + " |\n";
  }
  return table;
}

/// The names in code quotes between these words of the page.
std::vector<std::string> namesInPage(const std::string& from, const std::string& to) {
  const std::string page = test_support::pageAt("doc/real-robot.md");
  const std::size_t begin = page.find(from);
  const std::size_t end = page.find(to, begin);
  EXPECT_NE(begin, std::string::npos) << from;
  EXPECT_NE(end, std::string::npos) << to;
  const std::string text = page.substr(begin, end - begin);
  std::vector<std::string> names;
  const std::regex item("`([A-Z][A-Za-z]*_[A-Za-z0-9_]+|ESTOP)`");
  for (std::sregex_iterator found(text.begin(), text.end(), item), none; found != none; ++found) {
    names.push_back((*found)[1]);
  }
  return names;
}

std::vector<std::string> namesOfTable(bool by_choice) {
  std::vector<std::string> names;
  for (const StreamItem& item : streamItems()) {
    if ((item.need == ItemNeed::Choice) == by_choice) names.emplace_back(item.name);
  }
  return names;
}

TEST(StreamItems, thatEveryDataTableShouldHaveAreTheListOfThePage) {
  EXPECT_EQ(namesInPage("tick at least", "In addition to these"), namesOfTable(false));
}

TEST(StreamItems, thatThePageLeavesToChoiceAreInTheTable) {
  const auto names = namesInPage("In addition to these", "Run the project");
  EXPECT_FALSE(names.empty());
  EXPECT_THAT(names, IsSubsetOf(namesOfTable(true)));
}

TEST(StreamItems, areTheTableOfThePage) {
  EXPECT_THAT(test_support::pageAt("doc/real-robot.md"), HasSubstr(tableOfItems()))
      << "doc/real-robot.md has to have:\n"
      << tableOfItems();
}

TEST(StreamItems, areEachInTheTableOnce) {
  std::set<std::string_view> names;
  for (const StreamItem& item : streamItems()) {
    EXPECT_TRUE(names.insert(item.name).second) << item.name;
    EXPECT_FALSE(item.without.empty()) << item.name;
  }
}

TEST(StreamItems, withoutWhichNobodyIsReadyAreAPartOfThoseThatAreMissing) {
  RobotStatus status;
  EXPECT_EQ(namesOf(missingForReady(status)),
            "Robot_Error, Project_Run, Project_Pause, Safeguard_A, ESTOP, Joint_Angle");
  EXPECT_EQ(missingItems(status).size(), namesOfTable(false).size());
  status.emergency_stop = false;
  EXPECT_THAT(namesOf(missingItems(status)), ::testing::Not(HasSubstr("ESTOP")));
}

/// The value is wrong, and told as that.
TEST(StreamItems, thatCannotBeReadAreNotMissing) {
  RobotStatus status;
  status.unreadable = {"Joint_Angle"};
  EXPECT_THAT(namesOf(missingItems(status)), ::testing::Not(HasSubstr("Joint_Angle")));
}

}  // namespace
}  // namespace cobot_command::link
