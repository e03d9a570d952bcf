// What the three moves have in common: both ends of each range, no number that is none, every enumerator.

#include "block_goals.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

void setFormat(MoveAbsoluteGoal& goal, const char* name) {
  const std::vector<std::string> names{"JPP", "CPP", "CPR", "CAP", "CAR"};
  goal.movement_command = static_cast<int>(Movement::Line);
  goal.data_format = static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}
void setFormat(MoveRelativeGoal& goal, const char* name) {
  const std::vector<std::string> names{"JPP", "CPP", "CPR", "CAP", "CAR", "TPP", "TPR", "TAP", "TAR"};
  goal.movement_command = static_cast<int>(Movement::Line);
  goal.data_format = static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}
void setFormat(MoveCircleGoal& goal, const char* name) {
  goal.data_format = static_cast<int>(std::string(name) == "CAP" ? CircleFormat::Cap : CircleFormat::Cpp);
}

template <class Goal>
std::vector<const char*> formatsWith(std::size_t letter, char value) {
  std::vector<const char*> all{"CPP", "CPR", "CAP", "CAR"};
  if (std::is_same_v<Goal, MoveRelativeGoal>) all.insert(all.end(), {"TPP", "TPR", "TAP", "TAR"});
  if (std::is_same_v<Goal, MoveCircleGoal>) all = {"CPP", "CAP"};
  std::vector<const char*> some;
  for (const char* format : all) {
    if (format[letter] == value) some.push_back(format);
  }
  return some;
}

template <class Goal>
class MoveParameters : public ::testing::Test {};
using Moves = ::testing::Types<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal>;
TYPED_TEST_SUITE(MoveParameters, Moves);

TYPED_TEST(MoveParameters, takeSpeedsUpToTheEndOfTheRangeOfTheirFormat) {
  for (const auto& [letter, highest, error] : {std::tuple{'P', 100.0, motion_error::kSpeedRangePercent},
                                               std::tuple{'A', 4500.0, motion_error::kSpeedRangeAbsolute}}) {
    for (const char* format : formatsWith<TypeParam>(1, letter)) {
      SCOPED_TRACE(format);
      const auto speed = [format = format](double value) {
        return errorWith<TypeParam>([&](auto& g) {
          setFormat(g, format);
          g.speed = value;
        });
      };
      for (const double value : {0.001, 1.0, highest}) EXPECT_EQ(speed(value), 0) << value;
      for (const double value : {0.0, -0.0, -0.001, highest + 0.001, 1e308, kNan, kInf, -kInf}) {
        EXPECT_EQ(speed(value), error) << value;
      }
    }
  }
}

TYPED_TEST(MoveParameters, takeSpeedInPercentForPtp) {
  if constexpr (!std::is_same_v<TypeParam, MoveCircleGoal>) {
    EXPECT_EQ(errorWith<TypeParam>([](auto& g) { g.speed = 100; }), 0);
    EXPECT_EQ(errorWith<TypeParam>([](auto& g) { g.speed = 101; }), motion_error::kSpeedRangePercent);
  }
}

TYPED_TEST(MoveParameters, takeAccelTimesFrom150To9999) {
  const auto accel = [](double value) {
    return errorWith<TypeParam>([&](auto& g) { g.accel_time = value; });
  };
  for (const double value : {150.0, 9999.0}) EXPECT_EQ(accel(value), 0) << value;
  for (const double value : {0.0, 149.999, 9999.001, -150.0, kNan, kInf}) {
    EXPECT_EQ(accel(value), motion_error::kAccelTimeRange) << value;
  }
}

TYPED_TEST(MoveParameters, takeBlendingInTheRangeOfTheirFormat) {
  for (const auto& [letter, highest] : {std::pair{'P', 100.0}, std::pair{'R', 2000.0}}) {
    for (const char* format : formatsWith<TypeParam>(2, letter)) {
      SCOPED_TRACE(format);
      const auto blending = [format = format](double value) {
        return errorWith<TypeParam>([&](auto& g) {
          setFormat(g, format);
          g.blending_enable = true;
          g.blending_value = value;
        });
      };
      for (const double value : {0.0, highest}) EXPECT_EQ(blending(value), 0) << value;
      for (const double value : {-0.001, highest + 0.001, kNan, kInf}) {
        EXPECT_EQ(blending(value), own_error::kBlendingRange) << value;
      }
    }
  }
  EXPECT_EQ(errorWith<TypeParam>([](auto& g) { g.blending_value = kNan; }), 0)
      << "not enabled, not looked at";
}

TYPED_TEST(MoveParameters, areRoundedToWhatTheControllerTakes) {
  const TypeParam goal = with<TypeParam>([](auto& g) {
    g.speed = 0.2;
    g.accel_time = 199.6;
    g.blending_enable = true;
    g.blending_value = 12.4;
  });
  EXPECT_NE(scriptOf(goal).find(",1,200,12,"), std::string::npos) << scriptOf(goal);
}

