// The one table of the simulated controller: what its programs can be told, and what does not fit together.
#include "cobot_command/runtime/simulation/simulator_setup.h"

#include <limits>
#include <set>

#include "settings_page.h"
#include <gmock/gmock.h>

namespace cobot_command::runtime {
namespace {

using ::testing::HasSubstr;

/// "setting found" of the first fault; "" when there is none.
std::string faultOf(const GivenValues& values) {
  SimulatorSetup setup;
  auto fault = take(settingsTable(setup), values);
  if (!fault) fault = faultIn(setup, arm::ArmModel::named("tm5-900").value());
  return fault ? fault->setting + ' ' + describe(*fault) : "";
}

TEST(SimulatorSetup, isTheTableOfThePage) {
  SimulatorSetup setup;
  const std::string table = test_support::tableOf(settingsTable(setup), true);
  EXPECT_NE(test_support::pageAt("doc/simulator.md").find("\n\n" + table + '\n'), std::string::npos)
      << "doc/simulator.md has to have this table:\n"
      << table;
}

TEST(SimulatorSetup, namesEachSettingAndEachOptionOnce) {
  SimulatorSetup setup;
  std::set<std::string> names;
  std::set<std::string> options;
  for (const Setting& setting : settingsTable(setup)) {
    EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    EXPECT_TRUE(options.insert(optionOf(setting)).second) << optionOf(setting);
    EXPECT_TRUE(options.insert(longOptionOf(setting)).second || optionOf(setting) == longOptionOf(setting));
    EXPECT_FALSE(setting.meaning.empty()) << setting.name;
  }
}

TEST(SimulatorSetup, canAllBeSet) {
  SimulatorSetup setup;
  const auto fault = take(settingsTable(setup), {{"robot_model", {"tm12"}},
                                                 {"bind_address", {"0.0.0.0"}},
                                                 {"script_port", {1}},
                                                 {"status_port", {2}},
                                                 {"time_scale", {2.5}},
                                                 {"project_name", {"Cell"}},
                                                 {"log_traffic", {true}}});
  ASSERT_FALSE(fault) << describe(*fault);
  // Whoever adds a member has to count it here, and so finds the table. Period and telling of states are the
  // node's own.
  const auto& [address, script_port, status_port, scale, state_period, tells_states] = setup.options;
  const auto& [model, settings, options, log_traffic] = setup;
  EXPECT_EQ(model, "tm12");
  EXPECT_EQ(address, "0.0.0.0");
  EXPECT_EQ(script_port, 1);
  EXPECT_EQ(status_port, 2);
  EXPECT_EQ(scale, 2.5);
  EXPECT_EQ(state_period, Duration::zero());
  EXPECT_TRUE(tells_states);
  EXPECT_EQ(settings.project_name, "Cell");
  EXPECT_TRUE(log_traffic);
}

TEST(SimulatorSetup, takesMaxAsATimeScale) {
  SimulatorSetup setup;
  EXPECT_EQ(take(settingsTable(setup), {{"time_scale", {"max"}}}), std::nullopt);
  EXPECT_EQ(setup.options.time_scale, kAsFastAsPossible);
}

TEST(SimulatorSetup, isRefusedByName) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faultOf({}), "");
  EXPECT_THAT(faultOf({{"robot_model", {"tm99"}}}),
              HasSubstr("robot_model is the text \"tm99\"; allowed: tm5-700, tm5-900"));
  EXPECT_THAT(faultOf({{"bind_address", {""}}}), HasSubstr("bind_address is an empty text"));
  EXPECT_THAT(faultOf({{"bind_address", {"a b"}}}), HasSubstr("bind_address is the text \"a b\""));
  EXPECT_THAT(faultOf({{"script_port", {5890.7}}}), HasSubstr("script_port is 5890.7"));
  for (const Given& given :
       {Given{"fast"}, Given{-1}, Given{0}, Given{0.0}, Given{kNan}, Given{0.001}, Given{101}, Given{""}}) {
    EXPECT_THAT(faultOf({{"time_scale", given}}), HasSubstr("allowed: a number, 0.01 to 100, or max"));
  }
  EXPECT_THAT(faultOf({{"script_port", {7000}}, {"status_port", {7000}}}),
              HasSubstr("status_port is 7000, the same as script_port"));
  EXPECT_EQ(faultOf({{"script_port", {0}}, {"status_port", {0}}}), "");
}

}  // namespace
}  // namespace cobot_command::runtime
