#include "goals/path_points.h"

#include <cstdio>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::Eq;

std::string fileWith(const std::string& text) {
  const std::string name = ::testing::TempDir() + "path_points_test.yaml";
  std::ofstream(name) << text;
  return name;
}

TEST(PathPoints, areCountedInAFile) {
  EXPECT_THAT(countPoints(fileWith("points:\n  - {move_id: 1}\n  - {move_id: 2}\n")), Eq(2));
  EXPECT_THAT(countPoints(fileWith("points: []\n")), Eq(0));
}

TEST(PathPoints, areNotKnownWhereThereIsNoPath) {
  EXPECT_THAT(countPoints(fileWith("points: many\n")), Eq(std::nullopt));
  EXPECT_THAT(countPoints(fileWith("[1, 2]\n")), Eq(std::nullopt));
  EXPECT_THAT(countPoints(fileWith("{\n")), Eq(std::nullopt));
  EXPECT_THAT(countPoints("/no/such/file.yaml"), Eq(std::nullopt));
  EXPECT_THAT(countPoints("package://no_such_package/path.yaml"), Eq(std::nullopt));
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
