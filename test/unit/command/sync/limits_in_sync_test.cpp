// The software limits beside those of the controller's safety functions, where its status stream tells them.
#include <algorithm>
#include <vector>

#include "exchange_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using Angles = std::vector<float>;

const Angles kLower{-270, -180, -155, -180, -180, -270};  // of the model
const Angles kUpper{270, 180, 155, 180, 180, 270};

StatusFrames streaming(const Angles& lower, const Angles& upper) {
  return StatusFrames()
      .with(protocol::item::ofFloats("Safety_Joint_Angle_Min", lower))
      .with(protocol::item::ofFloats("Safety_Joint_Angle_Max", upper));
}

/// Of J1 alone; of all others those of the model.
StatusFrames streaming(float lower, float upper) {
  Angles all_lower = kLower;
  Angles all_upper = kUpper;
  all_lower[0] = lower;
  all_upper[0] = upper;
  return streaming(all_lower, all_upper);
}

class LimitsInSync : public ::testing::Test {
 protected:
  LimitsInSync() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings()) { rig.connect(); }

  void enable(const std::function<void(ExchangeSettings&)>& change = {}) {
    id = rig.exchangeWith([&](ExchangeSettings& s) {
      s.data_enable_sync.software_limits = s.data_in_sync.software_limits = true;
      s.life_sign_time_out = 60000;
      if (change) change(s);
    });
  }
  /// Of J1, in degrees.
  void plan(double lower, double upper) {
    SoftwareLimits limits = rig.core.limits()->model;
    limits.lower[0] = degToRad(lower);
    limits.upper[0] = degToRad(upper);
    ASSERT_TRUE(rig.core.writeLimits(limits, rig.now).success);
    rig.pump();
  }
  ExchangeReport report() { return rig.report(id); }

  ExchangeRig rig;
  GoalId id = 0;
};

TEST_F(LimitsInSync, areThisLayersAloneWhereNothingIsStreamed) {
  rig.status(StatusFrames());
  enable();
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  EXPECT_TRUE(report().out_cmd.data_in_sync.software_limits);
  EXPECT_THAT(report().local_sets, ElementsAre("software_limits", "default_dynamics", "reference_dynamics"));
}

TEST_F(LimitsInSync, areNotComparedWithHalfOfTheirs) {
  rig.status(StatusFrames().with(protocol::item::ofFloats("Safety_Joint_Angle_Min", Angles(6, 0))));
  enable();
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  EXPECT_THAT(report().local_sets, Contains("software_limits"));
}

TEST_F(LimitsInSync, areInSyncWhereOursLieInside) {
  rig.status(streaming(kLower, kUpper));
  enable();
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  EXPECT_THAT(report().local_sets, ElementsAre("default_dynamics", "reference_dynamics"));
  plan(-10, 10);
  EXPECT_EQ(report().ri_state, RiState::Synchronized) << "narrower than theirs";
}

TEST_F(LimitsInSync, areOutOfSyncByTheJointThatGoesBeyond) {
  rig.status(streaming(-90, 100));
  enable();
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  EXPECT_FALSE(report().out_cmd.data_in_sync.software_limits);
  const std::string words =
      "the controller's safety functions limit J1 to -90..100 deg, and this node plans it within -270..270 "
      "deg";
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr(words));
  EXPECT_THAT(rig.group_state.out_of_sync, HasSubstr(words));
  EXPECT_THAT(rig.group_state.out_of_sync, Not(HasSubstr("J2")));
}

TEST_F(LimitsInSync, areInSyncAsSoonAsOursAreInside) {
  rig.status(streaming(-90, 100));
  enable();
  plan(-90, 101);
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  plan(-90, 100);
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  EXPECT_TRUE(rig.group_state.out_of_sync.empty());
}

TEST_F(LimitsInSync, areEqualToAThousandthOfADegree) {
  rig.status(streaming(-89.999F, 99.999F));
  enable();
  plan(-90, 100);
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  plan(-90, 100.002);
  EXPECT_EQ(report().ri_state, RiState::Initialized);
}

TEST_F(LimitsInSync, nameEachJointThatGoesBeyond) {
  rig.status(streaming(Angles(6, -10), Angles(6, 10)));
  enable();
  for (const char* joint : {"J1", "J2", "J3", "J4", "J5", "J6"}) {
    EXPECT_THAT(rig.group_state.out_of_sync, HasSubstr(joint));
  }
}

TEST_F(LimitsInSync, followTheStream) {
  rig.status(streaming(kLower, kUpper));
  enable();
  rig.status(streaming(-90, 100));
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  rig.status(streaming(kLower, kUpper));
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
}

TEST_F(LimitsInSync, areComparedWithWhatWasToldLastWhileTheStreamIsSilent) {
  rig.status(streaming(-90, 100));
  enable();
  rig.pass(5s);
  ASSERT_FALSE(rig.latest().status_stream);
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  EXPECT_THAT(rig.group_state.out_of_sync, HasSubstr("J1"));
}

TEST_F(LimitsInSync, areComparedWithWhatWasToldLastWhereTheItemsAreStreamedNoMore) {
  rig.status(streaming(-90, 100));
  enable();
  rig.status(StatusFrames());
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  EXPECT_THAT(rig.group_state.out_of_sync, HasSubstr("J1"));
}

