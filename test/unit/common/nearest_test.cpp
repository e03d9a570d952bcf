#include "cobot_command/common/nearest.h"

#include <gtest/gtest.h>

namespace cobot_command {
namespace {

const std::vector<std::string> kKnown{"script_port", "status_port", "prefix", "retry_min", "retry_max"};

TEST(NearestName, isTheOneThatWasMisspelt) {
  EXPECT_EQ(nearestOf("scrip_port", kKnown), "script_port");
  EXPECT_EQ(nearestOf("scritp_port", kKnown), "script_port");
  EXPECT_EQ(nearestOf("script-port", kKnown), "script_port");
  EXPECT_EQ(nearestOf("stauts_prot", kKnown), "status_port");
  EXPECT_EQ(nearestOf("retry_maxx", kKnown), "retry_max");
  EXPECT_EQ(nearestOf("Prefix", kKnown), "prefix");
}

TEST(NearestName, isNoneWhenNothingIsClose) {
  EXPECT_EQ(nearestOf("colour_of_the_arm", kKnown), "");
  EXPECT_EQ(nearestOf("", kKnown), "");
  EXPECT_EQ(nearestOf("x", kKnown), "");
  EXPECT_EQ(nearestOf("script_port", {}), "");
  EXPECT_EQ(nearestOf(std::string(1000000, 'x'), kKnown), "");
}

}  // namespace
}  // namespace cobot_command
