// The pose of a tool in a frame -> the postures that reach it, and the one that was asked for.

#include "cobot_command/kinematics/inverse.h"

#include <algorithm>
#include <cmath>

#include "kinematics_support.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/kinematics/forward.h"

namespace cobot_command::kinematics {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using Bits = std::array<int, 3>;

constexpr int kGiven = 0, kSame = 1, kFree = 2;

double furthest(const arm::ControllerJoints& a, const arm::ControllerJoints& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// A question with the bits of the posture that made the pose.
InverseQuestion questionOf(const ForwardAnswer& there, ToolAndFrame numbers, int configuration = kGiven) {
  InverseQuestion question;
  question.pose = there.pose;
  question.numbers = numbers;
  question.configuration = configuration;
  question.bits = there.posture.bits.numbers();
  question.joints = there.posture.joints;
  return question;
}

class Inverse : public ::testing::Test {
 protected:
  InverseQuestion oracle(int configuration = kGiven) {
    return questionOf(*forward(arm, tables, {kJoints, {}}), {}, configuration);
  }
  InverseAnswer of(const InverseQuestion& question) { return inverse(arm, tables, question); }
  void expectRefused(int error_id, const char* words, const InverseQuestion& question) {
    const InverseAnswer answer = of(question);
    ASSERT_FALSE(answer.chosen) << words;
    EXPECT_EQ(answer.chosen.error().error_id, error_id) << answer.chosen.error().message;
    EXPECT_THAT(answer.chosen.error().message, HasSubstr(words));
  }

  const arm::ArmModel arm = model("tm5-700");
  const tables::DataTables tables = someTables();
};

/// SRCI oracle 19.
TEST_F(Inverse, givesTheEightBranchesOfTheOracle) {
  struct Row {
    Bits bits;
    arm::ControllerJoints joints;
  };
  const std::vector<Row> rows = {{{0, 2, 4}, {30.0000, -20.0000, 100.0000, 10.0000, 80.0000, -45.0000}},
                                 {{0, 2, 5}, {30.0000, 17.4549, 63.4203, -170.8752, -80.0000, 135.0000}},
                                 {{0, 3, 4}, {30.0000, 76.2700, -100.0000, 113.7300, 80.0000, -45.0000}},
                                 {{0, 3, 5}, {30.0000, 78.9409, -63.4203, -105.5206, -80.0000, 135.0000}},
                                 {{1, 2, 4}, {165.6743, 20.2139, -102.5482, -0.6419, -97.1360, -89.7643}},
                                 {{1, 2, 5}, {165.6743, -17.7614, -60.5901, 175.3753, 97.1360, 90.2357}},
                                 {{1, 3, 4}, {165.6743, -78.4314, 102.5482, -107.0930, -97.1360, -89.7643}},
                                 {{1, 3, 5}, {165.6743, -76.5225, 60.5901, 112.9562, 97.1360, 90.2357}}};
  const InverseAnswer answer = of(oracle());
  ASSERT_EQ(answer.branches.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Branch& branch = answer.branches[i];
    EXPECT_EQ(branch.posture.bits.numbers(), rows[i].bits);
    EXPECT_FALSE(branch.outside);
    EXPECT_LT(furthest(branch.posture.joints, rows[i].joints), 1e-4) << i;
  }
  ASSERT_TRUE(answer.chosen);
  EXPECT_LT(furthest(answer.chosen->joints, kJoints), 1e-8);
}

TEST_F(Inverse, givesEachBranchByItsBits) {
  InverseQuestion question = oracle();
  for (const Branch& branch : of(question).branches) {
    question.bits = branch.posture.bits.numbers();
    const InverseAnswer answer = of(question);
    ASSERT_TRUE(answer.chosen);
    EXPECT_EQ(answer.chosen->joints, branch.posture.joints);
    EXPECT_EQ(answer.chosen->bits, branch.posture.bits);
  }
}

TEST_F(Inverse, withSameHasTheBitsOfTheGivenJointsHoweverFarTheseAre) {
  InverseQuestion question = oracle(kSame);
  question.bits = {};  // not read
  for (const Branch& branch : of(question).branches) {
    question.joints = branch.posture.joints;
    question.joints[0] += 90;  // elsewhere, and in the same configuration
    const InverseAnswer answer = of(question);
    ASSERT_TRUE(answer.chosen);
    EXPECT_EQ(answer.chosen->bits, branch.posture.bits);
  }
}

TEST_F(Inverse, withSameTakesTheTurnsNearestToTheGivenJoints) {
  InverseQuestion question = oracle(kSame);
  question.joints = {30, -20, 100, 10, 80, 250};
  const InverseAnswer answer = of(question);
  ASSERT_TRUE(answer.chosen);
  EXPECT_NEAR(answer.chosen->joints[5], -45, 1e-8) << "315 is nearer, and outside the limits";
  question.pose = forward(arm, tables, {{30, -20, 100, 10, 80, -110}, {}})->pose;
  const InverseAnswer turned = of(question);
  ASSERT_TRUE(turned.chosen);
  EXPECT_NEAR(turned.chosen->joints[5], 250, 1e-8);
  EXPECT_EQ(turned.chosen->turns, (Turns{0, 0, 0, 0, 0, 1}));
}

TEST_F(Inverse, withFreeTakesTheBranchThatIsReachedFirst) {
  InverseQuestion question = oracle(kFree);
  question.bits = {};
  for (const Branch& branch : of(question).branches) {
    question.joints = branch.posture.joints;
    question.joints[3] += 3;
    const InverseAnswer answer = of(question);
    ASSERT_TRUE(answer.chosen);
    EXPECT_EQ(answer.chosen->bits, branch.posture.bits);
  }
}

TEST_F(Inverse, withFreePassesOverBranchesOutsideTheLimits) {
  const arm::ArmModel narrow = narrowed("tm5-700", "shoulder_1_joint", 100, 200);
  const InverseAnswer answer = inverse(narrow, tables, oracle(kFree));
  ASSERT_EQ(answer.branches.size(), 8U);
  for (const Branch& branch : answer.branches) {
    const bool is_righty = branch.posture.bits.shoulder == arm::Shoulder::Righty;
    EXPECT_EQ(branch.outside, is_righty ? std::optional(0) : std::nullopt);
  }
  ASSERT_TRUE(answer.chosen);
  EXPECT_EQ(answer.chosen->bits.shoulder, arm::Shoulder::Lefty);
}

TEST_F(Inverse, refusesAPoseThatIsReachedOutsideTheLimitsOnly) {
  const arm::ArmModel narrow = narrowed("tm5-700", "shoulder_1_joint", -20, 20);
  for (const int configuration : {kGiven, kSame, kFree}) {
    const InverseAnswer answer = inverse(narrow, tables, oracle(configuration));
    EXPECT_EQ(answer.branches.size(), 8U) << "told all the same";
    ASSERT_FALSE(answer.chosen);
    EXPECT_EQ(answer.chosen.error().error_id, 0x8C63);
    EXPECT_THAT(answer.chosen.error().message, AnyOf(HasSubstr("Joint 1 would be"), HasSubstr("joint 1")));
  }
}

TEST_F(Inverse, refusesAPoseOutOfReach) {
  for (const int configuration : {kGiven, kSame, kFree}) {
    InverseQuestion question = oracle(configuration);
    question.pose = {2000, 0, 400, 180, 0, 90};
    expectRefused(0x8C62, "X 2000.00", question);
    EXPECT_TRUE(of(question).branches.empty());
  }
}

TEST_F(Inverse, refusesBitsThatThePoseDoesNotAllowAndNamesThePossibleOnes) {
  // Stretched forwards, the wrist bent outwards: turned the other way it does not reach.
  const ForwardAnswer there = *forward(arm, tables, {{0, 90, 1, 0, 90, 0}, {}});
  InverseQuestion question = questionOf(there, {});
  const auto branches = of(question).branches;
  ASSERT_FALSE(branches.empty());
  ASSERT_LT(branches.size(), 8U);
  int refusals = 0;
  for (const int shoulder : {0, 1}) {
    for (const int elbow : {2, 3}) {
      for (const int wrist : {4, 5}) {
        question.bits = {shoulder, elbow, wrist};
        const InverseAnswer answer = of(question);
        if (answer.chosen) continue;
        ++refusals;
        EXPECT_EQ(answer.chosen.error().error_id, 0x8C62);
        EXPECT_THAT(answer.chosen.error().message, HasSubstr(toString(branches[0].posture.bits)));
      }
    }
  }
  EXPECT_EQ(refusals, 8 - static_cast<int>(branches.size()));
}

TEST_F(Inverse, refusesNumbersThatAreNone) {
  for (const double bad : {kNan, kInf, -kInf}) {
    InverseQuestion question = oracle();
    question.pose[4] = bad;
    expectRefused(0x200, "the pose", question);
    question = oracle();
    question.joints[2] = bad;
    expectRefused(0x200, "joint 3", question);
  }
  for (const double far : {100001.0, -100001.0, 1e300}) {
    InverseQuestion question = oracle();
    question.pose[0] = far;
    expectRefused(0x213, "the pose", question);
    question = oracle();
    question.joints[5] = far;
    expectRefused(0x213, "joint 6", question);
  }
}

TEST_F(Inverse, takesGivenJointsThatAreOutsideTheLimits) {
  InverseQuestion question = oracle(kSame);
  question.joints[0] += 3600;
  ASSERT_TRUE(of(question).chosen);
}

TEST_F(Inverse, refusesToolsAndFramesWithoutAKnownPose) {
  InverseQuestion question = oracle();
  for (const int tool : {-1, 16, 7, 2}) {
    question.numbers = {tool, 0};
    expectRefused(0x8D35, "tool", question);
  }
  for (const int frame : {-1, 16, 7, 3}) {
    question.numbers = {0, frame};
    expectRefused(0x8D08, "frame", question);
  }
}

TEST_F(Inverse, refusesConfigurationsAndBitsThatAreNone) {
  InverseQuestion question = oracle();
  for (const int unknown : {-1, 3, 255}) {
    question.configuration = unknown;
    expectRefused(0x8D21, "configuration", question);
  }
  question = oracle();
  struct Row {
    Bits bits;
    int error_id;
    const char* words;
  };
  for (const Row& row :
       {Row{{2, 2, 4}, 0x8D40, "config1 is 2; allowed: 0 and 1"}, Row{{-1, 0, 0}, 0x8D40, "config1"},
        Row{{0, 1, 4}, 0x8D05, "config2"}, Row{{0, 0, 0}, 0x8D05, "config2 is 0; allowed: 2 and 3"},
        Row{{0, 2, 6}, 0x8D41, "config3 is 6; allowed: 4 and 5"}}) {
    question.bits = row.bits;
    expectRefused(row.error_id, row.words, question);
  }
}

class OfEveryModel : public ::testing::TestWithParam<std::string> {};

TEST_P(OfEveryModel, forwardAndInverseGoRoundWithAnyToolAndFrame) {
  const arm::ArmModel arm = model(GetParam());
  const tables::DataTables tables = someTables();
  RandomJoints random(arm);
  constexpr int kRounds = 2000;
  for (int round = 0; round < kRounds; ++round) {
    const ToolAndFrame numbers{random.below(2), random.below(3)};
    const auto there = forward(arm, tables, {random.next(), numbers});
    ASSERT_TRUE(there);
    for (const int configuration : {kGiven, kSame, kFree}) {
      const InverseAnswer back = inverse(arm, tables, questionOf(*there, numbers, configuration));
      ASSERT_TRUE(back.chosen) << back.chosen.error().message;
      ASSERT_LT(furthest(back.chosen->joints, there->posture.joints), 1e-3) << round << ' ' << configuration;
      EXPECT_EQ(back.chosen->turns, there->posture.turns);
    }
  }
}

TEST_P(OfEveryModel, eachBranchWithinTheLimitsBringsTheToolToThePose) {
  const arm::ArmModel arm = model(GetParam());
  const tables::DataTables tables = someTables();
  RandomJoints random(arm);
  constexpr int kRounds = 500;
  int outside = 0;
  for (int round = 0; round < kRounds; ++round) {
    const ToolAndFrame numbers{random.below(2), random.below(3)};
    const auto there = forward(arm, tables, {random.next(), numbers});
    InverseQuestion question = questionOf(*there, numbers);
    question.joints = random.next();
    for (const Branch& branch : inverse(arm, tables, question).branches) {
      const auto again = forward(arm, tables, {branch.posture.joints, numbers});
      ASSERT_EQ(bool(again), !branch.outside);
      if (branch.outside) {
        ++outside;
        continue;
      }
      const arm::Pose difference = arm::toPose(again->pose).inverse() * arm::toPose(there->pose);
      EXPECT_LT((difference.matrix() - arm::Pose::Identity().matrix()).cwiseAbs().maxCoeff(), 1e-8);
    }
  }
  EXPECT_GT(outside, 0) << "or this says nothing of limits";
}

INSTANTIATE_TEST_SUITE_P(Models, OfEveryModel, ::testing::ValuesIn(arm::ArmModel::knownNames()),
                         [](const auto& model) {
                           std::string name = model.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

}  // namespace
}  // namespace cobot_command::kinematics
