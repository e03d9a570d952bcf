// ChangeBase, ChangeTCP, ProgramControl and ExitListenNode: their rules, and the exact script text.

#include "block_goals.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

const std::vector<std::string> kGoodNames{"RobotBase", "Drehtisch \xC3\xBC", "a\"b", std::string(255, 'n')};
const std::vector<std::string> kBadNames{
    std::string(256, 'n'), "a\r\nScriptExit()", "tab\t", std::string("a\0b", 3), "\xC3", "\x7F"};

template <class Goal>
void expectSixChecks(SixValues Goal::*six) {
  for (std::size_t i = 0; i < 6; ++i) {
    const auto value = [&](double v) { return errorWith<Goal>([&](auto& g) { (g.*six)[i] = v; }); };
    for (const double v : {100000.0, -100000.0}) EXPECT_EQ(value(v), 0);
    for (const double v : {100000.001, -1e308}) EXPECT_EQ(value(v), own_error::kCoordinateRange);
    for (const double v : {kNan, kInf, -kInf}) EXPECT_EQ(value(v), own_error::kNotFinite);
  }
}

TEST(ChangeBaseRules, checkTheTransformation) {
  expectSixChecks(&ChangeBaseGoal::transformation);
}

TEST(ChangeBaseRules, checkTheNameAndNothingThatItStandsInPlaceOf) {
  const auto named = [](const std::string& name) {
    return errorWith<ChangeBaseGoal>([&](auto& g) {
      g.base_name = name;
      g.base_pose = FramedPose{};
      g.transformation[0] = kNan;
    });
  };
  for (const std::string& name : kGoodNames) EXPECT_EQ(named(name), 0) << name;
  for (const std::string& name : kBadNames) EXPECT_EQ(named(name), own_error::kNameInvalid);
}

TEST(ChangeBaseRules, giveTheScript) {
  EXPECT_EQ(scriptOf(good<ChangeBaseGoal>()), "ChangeBase(20,30,10,0,0,90)");
  EXPECT_EQ(scriptOf(with<ChangeBaseGoal>([](auto& g) { g.base_name = "RobotBase"; })),
            "ChangeBase(\"RobotBase\")");
  EXPECT_EQ(scriptOf(with<ChangeBaseGoal>([](auto& g) { g.base_name = "a\"),ScriptExit("; })),
            "ChangeBase(\"a\"\"),ScriptExit(\")");
}

TEST(ChangeBaseRules, measureABasePoseInTheRobotBaseWhicheverBaseIsActive) {
  const auto goal = with<ChangeBaseGoal>([](auto& g) { g.base_pose = framedPose(); });
  EXPECT_EQ(errorOf(goal), 0);
  arm::Pose active = arm::Pose::Identity();
  active.translation() << 7, 8, 9;
  EXPECT_EQ(scriptOf(goal, active), "ChangeBase(800,100,300,0,0,90)");
  EXPECT_FALSE(traitsOf(goal).needs_base);
}

TEST(ChangeBaseRules, nameTheFirstViolationAndListTheOthers) {
  const auto goal = with<ChangeBaseGoal>([](auto& g) {
    g.buffer_mode = 9;
    g.transformation[0] = kNan;
    g.command_id = 1;
  });
  EXPECT_EQ(idsOf(goal), (std::vector<int>{motion_error::kCommandIdRange, own_error::kNotFinite,
                                           own_error::kBufferModeUnknown}));
}

TEST(ChangeTcpRules, checkOffsetAndMassCentre) {
  expectSixChecks(&ChangeTcpGoal::tcp_offset);
  expectSixChecks(&ChangeTcpGoal::mass_center);
}

TEST(ChangeTcpRules, takeWeightsOfUpTo14Kilograms) {
  const auto weight = [](double value) {
    return errorWith<ChangeTcpGoal>([&](auto& g) { g.weight = value; });
  };
  for (const double value : {0.0, -0.0, 0.35, 14.0}) EXPECT_EQ(weight(value), 0) << value;
  for (const double value : {-0.001, 14.001, kNan, kInf}) {
    EXPECT_EQ(weight(value), tcp_error::kWeightRange) << value;
  }
}

