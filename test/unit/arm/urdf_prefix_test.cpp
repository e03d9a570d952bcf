#include "cobot_command/arm/urdf_prefix.h"

#include "arm_test_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

namespace cobot_command::arm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(UrdfPrefix, standsBeforeEveryLinkAndJoint) {
  for (const std::string& name : ArmModel::knownNames()) {
    const auto text = withPrefix(ArmModel::urdfOf(name), "left_");
    ASSERT_TRUE(text);
    const auto urdf = urdf::parseURDF(*text);
    ASSERT_NE(urdf, nullptr);
    EXPECT_EQ(urdf->getName(), name);
    EXPECT_EQ(urdf->links_.size(), 10U);
    EXPECT_EQ(urdf->joints_.size(), 9U);
    for (const auto& [link, unused] : urdf->links_) EXPECT_EQ(link.rfind("left_", 0), 0U) << link;
    for (const auto& [joint, unused] : urdf->joints_) EXPECT_EQ(joint.rfind("left_", 0), 0U) << joint;
  }
}

TEST(UrdfPrefix, leavesTheArmWhatItIs) {
  const ArmModel plain = model("tm12");
  const auto prefixed = ArmModel::fromUrdf(*withPrefix(ArmModel::urdfOf("tm12"), "cell_2/left_"));
  ASSERT_TRUE(prefixed);
  EXPECT_EQ(prefixed->name(), "tm12");
  EXPECT_EQ(prefixed->jointNames()[2], "cell_2/left_elbow_joint");
  const JointVector joints = toJointVector({30, -20, 100, 10, 80, -45});
  EXPECT_EQ(difference(forwardKinematics(*prefixed, joints), forwardKinematics(plain, joints)), 0);
}

TEST(UrdfPrefix, thatIsEmptyChangesNoName) {
  const auto text = withPrefix(ArmModel::urdfOf("tm5-900"), "");
  ASSERT_TRUE(text);
  EXPECT_TRUE(ArmModel::fromUrdf(*text));
  EXPECT_THAT(*text, HasSubstr("<link name=\"link_0\">"));
}

TEST(UrdfPrefix, followsTheNamesIntoTransmissionsMimicsAndGazeboButNotIntoMaterials) {
  const std::string urdf = R"(<robot name="r"><material name="white"/><link name="a"/>
    <joint name="j"><parent link="a"/><child link="b"/><mimic joint="k"/></joint>
    <transmission name="t"><joint name="j"/><actuator name="m"/></transmission>
    <gazebo reference="a"/><gazebo/></robot>)";
  const auto text = withPrefix(urdf, "x_");
  ASSERT_TRUE(text);
  for (const char* expected :
       {"<robot name=\"r\"", "material name=\"white\"", "link name=\"x_a\"", "joint name=\"x_j\"",
        "parent link=\"x_a\"", "child link=\"x_b\"", "mimic joint=\"x_k\"", "transmission name=\"x_t\"",
        "actuator name=\"x_m\"", "gazebo reference=\"x_a\""}) {
    EXPECT_THAT(*text, HasSubstr(expected));
  }
  EXPECT_THAT(*text, Not(HasSubstr("x_x_")));
}

TEST(UrdfPrefix, isRefusedWhenNoNameMayBeginSo) {
  for (const char* prefix : {"\"<&", "/x", "a b", "\xc3\xa4"}) {
    const auto refused = withPrefix("<robot name=\"r\"><link name=\"a\"/></robot>", prefix);
    ASSERT_FALSE(refused) << prefix;
    EXPECT_THAT(refused.error().message, HasSubstr("Allowed are letters"));
  }
}

TEST(UrdfPrefix, refusesWhatIsNoUrdf) {
  for (const char* text : {"", "<robot>", "<html/>", "no xml"}) {
    const auto refused = withPrefix(text, "left_");
    ASSERT_FALSE(refused) << text;
    EXPECT_THAT(refused.error().message, HasSubstr("not a URDF"));
  }
}

}  // namespace
}  // namespace cobot_command::arm
