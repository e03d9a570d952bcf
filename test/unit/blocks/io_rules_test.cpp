// What set_output and change_load take, and what they send.

#include "block_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

constexpr int kAnalog = static_cast<int>(OutputKind::Analog);

TEST(SetOutput, isALineThatTheControllerQueuesOrCarriesOutAtOnce) {
  EXPECT_EQ(scriptOf(good<SetOutputGoal>()), "IO[\"EndModule\"].DO[2]=1");
  EXPECT_EQ(scriptOf(SetOutputGoal{0, "ControlBox", 15, 0, true}), "IO[\"ControlBox\"].InstantDO[15]=0");
  EXPECT_EQ(scriptOf(SetOutputGoal{kAnalog, "ControlBox", 0, 3.3}), "IO[\"ControlBox\"].AO[0]=3.3");
  EXPECT_EQ(scriptOf(SetOutputGoal{kAnalog, "ControlBox", 0, -10, true}),
            "IO[\"ControlBox\"].InstantAO[0]=-10");
}

TEST(SetOutput, goesBesideWhateverIsUnderWayWhenItIsToBeAtOnce) {
  EXPECT_EQ(traitsOf(good<SetOutputGoal>()).way, Way::Queue);
  EXPECT_EQ(traitsOf(with<SetOutputGoal>([](auto& g) { g.at_once = true; })).way, Way::Beside);
  EXPECT_FALSE(orderOf(good<SetOutputGoal>(), arm::Pose::Identity()).moves);
}

TEST(SetOutput, takesOnlyOutputsThatThereAre) {
  for (const int number : {-1, 4, 16}) {
    EXPECT_EQ(errorOf(SetOutputGoal{0, "EndModule", number, 0}), own_error::kOutputInvalid) << number;
  }
  EXPECT_EQ(errorOf(SetOutputGoal{0, "ControlBox", 15, 0}), 0);
  EXPECT_EQ(errorOf(SetOutputGoal{0, "ControlBox", 16, 0}), own_error::kOutputInvalid);
  EXPECT_EQ(errorOf(SetOutputGoal{0, "controlbox", 0, 0}), own_error::kOutputInvalid);
  EXPECT_EQ(errorOf(SetOutputGoal{0, "", 0, 0}), own_error::kOutputInvalid);
  EXPECT_EQ(errorOf(SetOutputGoal{kAnalog, "EndModule", 0, 0}), own_error::kOutputInvalid);
  EXPECT_EQ(errorOf(SetOutputGoal{kAnalog, "ControlBox", 1, 0}), own_error::kOutputInvalid);
}

TEST(SetOutput, takesOnlyValuesThatTheOutputCanHave) {
  for (const double value : {-1.0, 0.5, 2.0, kNan, kInf}) {
    EXPECT_EQ(errorOf(SetOutputGoal{0, "EndModule", 0, value}), own_error::kOutputValue) << value;
  }
  for (const double value : {-10.0, 0.0, 10.0}) {
    EXPECT_EQ(errorOf(SetOutputGoal{kAnalog, "ControlBox", 0, value}), 0) << value;
  }
  for (const double value : {-10.001, 10.001, kNan, -kInf}) {
    EXPECT_EQ(errorOf(SetOutputGoal{kAnalog, "ControlBox", 0, value}), own_error::kOutputValue) << value;
  }
  EXPECT_EQ(errorWith<SetOutputGoal>([](auto& g) { g.kind = 2; }), own_error::kOutputValue);
}

TEST(SetOutput, hasABufferModeOnlyInTheQueue) {
  EXPECT_EQ(errorWith<SetOutputGoal>([](auto& g) { g.buffer_mode = 3; }), own_error::kBufferModeUnknown);
  EXPECT_EQ(errorWith<SetOutputGoal>([](auto& g) {
              g.buffer_mode = 3;
              g.at_once = true;
            }),
            0);
}

TEST(ChangeLoad, isTheWeightOfWhatTheToolHolds) {
  EXPECT_EQ(scriptOf(good<ChangeLoadGoal>()), "ChangeLoad(1.5)");
  for (const double weight : {0.0, 14.0}) EXPECT_EQ(errorOf(ChangeLoadGoal{weight}), 0) << weight;
  for (const double weight : {-0.1, 14.1, kNan}) {
    EXPECT_EQ(errorOf(ChangeLoadGoal{weight}), own_error::kLoadRange) << weight;
  }
}

}  // namespace
}  // namespace cobot_command::testing