TEST_F(LimitsInSync, areForgottenWithTheLink) {
  rig.status(streaming(-90, 100));
  enable();
  rig.close("gone", link::Channel::Status);
  rig.close("gone");
  rig.connect();
  rig.status(StatusFrames());
  enable();
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  EXPECT_THAT(report().local_sets, Contains("software_limits"));
}

TEST_F(LimitsInSync, areSaidToBeNoneWhereTheyLeaveNoAngle) {
  rig.status(streaming(Angles(6, 0), Angles(6, 0)));
  enable();
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  EXPECT_THAT(rig.group_state.out_of_sync,
              HasSubstr("are no limits: if the controller has none, do not enable"));
}

TEST_F(LimitsInSync, areLeftAloneWhereTheyAreNotEnabled) {
  rig.status(streaming(-90, 100));
  enable([](ExchangeSettings& s) {
    s.data_enable_sync.software_limits = false;
    s.data_enable_sync.default_dynamics = true;
  });
  EXPECT_EQ(report().ri_state, RiState::Synchronized);
  EXPECT_FALSE(report().out_cmd.data_in_sync.software_limits) << "the controller's half is told all the same";
  EXPECT_TRUE(rig.group_state.out_of_sync.empty());
}

TEST_F(LimitsInSync, areOutOfSyncWhereTheCallersOwnAreOld) {
  rig.status(streaming(kLower, kUpper));
  enable([](ExchangeSettings& s) { s.data_in_sync.software_limits = false; });
  EXPECT_EQ(report().ri_state, RiState::Initialized);
  EXPECT_TRUE(report().out_cmd.data_in_sync.software_limits);
  EXPECT_THAT(rig.group_state.out_of_sync, HasSubstr("the caller's own software_limits"));
}

TEST_F(LimitsInSync, refuseMotionsAsTheReactionSays) {
  rig.status(streaming(-90, 100));
  enable([](ExchangeSettings& s) { s.sync_reaction = static_cast<int>(SyncReaction::NoEnable); });
  rig.discardSent();
  const GoalId refused = rig.submit(CoreRig::move());
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, 0x8C06);
  EXPECT_THAT(rig.outcome(refused)->error_description, HasSubstr("J1"));
}

/// The reads of the tables wait for an answer, and nothing is known of these.
TEST_F(LimitsInSync, refuseMotionsAlsoBeforeTheTablesWereRead) {
  rig.status(streaming(-90, 100));
  tables::Tool tool;
  tool.name = "gripper";
  tool.pose = arm::Pose::Identity();
  ASSERT_TRUE(rig.core.writeTable({3, std::optional(tool)}));
  enable([](ExchangeSettings& s) {
    s.data_enable_sync.tools = s.data_in_sync.tools = true;
    s.sync_reaction = static_cast<int>(SyncReaction::NoEnable);
  });
  EXPECT_EQ(rig.outcome(rig.submit(CoreRig::move()))->error_id, 0x8C06);
  rig.discardSent();
}

TEST_F(LimitsInSync, interruptMotionsAndSayHowTheyGoOn) {
  rig.status(streaming(kLower, kUpper));
  enable([](ExchangeSettings& s) { s.sync_reaction = static_cast<int>(SyncReaction::InterruptAtOnce); });
  rig.status(streaming(-90, 100));
  const GoalId refused = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(refused)->error_id, 0x8C30);
  EXPECT_THAT(rig.outcome(refused)->remedy, HasSubstr("write_software_limits"));
  const auto found = std::find_if(rig.messages.begin(), rig.messages.end(),
                                  [](const command::Message& message) { return message.code == 0x8C30; });
  ASSERT_NE(found, rig.messages.end());
  const command::Message& told = *found;
  EXPECT_THAT(told.text, HasSubstr("motions are interrupted: the controller's safety functions limit J1"));
  EXPECT_THAT(told.remedy, HasSubstr("on the pendant"));
  plan(-90, 100);
  const GoalId still = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(still)->error_id, 0x8C30) << "nothing resumes by itself";
  EXPECT_EQ(rig.outcome(still)->remedy, "RESUME with program_control, or stop");
}

TEST_F(LimitsInSync, areToldNoMoreWhenTheInterfaceIsDisabled) {
  rig.status(streaming(-90, 100));
  enable([](ExchangeSettings& s) { s.data_enable_sync.tools = true; });
  EXPECT_FALSE(rig.group_state.out_of_sync.empty());
  rig.cancel(id);
  EXPECT_TRUE(rig.group_state.out_of_sync.empty());
}

TEST(LimitsInSyncWithoutAModel, areNotCompared) {
  ExchangeRig rig(std::nullopt, link::LinkSettings());
  rig.connect();
  rig.status(streaming(Angles(6, 0), Angles(6, 0)));
  const GoalId id = rig.exchangeWith([](ExchangeSettings& s) {
    s.data_enable_sync.software_limits = s.data_in_sync.software_limits = true;
  });
  EXPECT_EQ(rig.report(id).ri_state, RiState::Synchronized);
  EXPECT_THAT(rig.report(id).local_sets, Contains("software_limits"));
}

}  // namespace
}  // namespace cobot_command::testing
