#include "forms/form.h"

#include <limits>

#include "forms/cycle.h"
#include "forms/forms.h"
#include <gmock/gmock.h>

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::ElementsAre;

Form twoFields() {
  return Form({numberField("speed", "Speed", "%", 1, 100, 20), textField("name", "Name", "")}, nullptr,
              {{"slow", {{"speed", 5}}, {{"name", "slow one"}}}});
}

std::vector<int> offered(const Form& form, const std::string& key) {
  std::vector<int> values;
  for (const Option& option : form.field(key).options) values.push_back(option.value);
  return values;
}

TEST(Form, keepsWhatItHasWhereANumberIsOutOfItsRange) {
  Form form = twoFields();
  EXPECT_TRUE(form.set("speed", 100));
  for (const double wrong : {0.0, 101.0, -5.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(form.set("speed", wrong)) << wrong;
  }
  EXPECT_EQ(form.number("speed"), 100);
}

TEST(Form, keepsWhatItHasWhereATextIsTooLong) {
  Form form = twoFields();
  EXPECT_TRUE(form.set("name", std::string(255, 'x')));
  EXPECT_FALSE(form.set("name", std::string(256, 'x')));
  EXPECT_EQ(form.text("name").size(), 255u);
}

TEST(Form, takesNoSixOfWhichOneIsOutOfItsRange) {
  Form form = moveAbsoluteForm();
  const auto before = form.six("target");
  EXPECT_FALSE(form.setSix("target", {1, 2, 3, 4, 5, 1e6}));
  EXPECT_EQ(form.six("target"), before);
}

TEST(Form, putsInAPresetAllAtOnce) {
  Form form = twoFields();
  form.apply(form.presets().front());
  EXPECT_EQ(form.number("speed"), 5);
  EXPECT_EQ(form.text("name"), "slow one");
}

TEST(Form, isRestoredAsItWasSaved) {
  Form form = moveAbsoluteForm();
  form.set("movement_command", 0);
  form.set("data_format", 4);
  form.set("target.1", -123.456);
  form.set("speed_mm_s", 777);
  Form restored = moveAbsoluteForm();
  restored.restore(form.saved());
  EXPECT_EQ(restored.saved(), form.saved());
}

TEST(Form, leavesOutOfASavedConfigurationWhatCannotBe) {
  Form form = twoFields();
  form.restore({{"speed", "1e9"}, {"unknown", "3"}, {"name", "kept"}});
  form.restore({{"speed", "fast"}});
  form.restore({{"speed", "12 km/h"}});
  EXPECT_EQ(form.number("speed"), 20);
  EXPECT_EQ(form.text("name"), "kept");
}

TEST(MoveAbsoluteForm, offersTheFormatsThatTheMotionCanBeGivenIn) {
  Form form = moveAbsoluteForm();
  EXPECT_THAT(offered(form, "data_format"), ElementsAre(0, 1));
  form.set("movement_command", 0);
  EXPECT_THAT(offered(form, "data_format"), ElementsAre(1, 2, 3, 4));
}

TEST(MoveAbsoluteForm, givesUpAFormatThatTheOtherMotionHasNot) {
  Form form = moveAbsoluteForm();
  form.set("data_format", 0);
  form.set("movement_command", 0);
  EXPECT_EQ(form.whole("data_format"), 1);
}

TEST(MoveAbsoluteForm, asksForJointsOrAPoseAsTheFormatSays) {
  Form form = moveAbsoluteForm();
  EXPECT_TRUE(form.field("target.0").shown);
  EXPECT_FALSE(form.field("joints.0").shown);
  form.set("data_format", 0);
  EXPECT_FALSE(form.field("target.0").shown);
  EXPECT_TRUE(form.field("joints.0").shown);
}

TEST(MoveAbsoluteForm, asksForSpeedAndBlendingInTheUnitsOfTheFormat) {
  Form form = moveAbsoluteForm();
  form.set("movement_command", 0);
  form.set("data_format", 4);
  form.set("blending_enable", 1);
  EXPECT_TRUE(form.field("speed_mm_s").shown && form.field("blending_mm").shown);
  EXPECT_FALSE(form.field("speed_percent").shown || form.field("blending_percent").shown);
  form.set("data_format", 1);
  EXPECT_FALSE(form.field("speed_mm_s").shown || form.field("blending_mm").shown);
  EXPECT_TRUE(form.field("speed_percent").shown && form.field("blending_percent").shown);
}

TEST(MoveAbsoluteForm, asksForARobotPoseOfPtpToAPoseAlone) {
  Form form = moveAbsoluteForm();
  form.set("robot_pose_enable", 1);
  EXPECT_TRUE(form.field("config1").shown);
  form.set("data_format", 0);
  EXPECT_FALSE(form.field("robot_pose_enable").shown || form.field("config1").shown);
  form.set("movement_command", 0);
  EXPECT_FALSE(form.field("robot_pose_enable").shown || form.field("config1").shown);
}

TEST(MoveRelativeForm, offersTheFormatsThatTheMotionCanBeGivenIn) {
  Form form = moveRelativeForm();
  EXPECT_THAT(offered(form, "data_format"), ElementsAre(0, 1, 5));
  form.set("movement_command", 0);
  EXPECT_THAT(offered(form, "data_format"), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(ChangeTcpForm, asksForNoNumbersWhereTheProjectKnowsTheTcp) {
  Form form = changeTcpForm();
  form.set("tcp_name", "gripper");
  EXPECT_FALSE(form.field("tcp_offset.0").shown || form.field("weight").shown || form.field("ixx").shown);
  form.set("tcp_name", "");
  EXPECT_TRUE(form.field("tcp_offset.0").shown && form.field("weight").shown && form.field("ixx").shown);
}

TEST(Cycle, hasNoBufferModeOfASingleMove) {
  const Cycle cycle = presetCycle();
  for (const Form& move : cycle.moves) EXPECT_FALSE(move.has("buffer_mode"));
  EXPECT_TRUE(cycle.general.has("buffer_mode"));
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
