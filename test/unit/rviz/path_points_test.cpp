#include "goals/path_points.h"

#include <string>

#include "own_folder.h"
#include <gmock/gmock.h>

namespace cobot_command::rviz_plugin {
namespace {

using ::testing::Eq;

class PathPoints : public ::testing::Test {
 protected:
  [[nodiscard]] std::string fileWith(const std::string& text) const {
    return folder_.file("path.yaml", text);
  }

 private:
  ros_adapter::OwnFolder folder_;
};

TEST_F(PathPoints, areCountedInAFile) {
  EXPECT_THAT(countPoints(fileWith("points:\n  - {move_id: 1}\n  - {move_id: 2}\n")), Eq(2));
  EXPECT_THAT(countPoints(fileWith("points: []\n")), Eq(0));
}

TEST_F(PathPoints, areNotKnownWhereThereIsNoPath) {
  EXPECT_THAT(countPoints(fileWith("points: many\n")), Eq(std::nullopt));
  EXPECT_THAT(countPoints(fileWith("[1, 2]\n")), Eq(std::nullopt));
  EXPECT_THAT(countPoints(fileWith("{\n")), Eq(std::nullopt));
  EXPECT_THAT(countPoints("/no/such/file.yaml"), Eq(std::nullopt));
  EXPECT_THAT(countPoints("package://no_such_package/path.yaml"), Eq(std::nullopt));
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
