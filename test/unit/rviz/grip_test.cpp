#include "clients/grip.h"

#include "clients/situation.h"
#include <gtest/gtest.h>

namespace cobot_command::rviz_plugin {
namespace {

using std::chrono_literals::operator""ms;

TEST(Grip, holdsFromWhenItIsTakenUntilItIsLetGo) {
  Grip grip;
  const Grip::Time start{};
  EXPECT_FALSE(grip.holds(start));
  grip.take(start);
  EXPECT_TRUE(grip.holds(start));
  grip.letGo();
  EXPECT_FALSE(grip.holds(start));
}

TEST(Grip, holdsNothingWhenTheUserInterfaceHasNotTickedForATenthOfASecond) {
  Grip grip;
  const Grip::Time start{};
  grip.take(start);
  EXPECT_TRUE(grip.holds(start + 100ms));
  EXPECT_FALSE(grip.holds(start + 101ms));
  grip.tick(start + 150ms);
  EXPECT_TRUE(grip.holds(start + 250ms)) << "busy for a moment, and not hanging";
  EXPECT_FALSE(grip.holds(start + 251ms));
}

TEST(Grip, isNotTakenByATickAlone) {
  Grip grip;
  const Grip::Time start{};
  grip.tick(start);
  EXPECT_FALSE(grip.holds(start));
}

TEST(Validity, isOverWhenTheSituationIsAnotherOneThanWhenTheRefusalCame) {
  Validity validity;
  validity.begin();
  const Situation unlinked{1, 0, 0, 0, 0, 0};
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(validity.isOver(unlinked));
  EXPECT_TRUE(validity.isOver({1, 4, 0, 0, 0, 0}));
}

TEST(Validity, takesAStatusThatComesAfterTheRefusalForThatOfTheRefusal) {
  Validity validity;
  validity.begin();
  EXPECT_FALSE(validity.isOver({1, 4, 0, 0, 0, 0}));
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(validity.isOver({1, 4, 1, 0, 0, 0}));
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
