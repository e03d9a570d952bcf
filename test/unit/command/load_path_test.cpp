// What is refused of paths as they come, and the frames of one. How whole paths run:
// test/integration/load_path.

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

class LoadPathTest : public ::testing::Test {
 protected:
  LoadPathTest() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
  }

  /// The controller executes what was sent, and the robot stands there then.
  std::string execute(const std::vector<float>& end_deg) {
    const auto script = rig.takeScript();
    rig.reply(script.id);
    rig.status(StatusFrames().moving());
    rig.tag(rig.latest().open_tags.at(0));
    rig.stream(StatusFrames().at(end_deg), 3);
    return script.script;
  }
  [[nodiscard]] const PathReport& reportOf(GoalId id) const {
    return rig.outcome(id)->detail.as<PathReport>();
  }

  CoreRig rig;
};

constexpr std::size_t kPoints = 3;

TEST_F(LoadPathTest, sendsOnePvtFromStopToStop) {
  const GoalId id = rig.submit(good<LoadPathGoal>());
  EXPECT_TRUE(rig.accepted(id));
  const std::string first = execute({10, 0, 90, 0, 90, 0});
  EXPECT_EQ(first.find("PVTEnter(0)"), 0u) << first;
  EXPECT_THAT(first, HasSubstr("PVTExit()\r\nQueueTag("));
  EXPECT_EQ(rig.outcome(id), nullptr);
  execute({10, 0, 100, 0, 80, 0});
  execute({0, 0, 90, 0, 90, 0});
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
  EXPECT_EQ(reportOf(id).points.size(), kPoints);
  EXPECT_EQ(reportOf(id).execution, Execution::Pvt);
  EXPECT_EQ(reportOf(id).error_index, -1);
  EXPECT_TRUE(rig.outcome(id)->planned && rig.outcome(id)->actual && rig.outcome(id)->final_joints_deg);
}

TEST_F(LoadPathTest, isPreemptedByAStopBehindThat) {
  const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) { g.number_of_moves = 1; }));
  rig.reply(rig.takeScript().id);
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames());
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
}

TEST_F(LoadPathTest, tellsThePointOfALostLink) {
  const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) {
    g.path.insert(g.path.begin(), g.path[1]);  // is not loaded
    g.start_index = 1;
  }));
  execute({10, 0, 90, 0, 90, 0});
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().at({10, 0, 90, 0, 90, 0}).moving());
  rig.close("gone");
  rig.pass(500ms);
  rig.discardSent();
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, 1002);
  EXPECT_EQ(reportOf(id).error_index, 2);
}

/// An emergency stop closes the script port; it is the reason then.
TEST_F(LoadPathTest, isRefusedForTheEmergencyStopThatClosedTheScriptPort) {
  rig.core.cancel(1, rig.now, 1);
  rig.pump();
  rig.submit(CoreRig::robot());
  rig.failOpen(link::OpenFailure::Kind::Refused);
  rig.open(link::Channel::Status);
  rig.status(StatusFrames().emergencyStop());
  const GoalId path = rig.submit(good<LoadPathGoal>());
  EXPECT_EQ(rig.outcome(path)->error_id, 1005);
  const GoalId move = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(move)->error_id, 0x10);
}

/// Also behind a robot that moves, when it is not planned yet.
TEST_F(LoadPathTest, refusesWrongPointsAsTheyCome) {
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const GoalId id = rig.submit(with<LoadPathGoal>([](auto& g) {
    g.buffer_mode = static_cast<int>(BufferMode::Buffered);
    g.path[2].profile_type = 7;
  }));
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, 1025);
  EXPECT_EQ(reportOf(id).error_index, 2);
}

TEST_F(LoadPathTest, sendsNothingBehindAPvtThatMayBeRefused) {
  const GoalId id = rig.submit(good<LoadPathGoal>());
  const std::string first = rig.takeScript().id;
  EXPECT_TRUE(rig.nothingSent()) << "it would begin where the robot is not";
  rig.reply(first, false, {1});
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kRejected);
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(LoadPathTest, goesInManualModeWhereThatIsAllowed) {
  link::LinkSettings settings;
  settings.path.in_manual_mode = true;
  CoreRig manual(*arm::ArmModel::named("tm5-900"), settings);
  manual.connect();
  manual.status(StatusFrames().with(protocol::item::ofInt("MA_Mode", 2)));
  EXPECT_TRUE(manual.accepted(manual.submit(good<LoadPathGoal>())));
  manual.discardSent();
}

TEST_F(LoadPathTest, isCheckedWithoutALink) {
  CoreRig alone(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  const GoalId id = alone.submit(with<LoadPathGoal>([](auto& g) { g.check_only = true; }));
  EXPECT_EQ(alone.outcome(id)->error_id, own_error::kStartUnknown);
  const GoalId known = rig.submit(with<LoadPathGoal>([](auto& g) { g.check_only = true; }));
  ASSERT_NE(rig.outcome(known), nullptr);
  EXPECT_EQ(rig.outcome(known)->ending, Ending::Done) << rig.outcome(known)->error_description;
  EXPECT_FALSE(reportOf(known).joint_path.empty());
  EXPECT_TRUE(rig.nothingSent());
}

// --- What people see of it.

TEST_F(LoadPathTest, isShownAsAWholeBeforeItsFirstPieceGoesOut) {
  const GoalId id = rig.submit(good<LoadPathGoal>());
  ASSERT_EQ(rig.previews.size(), 1U);
  EXPECT_EQ(rig.previews[0].goal, id);
  EXPECT_EQ(rig.previews[0].preview.as<path::PathPreview>().points.size(), kPoints);
  execute({10, 0, 90, 0, 90, 0});
  rig.discardSent();
  EXPECT_EQ(rig.planned_paths, 0) << "its pieces are not shown besides";
}

TEST_F(LoadPathTest, isShownWhenItIsChecked) {
  rig.submit(with<LoadPathGoal>([](auto& g) { g.check_only = true; }));
  ASSERT_EQ(rig.previews.size(), 1U);
  EXPECT_EQ(rig.previews[0].block, kBlock<LoadPathGoal>);
}

TEST_F(LoadPathTest, isShownUpToThePointThatRefusesIt) {
  for (const bool check_only : {false, true}) {
    rig.previews.clear();
    const GoalId id = rig.submit(with<LoadPathGoal>([&](auto& g) {
      g.check_only = check_only;
      g.path[1].joints[2] = 170;
    }));
    ASSERT_EQ(rig.outcome(id)->error_id, 1033);
    ASSERT_EQ(rig.previews.size(), 1U);
    const auto& preview = rig.previews[0].preview.as<path::PathPreview>();
    EXPECT_EQ(preview.points.size(), 1U);
    ASSERT_TRUE(preview.refusal && preview.refusal->where);
    EXPECT_EQ(preview.refusal->index, 1);
    EXPECT_EQ(reportOf(id).points.size(), 2U);
  }
}

TEST_F(LoadPathTest, isNotShownWhereNothingOfItWasPlanned) {
  rig.submit(with<LoadPathGoal>([](auto& g) { g.path[2].profile_type = 7; }));
  EXPECT_TRUE(rig.previews.empty());
}

}  // namespace
}  // namespace cobot_command::testing
