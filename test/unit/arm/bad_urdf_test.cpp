// A model is either an arm of the family or refused with a message that helps; nothing is printed, nothing
// thrown.
#include <limits>
#include <string>

#include "arm_test_support.h"
#include "foreign_bytes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/urdf_prefix.h"

namespace cobot_command::arm {
namespace {

using ::testing::HasSubstr;

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("not in the URDF: " + from);
  return text.replace(at, from.size(), to);
}

struct BadUrdf {
  const char* name;
  std::string from;  ///< the first place of this in the URDF of the TM5-900 ...
  std::string to;    ///< ... is replaced by this
  std::string message_has;
};

class BadUrdfTest : public ::testing::TestWithParam<BadUrdf> {};

const std::vector<BadUrdf> bad_urdfs = {
    {"unknownRobot", "robot name=\"tm5-900\"", "robot name=\"ur5\"", "Known models: tm5-700"},
    {"robotWithoutName", "robot name=\"tm5-900\"", "robot", "name"},
    {"notClosed", "</robot>", "", "This is not a URDF"},
    {"missingJoint", "<joint name=\"shoulder_1_joint\"", "<joint name=\"first\"", "shoulder_1_joint"},
    {"renamedElbow", "<joint name=\"elbow_joint\"", "<joint name=\"knee_joint\"", "\"knee_joint\""},
    {"twoArms", "<joint name=\"elbow_joint\"", "<joint name=\"shoulder_1_joint\"", "shoulder_1_joint"},
    {"fixedElbow", "<joint name=\"elbow_joint\" type=\"revolute\"",
     "<joint name=\"elbow_joint\" type=\"fixed\"", "\"wrist_1_joint\" is where \"elbow_joint\""},
    {"fixedLastJoint", "<joint name=\"wrist_3_joint\" type=\"revolute\"",
     "<joint name=\"wrist_3_joint\" type=\"fixed\"", "5 moving joints"},
    {"seventhJoint", "<joint name=\"flange_fixed_joint\" type=\"fixed\">",
     "<joint name=\"extra\" type=\"continuous\">", "\"extra\" is behind the six"},
    {"slidingElbow", "<joint name=\"elbow_joint\" type=\"revolute\"",
     "<joint name=\"elbow_joint\" type=\"prismatic\"", "not of type \"revolute\""},
    {"endlessElbow", "<joint name=\"elbow_joint\" type=\"revolute\"",
     "<joint name=\"elbow_joint\" type=\"continuous\"", "not of type \"revolute\""},
    {"noSuchType", "<joint name=\"elbow_joint\" type=\"revolute\"",
     "<joint name=\"elbow_joint\" type=\"odd\"", "This is not a URDF"},
    {"noLimit", "<limit lower=\"-2.705260340591211\" upper=\"2.705260340591211\"", "<!-- --><nothing",
     "limit"},
    {"emptyLimit", "lower=\"-2.705260340591211\"", "lower=\"2.705260340591211\"", "the lower must be below"},
    {"limitNotANumber", "lower=\"-2.705260340591211\"", "lower=\"nan\"", "limit"},
    {"limitInfinite", "upper=\"2.705260340591211\"", "upper=\"1e999\"", "limit"},
    {"limitWithComma", "lower=\"-2.705260340591211\"", "lower=\"-2,7\"", "limit"},
    {"speedZero", "velocity=\"3.141592653589793\"", "velocity=\"0\"", "velocity limit"},
    {"speedTiny", "velocity=\"3.141592653589793\"", "velocity=\"1e-300\"",
     "the velocity limit of the joint \"shoulder_1_joint\" is 1e-300 rad/s, but must be 0.01 to 20"},
    {"speedHuge", "velocity=\"3.141592653589793\"", "velocity=\"1e300\"",
     "the velocity limit of the joint \"shoulder_1_joint\" is 1e+300 rad/s, but must be 0.01 to 20"},
    {"speedInDegrees", "velocity=\"3.141592653589793\"", "velocity=\"180\"", "is 180 rad/s, but must be"},
    {"limitHuge", "upper=\"2.705260340591211\"", "upper=\"1e300\"", "to 1e+300 rad, but the lower must be"},
    {"limitInDegrees", "upper=\"2.705260340591211\"", "upper=\"155\"", "both between -100 and 100"},
    {"massHuge", "<mass value=\"4.032\"", "<mass value=\"1e300\"", "has 1e+300 kg at"},
    {"massNegative", "<mass value=\"4.032\"", "<mass value=\"-4.032\"", "must have 0 to 1000 kg"},
    {"massNotANumber", "<mass value=\"4.032\"", "<mass value=\"nan\"", "mass"},
    {"massMissing", "<mass value=\"4.032\"/>", "", "mass"},
    {"collisionNotANumber", "<collision><origin xyz=\"0.21015 0", "<collision><origin xyz=\"x 0",
     "This is not a URDF"},
    {"massFarAway", "<origin xyz=\"0 0 -0.02\" rpy=\"0 0 0\"/><mass",
     "<origin xyz=\"0 0 -20\" rpy=\"0 0 0\"/><mass", "Correct its <inertial>"},
    {"lengthInMillimetres", "<origin xyz=\"0.429 0 0\"", "<origin xyz=\"429 0 0\"",
     "A length of the arm is 429 m, but at most 10 m"},
    {"anotherRobotBehind", "</robot>", "</robot><robot name=\"tm12\"/>",
     "it has 2 outermost elements, but must have one, <robot>"},
    {"textBehind", "</robot>", "</robot>more", ""},
    {"nameOfABytes", "<joint name=\"elbow_joint\"", "<joint name=\"\x1b[31m\xff\"", "\\x1B[31m\\xFF"},
    {"speedNegative", "velocity=\"3.141592653589793\"", "velocity=\"-1\"", "velocity limit"},
    {"originNotANumber", "<origin xyz=\"0 0 0.1452\"", "<origin xyz=\"0 0 nan\"", ""},
    {"originTooLarge", "<origin xyz=\"0 0 0.1452\"", "<origin xyz=\"0 0 1e308\"", ""},
    {"originOverflows", "<origin xyz=\"0 0 0.1452\"", "<origin xyz=\"0 0 1e999\"", ""},
    {"originWithTwoNumbers", "<origin xyz=\"0 0 0.1452\"", "<origin xyz=\"0 0\"", "This is not a URDF"},
    {"noAxis", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 0\"/>", ""},
    {"turnedAxis", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 -1\"/>", "The axis of joint 1"},
    {"tiltedAxis", "<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0.00001 1\"/>", "The axis of joint 1"},
    {"shoulderAside", "<origin xyz=\"0 0 0.1452\"", "<origin xyz=\"0 0.00001 0.1452\"", "1e-05 m"},
    {"elbowAside", "<origin xyz=\"0.429 0 0\"", "<origin xyz=\"0.429 0.001 0\"", "The axis of joint 3"},
    {"wristTurned", "<origin xyz=\"0.4115 0 -0.1223\" rpy=\"0 0 1.5707963267948966\"",
     "<origin xyz=\"0.4115 0 -0.1223\" rpy=\"0 0 1.57079\"", "The axis of joint 5"},
    {"wristAside", "<origin xyz=\"0 -0.106 0\"", "<origin xyz=\"0.00001 -0.106 0\"", "The axis of joint 5"},
    {"flangeTurned", "<parent link=\"link_6\"/>", "<parent link=\"link_6\"/><origin rpy=\"0 0 0.001\"/>",
     "The flange"},
    {"flangeAside", "<parent link=\"link_6\"/>", "<parent link=\"link_6\"/><origin xyz=\"0.001 0 0\"/>",
     "The flange"},
    {"leftHanded", "<origin xyz=\"0.4115 0 -0.1223\"", "<origin xyz=\"0.4115 0 0.1223\"", "d4 = 0.1223"},
    {"noUpperArm", "<origin xyz=\"0.429 0 0\"", "<origin xyz=\"0 0 0\"", "a2 = 0"},
    {"noBase", "<parent link=\"base\"/>", "<parent link=\"table\"/>", "This is not a URDF"},
    {"baseOfAnotherName", "<link name=\"base\"/>", "<link name=\"base\"/><link name=\"base\"/>", "base"},
};

INSTANTIATE_TEST_SUITE_P(Of, BadUrdfTest, ::testing::ValuesIn(bad_urdfs),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST_P(BadUrdfTest, isRefusedWithAHelpfulMessageAndWithoutAWordOnTheConsole) {
  const std::string urdf = replaced(ArmModel::urdfOf("tm5-900"), GetParam().from, GetParam().to);
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const auto refused = ArmModel::fromUrdf(urdf);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr(GetParam().message_has));
  // A whole sentence that ends with what to do.
  EXPECT_EQ(refused.error().message.back(), '.');
  EXPECT_GT(refused.error().message.size(), 40U);
}

TEST(Urdf, thatIsNoUrdfAtAllIsRefused) {
  for (const std::string& text :
       {std::string(), std::string(" \n"), std::string("tm5-900"), std::string("<robot/>"),
        std::string("<robot name=\"tm5-900\"/>"), std::string("<html></html>"),
        std::string("<robot name=\"tm5-900\"><link name=\"base\"/>"), std::string("\0\xff\xfe", 3),
        std::string(100000, '<')}) {
    const auto refused = ArmModel::fromUrdf(text);
    ASSERT_FALSE(refused) << text.substr(0, 100);
    EXPECT_THAT(refused.error().message, HasSubstr("URDF"));
  }
}

TEST(Urdf, thatIsThereTwiceIsRefused) {
  const std::string& urdf = ArmModel::urdfOf("tm5-900");
  const auto refused = ArmModel::fromUrdf(urdf + urdf);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("This is not a URDF: "));
  EXPECT_FALSE(ArmModel::fromUrdf(urdf + '\0' + urdf));
  EXPECT_FALSE(withPrefix(urdf + urdf, "left_"));
  EXPECT_TRUE(ArmModel::fromUrdf(urdf + "<!-- a comment -->\n"));
}

