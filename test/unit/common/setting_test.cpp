// Tables of settings: what is given to them, and how they are named.
#include "cobot_command/common/setting.h"

#include <gmock/gmock.h>

#include "cobot_command/common/setting_kinds.h"

namespace cobot_command {
namespace {

using namespace setting_kinds;
using ::testing::ElementsAre;
using Form = SettingKind::Form;

struct Machine {
  int port = 1;
  bool is_on = true;
  bool is_loud = false;
  std::vector<std::string> names;
};

SettingTable tableOf(Machine& machine) {
  return {{"main_port", setting_kinds::port(machine.port), "where it listens"},
          {"is_on", flag(machine.is_on), "runs at the start", "any-start"},
          {"may_rest", flag(machine.is_on), "the same under another name"},
          {"is_loud", flag(machine.is_loud), "rings"}};
}

TEST(SettingTable, takesWhatIsGivenAndLeavesTheRest) {
  Machine machine;
  EXPECT_EQ(take(tableOf(machine), {{"main_port", {7}}, {"other", {1}}}), std::nullopt);
  EXPECT_EQ(machine.port, 7);
  EXPECT_TRUE(machine.is_on);
}

TEST(SettingTable, tellsTheFirstFaultByName) {
  Machine machine;
  const auto fault = take(tableOf(machine), {{"main_port", {7.5}}, {"is_on", {1}}});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->setting, "main_port");
  EXPECT_EQ(describe(*fault), "is 7.5; allowed: a whole number, 0 to 65535");
}

TEST(SettingTable, knowsItsNames) {
  Machine machine;
  const auto unknown =
      unknownSettings(tableOf(machine), {{"main_prot", {7}}, {"is_on", {true}}, {"zebra", {1}}});
  ASSERT_EQ(unknown.size(), 2U);
  EXPECT_EQ(unknown[0].name, "main_prot");
  EXPECT_EQ(unknown[0].meant, "main_port");
  EXPECT_EQ(unknown[1].name, "zebra");
  EXPECT_EQ(unknown[1].meant, "");
}

TEST(SettingTable, namesItsOptions) {
  Machine machine;
  std::vector<std::string> options;
  for (const Setting& setting : tableOf(machine)) options.push_back(optionOf(setting));
  EXPECT_THAT(options, ElementsAre("--main-port", "--any-start", "--no-may-rest", "--is-loud"));
  EXPECT_EQ(longOptionOf(tableOf(machine)[1]), "--is-on");
}

TEST(WordsOfAnOption, areWhatTheFormMakesOfThem) {
  EXPECT_EQ(std::get<int>(givenBy({"5"}, Form::Number).value), 5);
  EXPECT_EQ(std::get<double>(givenBy({"5.5"}, Form::Number).value), 5.5);
  EXPECT_EQ(std::get<double>(givenBy({"99999999999"}, Form::Number).value), 99999999999.0);
  for (const char* word : {"five", "", "5x", "1e999", "0x10", " 5"}) {
    EXPECT_EQ(std::get<std::string>(givenBy({word}, Form::Number).value), word);
  }
  EXPECT_EQ(std::get<std::string>(givenBy({"5"}, Form::Text).value), "5");
  EXPECT_EQ(std::get<bool>(givenBy({"false"}, Form::Flag).value), false);
  EXPECT_EQ(std::get<std::string>(givenBy({"no"}, Form::Flag).value), "no");
}

TEST(WordsOfAnOption, areLists) {
  const auto numbers = std::get<GivenList>(givenBy({"0, 1.5,-90,,x "}, Form::Numbers).value);
  ASSERT_EQ(numbers.size(), 5U);
  EXPECT_EQ(std::get<int>(numbers[0].value), 0);
  EXPECT_EQ(std::get<double>(numbers[1].value), 1.5);
  EXPECT_EQ(std::get<int>(numbers[2].value), -90);
  EXPECT_EQ(std::get<std::string>(numbers[3].value), "");
  EXPECT_EQ(std::get<std::string>(numbers[4].value), "x");
  const auto texts = std::get<GivenList>(givenBy({"a=1,2", "b"}, Form::Texts).value);
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(std::get<std::string>(texts[0].value), "a=1,2");
}

}  // namespace
}  // namespace cobot_command
