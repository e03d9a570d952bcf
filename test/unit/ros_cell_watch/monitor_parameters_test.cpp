// Parameters of the cell's monitor: what cannot be used is refused by name, and the page has them all.
#include "cobot_command/ros/cell_watch/monitor_parameters.h"

#include <limits>
#include <string>

#include "settings_page.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Mode = cell::MonitorSettings::Mode;

/// With a cell file, unless one is given.
GivenParameters given(GivenValues values) {
  values.emplace("cell_file", Given{"/cells/a.yaml"});
  return {"/cell/cell_monitor", std::move(values), std::nullopt};
}
std::string refusal(const GivenValues& values) {
  const auto parameters = readMonitorParameters(given(values));
  return parameters ? "" : parameters.error().message;
}

TEST(ParametersOfTheMonitor, stopAtHalfOfTheMarginUnlessTheySayOtherwise) {
  const auto parameters = readMonitorParameters(given({}));
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->cell_file, "/cells/a.yaml");
  EXPECT_EQ(parameters->mode, Mode::Stop);
  EXPECT_EQ(parameters->stop_distance, std::nullopt);
  EXPECT_TRUE(parameters->publish_frames);
  EXPECT_THAT(parameters->warnings, IsEmpty());
}

TEST(ParametersOfTheMonitor, takeADistanceAndTheModeThatOnlyWarns) {
  const auto parameters = readMonitorParameters(given({{"stop_distance", {0.015}}, {"mode", {"warn"}}}));
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->stop_distance, 0.015);
  EXPECT_EQ(parameters->mode, Mode::Warn);
  const auto half = readMonitorParameters(given({{"stop_distance", {-1}}}));
  ASSERT_TRUE(half);
  EXPECT_EQ(half->stop_distance, std::nullopt);
}

TEST(ParametersOfTheMonitor, thatCannotBeUsedAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Given& bad : {Given{0.3}, Given{-0.5}, Given{nan}, Given{"10 mm"}, Given{true}}) {
    EXPECT_THAT(refusal({{"stop_distance", bad}}), HasSubstr("parameter /cell/cell_monitor/stop_distance "));
    EXPECT_THAT(refusal({{"stop_distance", bad}}), HasSubstr("0 to 0.2, or -1")) << describe(bad);
  }
  EXPECT_THAT(refusal({{"mode", {"log"}}}), HasSubstr("allowed: stop or warn"));
  EXPECT_THAT(refusal({{"mode", {5}}}), HasSubstr("/cell/cell_monitor/mode "));
  EXPECT_THAT(refusal({{"artifact", {"a.artifact"}}}), HasSubstr("an absolute path"));
  EXPECT_THAT(refusal({{"publish_frames", {"yes"}}}), HasSubstr("/cell/cell_monitor/publish_frames "));
  EXPECT_THAT(refusal({{"diagnostic_period", {0}}}), HasSubstr("0.1 to 3600"));
}

TEST(ParametersOfTheMonitor, needAFileOfACell) {
  const auto none = readMonitorParameters({"/cell/cell_monitor", {}, std::nullopt});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("parameter /cell/cell_monitor/cell_file is empty"));
  const auto relative = readMonitorParameters({"/m", {{"cell_file", {"cell.yaml"}}}, std::nullopt});
  ASSERT_FALSE(relative);
  EXPECT_THAT(relative.error().message, HasSubstr("an absolute path"));
}

TEST(ParametersOfTheMonitor, thatItDoesNotHaveAreNamedInAWarning) {
  const auto parameters = readMonitorParameters(given({{"stop_distanse", {0.01}}}));
  ASSERT_TRUE(parameters);
  EXPECT_THAT(parameters->warnings, ElementsAre(HasSubstr("stop_distanse")));
}

TEST(ParametersOfTheMonitor, areTheTableOfThePage) {
  MonitorParameters parameters;
  const std::string table = test_support::tableOf(settingsTable(parameters), false);
  EXPECT_NE(test_support::pageAt("doc/parameters.md").find("\n\n" + table + '\n'), std::string::npos)
      << "doc/parameters.md has to have this table:\n"
      << table;
}

}  // namespace
}  // namespace cobot_command::ros_adapter
