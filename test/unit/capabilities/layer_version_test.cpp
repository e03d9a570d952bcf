// The version that is told is the one of the package.

#include "cobot_command/capabilities/layer_version.h"

#include <fstream>
#include <sstream>

#include "source_tree.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::capabilities {
namespace {

TEST(TheVersion, isThatOfThePackage) {
  std::ifstream file(test_support::inSourceTree("package.xml"));
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_THAT(text.str(), ::testing::HasSubstr("<version>" + std::string(layerVersion()) + "</version>"));
  EXPECT_FALSE(layerVersion().empty());
}

}  // namespace
}  // namespace cobot_command::capabilities