TYPED_TEST(MoveParameters, sendNoBlendingUnlessItIsEnabled) {
  const TypeParam goal = with<TypeParam>([](auto& g) { g.blending_value = 50; });
  EXPECT_NE(scriptOf(goal).find(",10,200,0,"), std::string::npos) << scriptOf(goal);
}

/// As in the thesis, whose PrecisePositioning is FALSE unless said otherwise and goes out as it is: the
/// controller's argument switches it off (4.3.1).
TYPED_TEST(MoveParameters, settlePreciselyUnlessThatIsDisabled) {
  const std::string precise = scriptOf(good<TypeParam>());
  const std::string coarse = scriptOf(with<TypeParam>([](auto& g) { g.disable_precise_positioning = true; }));
  EXPECT_EQ(precise.substr(precise.size() - 7), ",false)");
  EXPECT_EQ(coarse.substr(coarse.size() - 6), ",true)");
}

TYPED_TEST(MoveParameters, sayWhatTheArbiterHasToKnow) {
  const TypeParam goal = with<TypeParam>([](auto& g) {
    g.command_id = 7;
    g.buffer_mode = static_cast<int>(BufferMode::Aborting);
    g.exit_node = true;
    g.check_only = true;
  });
  const GoalTraits traits = traitsOf(goal);
  EXPECT_EQ(traits.command_id, 7);
  EXPECT_EQ(traits.buffer_mode, BufferMode::Aborting);
  EXPECT_TRUE(traits.exits_node);
  EXPECT_TRUE(traits.check_only);
  EXPECT_FALSE(traits.needs_base);
  EXPECT_FALSE(traits.reply_timeout);
  EXPECT_TRUE(traits.awaits_motion);
  EXPECT_FALSE(traitsOf(with<TypeParam>([](auto& g) { g.blending_enable = true; })).awaits_motion);
  EXPECT_FALSE(traitsOf(good<TypeParam>()).exits_node);
}

TYPED_TEST(MoveParameters, nameTheFirstViolationOfTheTableAndListTheOthers) {
  const TypeParam goal = with<TypeParam>([](auto& g) {
    g.buffer_mode = 3;
    g.blending_enable = true;
    g.blending_value = -1;
    g.command_id = 1;
    g.accel_time = 3;
    g.speed = 0;
  });
  const std::vector<int> all{motion_error::kSpeedRangePercent, motion_error::kAccelTimeRange,
                             motion_error::kCommandIdRange, own_error::kBlendingRange,
                             own_error::kBufferModeUnknown};
  EXPECT_EQ(idsOf(goal), all);
  EXPECT_EQ(check(goal)[1].found, "accel_time is 3");
}

// --- What all commands with these parameters have in common.

template <class Goal>
class CommandId : public ::testing::Test {};
using WithCommandId = ::testing::Types<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal,
                                       ChangeTcpGoal, ProgramControlGoal>;
TYPED_TEST_SUITE(CommandId, WithCommandId);

TYPED_TEST(CommandId, isZeroOrTwoToNine) {
  const auto id = [](int value) { return errorWith<TypeParam>([&](auto& g) { g.command_id = value; }); };
  for (const int value : {0, 2, 3, 4, 5, 6, 7, 8, 9}) EXPECT_EQ(id(value), 0) << value;
  for (const int value :
       {-1, 1, 10, 65535, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    EXPECT_EQ(id(value), motion_error::kCommandIdRange) << value;
  }
}

template <class Goal>
class BufferModes : public ::testing::Test {};
using WithBufferMode = ::testing::Types<MoveAbsoluteGoal, MoveRelativeGoal, MoveCircleGoal, ChangeBaseGoal,
                                        ChangeTcpGoal, ExitListenNodeGoal, RunScriptGoal>;
TYPED_TEST_SUITE(BufferModes, WithBufferMode);

TYPED_TEST(BufferModes, areThreeAndNoOthers) {
  for (const BufferMode mode : {BufferMode::Refuse, BufferMode::Buffered, BufferMode::Aborting}) {
    const auto goal = with<TypeParam>([&](auto& g) { g.buffer_mode = static_cast<int>(mode); });
    EXPECT_EQ(errorOf(goal), 0);
    EXPECT_EQ(traitsOf(goal).buffer_mode, mode);
  }
  for (const int unknown : {-1, 3, 255, std::numeric_limits<int>::min()}) {
    const auto goal = with<TypeParam>([&](auto& g) { g.buffer_mode = unknown; });
    EXPECT_EQ(errorOf(goal), own_error::kBufferModeUnknown) << unknown;
    EXPECT_EQ(traitsOf(goal).buffer_mode, BufferMode::Refuse);
  }
}

}  // namespace
}  // namespace cobot_command::testing
