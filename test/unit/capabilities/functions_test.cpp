// What is offered, and why something is not.

#include "cobot_command/capabilities/functions.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::capabilities {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

const Function& called(std::string_view srci) {
  const auto& all = functions();
  const auto found =
      std::find_if(all.begin(), all.end(), [srci](const Function& one) { return one.srci == srci; });
  EXPECT_NE(found, all.end()) << srci;
  return *found;
}

TEST(Functions, haveANameEachOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Function& function : functions()) {
    EXPECT_TRUE(names.insert(function.srci).second) << function.srci;
  }
}

TEST(Functions, haveAnInterfaceExactlyWhereTheyAreOffered) {
  for (const Function& function : functions()) {
    EXPECT_EQ(function.ours.empty(), !supportOf(function, true).offered) << function.srci;
  }
}

TEST(Functions, sayWhyTheyAreNotOfferedOrWhatIsMissing) {
  for (const Function& function : functions()) {
    const bool is_whole = function.offer == Offer::Whole;
    EXPECT_EQ(supportOf(function, true).reason.empty(), is_whole) << function.srci;
  }
  EXPECT_THAT(supportOf(called("GroupReset"), true).reason, HasSubstr("error of the controller"));
}

TEST(Functions, thatNeedTheArmAreNotOfferedWithoutIt) {
  EXPECT_TRUE(supportOf(called("CalculateInverseKinematic"), true).offered);
  const Support without = supportOf(called("CalculateInverseKinematic"), false);
  EXPECT_FALSE(without.offered);
  EXPECT_THAT(without.reason, HasSubstr("~robot_model"));
  EXPECT_TRUE(supportOf(called("MoveLinearAbsolute"), false).offered) << "it is sent without a plan";
}

TEST(Functions, ofWhichNoControllerHasAnyAreNamedWithTheirReasons) {
  const auto names = beyondTheController();
  EXPECT_THAT(names, Contains(HasSubstr("brake test: ")));
  EXPECT_THAT(names, Contains(HasSubstr("on the pendant")));
  for (const std::string& name : names) EXPECT_THAT(name, ::testing::Not(HasSubstr("Group")));
}

}  // namespace
}  // namespace cobot_command::capabilities