TEST(Urdf, isRefusedWithoutHarmWhateverBytesItHas) {
  for (const std::string& text : test_support::foreignTexts()) {
    for (const char* place : {"robot name=\"tm5-900", "joint name=\"elbow_joint",
                              "joint name=\"shoulder_1_joint", "link name=\"link_2", "link name=\"base",
                              "child link=\"link_3", "type=\"revolute", "xyz=\"0 0 0.1452"}) {
      const std::string whole = place;
      const std::string urdf =
          replaced(ArmModel::urdfOf("tm5-900"), whole, whole.substr(0, whole.find('"') + 1) + text);
      const auto arm = ArmModel::fromUrdf(urdf);
      if (!arm) {
        EXPECT_THAT(arm.error().message, test_support::IsHarmless());
      }
      const auto prefixed = withPrefix(urdf, text);
      if (!prefixed) {
        EXPECT_THAT(prefixed.error().message, test_support::IsHarmless());
      }
    }
    const auto named = ArmModel::named(text);
    EXPECT_THAT(named.error().message, test_support::IsHarmless());
    EXPECT_THAT(ArmModel::fromUrdf(text).error().message, test_support::IsHarmless());
  }
}

TEST(Urdf, everyPrefixOfTheTextIsRefused) {
  const std::string& urdf = ArmModel::urdfOf("tm5-900");
  const std::size_t complete = urdf.rfind("</robot>") + std::string("</robot>").size();
  for (std::size_t size = 0; size < complete; size += 37) {
    EXPECT_FALSE(ArmModel::fromUrdf(urdf.substr(0, size))) << size;
  }
  EXPECT_TRUE(ArmModel::fromUrdf(urdf.substr(0, complete)));
}

