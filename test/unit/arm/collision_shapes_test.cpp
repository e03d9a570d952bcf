#include "cobot_command/arm/collision_shapes.h"

#include "arm_test_support.h"
#include "foreign_bytes.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/urdf_prefix.h"

namespace cobot_command::arm {
namespace {

using ::testing::HasSubstr;

std::string urdfWith(const std::string& more) {
  std::string text = ArmModel::urdfOf("tm5-900");
  return text.insert(text.rfind("</robot>"), more);
}

std::string linkOf(const std::string& geometry) {
  return R"(<link name="camera"><collision><origin xyz="0 0 0.1"/><geometry>)" + geometry +
         "</geometry></collision></link>";
}

std::string jointOf(const std::string& type, const std::string& parent = "link_3") {
  return R"(<joint name="camera_joint" type=")" + type + R"("><parent link=")" + parent +
         R"("/><child link="camera"/><origin xyz="1 0 0" rpy="0 0 1.5707963267948966"/>)"
         R"(<axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>)";
}

std::string refusalOf(const std::string& urdf) {
  const auto shapes = collisionShapes(urdf);
  return shapes ? "" : shapes.error().message;
}

TEST(CollisionShapes, ofEachModelAreOnAllOfItsLinks) {
  for (const std::string& name : ArmModel::knownNames()) {
    const auto shapes = collisionShapes(ArmModel::urdfOf(name));
    ASSERT_TRUE(shapes) << shapes.error().message;
    EXPECT_EQ(shapes->size(), 17u);
    std::array<int, 7> on_link{};
    for (const CollisionShape& shape : *shapes) {
      ++on_link.at(shape.link);
      EXPECT_EQ(shape.link_name, "link_" + std::to_string(shape.link));
    }
    EXPECT_EQ(on_link, (std::array<int, 7>{2, 2, 3, 3, 2, 2, 3}));
  }
}

TEST(CollisionShapes, areWhereTheUrdfHasThem) {
  const auto shapes = collisionShapes(ArmModel::urdfOf("tm5-900"));
  ASSERT_TRUE(shapes);
  const CollisionShape& camera = shapes->back();
  EXPECT_EQ(std::get<CollisionBox>(camera.kind).size, Eigen::Vector3d(0.046, 0.044, 0.036));
  EXPECT_EQ(camera.at.translation(), Eigen::Vector3d(0, 0.059, -0.034));
  const CollisionShape& tube = (*shapes)[5];
  EXPECT_EQ(tube.link, 2u);
  EXPECT_EQ(std::get<CollisionCylinder>(tube.kind).length, 0.371);
  EXPECT_LT((tube.at.linear().col(2) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(CollisionShapes, withAPrefixAreTheSame) {
  const auto urdf = withPrefix(ArmModel::urdfOf("tm12"), "left_");
  ASSERT_TRUE(urdf);
  const auto shapes = collisionShapes(*urdf);
  ASSERT_TRUE(shapes) << shapes.error().message;
  EXPECT_EQ(shapes->size(), 17u);
  EXPECT_EQ(shapes->front().link_name, "left_link_0");
}

TEST(CollisionShapes, ofWhatIsFixedToALinkMoveWithIt) {
  const auto shapes = collisionShapes(urdfWith(linkOf(R"(<sphere radius="0.2"/>)") + jointOf("fixed")));
  ASSERT_TRUE(shapes) << shapes.error().message;
  const CollisionShape& camera = shapes->front();
  EXPECT_EQ(camera.link_name, "camera");
  EXPECT_EQ(camera.link, 3u);
  EXPECT_EQ(std::get<CollisionSphere>(camera.kind).radius, 0.2);
  EXPECT_LT((camera.at.translation() - Eigen::Vector3d(1, 0, 0.1)).norm(), 1e-12);
  EXPECT_LT((camera.at.linear().col(0) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

TEST(CollisionShapes, ofWhatIsFixedToTheFlangeAreInTheLastLink) {
  const auto shapes =
      collisionShapes(urdfWith(linkOf(R"(<sphere radius="0.2"/>)") + jointOf("fixed", "tool0")));
  ASSERT_TRUE(shapes) << shapes.error().message;
  EXPECT_EQ(shapes->front().link, 6u);
}

TEST(CollisionShapes, areRefusedWhereTheyAreMeshes) {
  const std::string mesh = R"(<mesh filename="package://tm/camera.stl"/>)";
  EXPECT_THAT(
      refusalOf(urdfWith(linkOf(mesh) + jointOf("fixed"))),
      ::testing::AllOf(HasSubstr("\"camera\""), HasSubstr("camera.stl"), HasSubstr("Cover it by boxes")));
}

TEST(CollisionShapes, areRefusedWhereTheyMoveByThemselves) {
  EXPECT_THAT(refusalOf(urdfWith(linkOf(R"(<sphere radius="0.2"/>)") + jointOf("revolute"))),
              HasSubstr("not fixed to a link of the arm"));
}

TEST(CollisionShapes, areRefusedWhereALengthIsNone) {
  for (const char* geometry :
       {R"(<sphere radius="-1"/>)", R"(<sphere radius="0"/>)", R"(<sphere radius="1e300"/>)",
        R"(<box size="1 0 1"/>)", R"(<cylinder radius="1" length="-1"/>)"}) {
    EXPECT_THAT(refusalOf(urdfWith(linkOf(geometry) + jointOf("fixed"))), HasSubstr("camera")) << geometry;
  }
}

TEST(CollisionShapes, areRefusedWithoutHarmWhateverBytesTheyHave) {
  for (const std::string& text : test_support::foreignTexts()) {
    EXPECT_THAT(refusalOf(urdfWith(linkOf("<mesh filename=\"" + text + "\"/>") + jointOf("fixed"))),
                test_support::IsHarmless());
    EXPECT_THAT(refusalOf(urdfWith(linkOf("<sphere radius=\"" + text + "\"/>") + jointOf("fixed"))),
                test_support::IsHarmless());
  }
}

TEST(CollisionShapes, areRefusedWhereTheTextIsNoUrdf) {
  EXPECT_THAT(refusalOf("<robot"), HasSubstr("This is not a URDF"));
}

}  // namespace
}  // namespace cobot_command::arm