TEST(ChangeTcpRules, takeMomentsOfInertiaThatAToolCanHave) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto moment = [&](double value) {
      return errorWith<ChangeTcpGoal>([&](auto& g) { g.moment_of_inertia[i] = value; });
    };
    for (const double value : {0.0, 1e9}) EXPECT_EQ(moment(value), 0) << value;
    for (const double value : {-0.001, 1.000001e9, 1e308, kNan, kInf}) {
      EXPECT_EQ(moment(value), own_error::kInertiaRange) << value;
    }
  }
}

TEST(ChangeTcpRules, checkTheNameAndNothingThatItStandsInPlaceOf) {
  const auto named = [](const std::string& name) {
    return errorWith<ChangeTcpGoal>([&](auto& g) {
      g.tcp_name = name;
      g.weight = 99;
      g.tcp_offset[0] = kNan;
      g.moment_of_inertia[0] = -1;
    });
  };
  for (const std::string& name : kGoodNames) EXPECT_EQ(named(name), 0) << name;
  for (const std::string& name : kBadNames) EXPECT_EQ(named(name), own_error::kNameInvalid);
}

TEST(ChangeTcpRules, giveTheScript) {
  EXPECT_EQ(scriptOf(good<ChangeTcpGoal>()), "ChangeTCP(0,0,150,0,0,90,2,2,0.5,0.5,0,0,-80,0,0,0)");
  EXPECT_EQ(scriptOf(with<ChangeTcpGoal>([](auto& g) { g.weight = 0.35; })),
            "ChangeTCP(0,0,150,0,0,90,0.35,2,0.5,0.5,0,0,-80,0,0,0)");
  EXPECT_EQ(scriptOf(with<ChangeTcpGoal>([](auto& g) { g.tcp_name = "NOTOOL"; })), "ChangeTCP(\"NOTOOL\")");
}

template <class Goal>
void expectTraitsOfAChange() {
  const GoalTraits traits = traitsOf(with<Goal>([](auto& g) {
    g.command_id = 5;
    g.exit_node = true;
  }));
  EXPECT_EQ(traits.command_id, 5);
  EXPECT_TRUE(traits.exits_node);
  EXPECT_FALSE(traits.awaits_motion) << "Done when the controller accepted it";
  EXPECT_FALSE(traits.check_only);
  EXPECT_FALSE(traitsOf(good<Goal>()).exits_node);
}

TEST(ChangeRules, areDoneWhenAccepted) {
  expectTraitsOfAChange<ChangeBaseGoal>();
  expectTraitsOfAChange<ChangeTcpGoal>();
}

TEST(ProgramControlRules, takePauseAndResumeAndNothingElse) {
  const auto command = [](int value) {
    return with<ProgramControlGoal>([&](auto& g) { g.command = value; });
  };
  EXPECT_EQ(scriptOf(command(static_cast<int>(ProgramCommand::Pause))), "Pause()");
  EXPECT_EQ(scriptOf(command(static_cast<int>(ProgramCommand::Resume))), "Resume()");
  for (const int known : {0, 1}) EXPECT_EQ(errorOf(command(known)), 0);
  for (const int unknown : {-1, 2, 99}) {
    EXPECT_EQ(errorOf(command(unknown)), own_error::kProgramCommandUnknown);
  }
}

TEST(ExitListenNodeRules, areToLeaveTheNode) {
  EXPECT_TRUE(traitsOf(ExitListenNodeGoal{}).exits_node);
  EXPECT_FALSE(traitsOf(ExitListenNodeGoal{}).awaits_motion);
  EXPECT_EQ(traitsOf(ExitListenNodeGoal{}).command_id, 0);
}

}  // namespace
}  // namespace cobot_command::testing