TEST(Urdf, aRingOfLinksBesideTheTreeIsRefused) {
  std::string urdf = ArmModel::urdfOf("tm5-900");
  urdf = replaced(urdf, "<parent link=\"base\"/><child link=\"link_0\"/>",
                  "<parent link=\"tool0\"/><child link=\"link_0\"/>");
  const auto refused = ArmModel::fromUrdf(urdf);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("no chain of joints"));
}

TEST(Urdf, mayHaveAColourThatIsNotDefined) {
  const auto arm = ArmModel::fromUrdf(
      replaced(ArmModel::urdfOf("tm5-900"),
               "<material name=\"white\"><color rgba=\"0.93 0.93 0.92 1\"/></material>", ""));
  EXPECT_TRUE(arm) << arm.error().message;
}

TEST(Urdf, otherLengthsMakeAnotherArmOfTheFamily) {
  const std::string urdf =
      replaced(ArmModel::urdfOf("tm5-900"), "<origin xyz=\"0.429 0 0\"", "<origin xyz=\"0.4295 0 0\"");
  const auto arm = ArmModel::fromUrdf(urdf);
  ASSERT_TRUE(arm);
  EXPECT_NEAR(arm->lengths().a2, 0.4295, 1e-12);
  const Pose flange = forwardKinematics(*arm, toJointVector({30, -20, 100, 10, 80, -45}));
  EXPECT_LT(worstPoseError(*arm, allBranches(*arm, flange), flange), 1e-12);
}

TEST(Urdf, anOriginMayMoveAlongItsAxis) {
  const std::string urdf = replaced(
      replaced(ArmModel::urdfOf("tm5-900"), "<origin xyz=\"0.429 0 0\"", "<origin xyz=\"0.429 0 -0.12\""),
      "<origin xyz=\"0.4115 0 -0.1223\"", "<origin xyz=\"0.4115 0 -0.0023\"");
  const auto arm = ArmModel::fromUrdf(urdf);
  ASSERT_TRUE(arm);
  EXPECT_NEAR(arm->lengths().d4, -0.1223, 1e-12);
}

}  // namespace
}  // namespace cobot_command::arm
