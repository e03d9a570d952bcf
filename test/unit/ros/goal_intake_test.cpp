#include "cobot_command/ros/command/goal_intake.h"

#include <chrono>
#include <set>
#include <string>
#include <vector>

#include "block_messages.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "cobot_command/command/waiting_goals.h"

namespace cobot_command::ros_adapter {
namespace {

using std::chrono::milliseconds;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr auto kPatience = milliseconds(200);

/// A core that writes down what it is told, and a tf that knows the frames in `known`.
class Intake : public ::testing::Test {
 protected:
  void move(blocks::GoalId id, const std::string& frame, milliseconds at = milliseconds(0)) {
    submit(
        id,
        [frame](const Lookups& lookups) -> blocks::Goal {
          cobot_command::MoveAbsoluteGoal message;
          message.target_pose.header.frame_id = frame;
          return toGoal(message, lookups);
        },
        Instant(at));
  }
  void cycle(blocks::GoalId id, const std::string& file, milliseconds at = milliseconds(0)) {
    submit(
        id,
        [file](const Lookups& lookups) -> blocks::Goal {
          cobot_command::PickAndPlaceGoal message;
          message.steps_file = file;
          return toGoal(message, lookups);
        },
        Instant(at));
  }
  void path(blocks::GoalId id, const std::string& file, milliseconds at = milliseconds(0)) {
    submit(
        id,
        [file](const Lookups& lookups) -> blocks::Goal {
          cobot_command::LoadPathGoal message;
          message.path_file = file;
          return toGoal(message, lookups);
        },
        Instant(at));
  }
  template <class Goal>
  void give(blocks::GoalId id, Goal goal, milliseconds at = milliseconds(0)) {
    submit(
        id, [goal](const Lookups&) -> blocks::Goal { return goal; }, Instant(at));
  }

  void submit(blocks::GoalId id, GoalReader reader, Instant now) {
    intake.submit({id, std::move(reader), [this, id] { return early_cancels.count(id) > 0; }}, now);
  }

  void note(blocks::GoalId id, const blocks::Goal& goal) {
    const auto* move = std::get_if<blocks::MoveAbsoluteGoal>(&goal);
    const bool lost = move != nullptr && move->target_pose && !move->target_pose->frame_in_robot_base;
    const auto* cycle = std::get_if<blocks::PickAndPlaceGoal>(&goal);
    const bool unread = cycle != nullptr && !cycle->steps_fault.empty();
    told.push_back(fmt::format("submit {}{}{}", id, lost ? " without its frame" : "",
                               unread ? " without its file" : ""));
  }

  void noteEnd(blocks::GoalId id, const blocks::Outcome& outcome) {
    const bool cancelled = outcome.ending == blocks::Ending::CommandAborted;
    const std::string& why = outcome.error_description;
    told.push_back(
        fmt::format("{} {}: {}", cancelled ? "end" : "refuse", id, why.substr(0, why.find(" while "))));
  }

  std::set<std::string> known;
  std::set<std::string> read;              ///< files
  std::set<blocks::GoalId> early_cancels;  ///< by a cancel that was received before they are submitted
  std::vector<std::string> told;
  Duration patience = kPatience;
  int looks = 0;  ///< for frames
  std::function<void()> on_look;
  GoalIntake intake{
      [this](const std_msgs::Header& header) -> FramePlace {
        ++looks;
        if (const auto what = std::exchange(on_look, nullptr)) what();
        if (known.count(header.frame_id) == 0) return {std::nullopt, "not known"};
        return {arm::Pose::Identity(), ""};
      },
      [this] { return patience; },
      {[this](blocks::GoalId, FileKind kind, const std::string& location) -> std::optional<FileAnswer> {
         if (read.count(location) == 0) return std::nullopt;
         if (kind == FileKind::Points) return PointsAnswer();
         return StepsAnswer();
       },
       [this](blocks::GoalId id) { forgotten.insert(id); }},
      {[this](blocks::GoalId id, const blocks::Goal& goal) { note(id, goal); },
       [this](blocks::GoalId id, blocks::GoalId newest) {
         told.push_back(fmt::format("cancel {} with all until {}", id, newest));
       },
       [this](blocks::Block, blocks::GoalId id, const blocks::Outcome& outcome) { noteEnd(id, outcome); }}};
  std::set<blocks::GoalId> forgotten;  ///< their files
};

TEST_F(Intake, handsOnAGoalWithoutAFrameAtOnce) {
  move(1, "");
  EXPECT_THAT(told, ElementsAre("submit 1"));
  EXPECT_FALSE(intake.isWaiting());
}

TEST_F(Intake, waitsForTheFileOfAPath) {
  path(1, "/path.yaml");
  EXPECT_TRUE(intake.isWaiting());
  read = {"/path.yaml"};
  intake.advance(Instant(milliseconds(10)));
  EXPECT_THAT(told, ElementsAre("submit 1"));
  EXPECT_EQ(forgotten.count(1), 1U);
}

TEST_F(Intake, handsOnAGoalWhoseFrameIsKnownAtOnce) {
  known = {"table"};
  move(1, "table");
  EXPECT_THAT(told, ElementsAre("submit 1"));
}

TEST_F(Intake, waitsAsLongAsWasDueWhenTheGoalCame) {
  patience = milliseconds(3000);
  move(1, "table");
  patience = milliseconds(200);
  intake.advance(Instant(milliseconds(2999)));
  EXPECT_THAT(told, IsEmpty());
  intake.advance(Instant(milliseconds(3000)));
  EXPECT_THAT(told, ElementsAre("submit 1 without its frame"));
}

TEST_F(Intake, waitsForAFrameThatComesLate) {
  move(1, "table");
  EXPECT_THAT(told, IsEmpty());
  EXPECT_TRUE(intake.isWaiting());
  intake.advance(Instant(milliseconds(199)));
  EXPECT_THAT(told, IsEmpty());
  known = {"table"};
  intake.advance(Instant(milliseconds(199)));
  EXPECT_THAT(told, ElementsAre("submit 1"));
  EXPECT_FALSE(intake.isWaiting());
}

TEST_F(Intake, handsOnAGoalWithoutItsFrameWhenThatDoesNotCome) {
  move(1, "nowhere");
  intake.advance(Instant(kPatience));
  EXPECT_THAT(told, ElementsAre("submit 1 without its frame"));
}

TEST_F(Intake, keepsTheOrderOfWhatCameBehindAGoalThatWaits) {
  move(1, "table");
  move(2, "");
  known = {"table"};
  intake.advance(Instant(milliseconds(10)));
  EXPECT_THAT(told, ElementsAre("submit 1", "submit 2"));
}

TEST_F(Intake, countsThePatienceOfEachGoalFromItsOwnArrival) {
  move(1, "nowhere");
  move(2, "nowhere", milliseconds(150));
  intake.advance(Instant(milliseconds(200)));
  EXPECT_THAT(told, ElementsAre("submit 1 without its frame"));
  intake.advance(Instant(milliseconds(350)));
  EXPECT_THAT(told, ElementsAre("submit 1 without its frame", "submit 2 without its frame"));
}

TEST_F(Intake, handsOnAStopAtOnceAndThenEndsWhatFellWithIt) {
  move(1, "table");
  move(2, "");
  give(3, blocks::StopGoal{});
  EXPECT_THAT(told, ElementsAre("submit 3"));
  EXPECT_EQ(intake.fall(3, "stopped"), 2);
  EXPECT_THAT(told, ElementsAre("submit 3", "end 1: stopped", "end 2: stopped"));
  EXPECT_FALSE(intake.isWaiting());
  EXPECT_THAT(forgotten, ElementsAre(1, 2, 3));
}

TEST_F(Intake, leavesWhatCameBehindTheFall) {
  move(1, "table");
  move(2, "table");
  EXPECT_EQ(intake.fall(1, "the command in front failed"), 1);
  known = {"table"};
  intake.advance(Instant(milliseconds(10)));
  EXPECT_THAT(told, ElementsAre("end 1: the command in front failed", "submit 2"));
}

TEST_F(Intake, leavesChecksThatFallWithNothing) {
  move(1, "table");
  give(2, blocks::CheckSequenceGoal{});
  cycle(3, "hangs.yaml");
  EXPECT_EQ(intake.fall(3, "to be finished"), 2);
  intake.advance(Instant(milliseconds(10)));
  EXPECT_THAT(told, ElementsAre("end 1: to be finished", "end 3: to be finished", "submit 2"));
}

TEST_F(Intake, letsAConnectOvertakeWhatWaits) {
  move(1, "table");
  give(2, blocks::ConnectGoal{});
  EXPECT_THAT(told, ElementsAre("submit 2"));
  EXPECT_TRUE(intake.isWaiting());
}

TEST_F(Intake, looksNothingUpAgainForWhatFalls) {
  move(1, "table");
  move(2, "shelf");
  const int before = looks;
  intake.fall(2, "stopped");
  EXPECT_EQ(looks, before);
}

TEST_F(Intake, isBoundedLikeTheQueueOfTheCoreAndLetsPastWhatHalts) {
  const auto full = static_cast<blocks::GoalId>(command::kMostWaiting);
  for (blocks::GoalId id = 1; id <= full; ++id) move(id, "table");
  EXPECT_THAT(told, IsEmpty());
  move(full + 1, "");
  give(full + 2, blocks::CheckSequenceGoal{});
  give(full + 3, blocks::StopGoal{});
  EXPECT_THAT(told, ElementsAre("refuse 65: Too many commands wait: 64 wait", "submit 66", "submit 67"));
  EXPECT_EQ(forgotten.count(full + 1), 1U);
}

TEST_F(Intake, letsAPauseOvertakeWhatWaits) {
  move(1, "table");
  give(2, blocks::ProgramControlGoal{});
  EXPECT_THAT(told, ElementsAre("submit 2"));
  EXPECT_TRUE(intake.isWaiting());
}

TEST_F(Intake, endsAGoalThatIsCancelledWhileItWaitsAndLeavesTheOthers) {
  move(1, "table");
  move(2, "shelf");
  intake.cancel(1, 9);
  EXPECT_THAT(told, ElementsAre("end 1: cancelled"));
  EXPECT_THAT(forgotten, ElementsAre(1));
  EXPECT_TRUE(intake.isWaiting());
  known = {"shelf"};
  intake.advance(Instant(milliseconds(10)));
  EXPECT_THAT(told, ElementsAre("end 1: cancelled", "submit 2"));
}

TEST_F(Intake, waitsUntilTheFileOfAGoalIsRead) {
  cycle(1, "steps.yaml");
  move(2, "");
  intake.advance(Instant(kFilePatience - milliseconds(1)));
  EXPECT_THAT(told, IsEmpty());
  read = {"steps.yaml"};
  intake.advance(Instant(kFilePatience - milliseconds(1)));
  EXPECT_THAT(told, ElementsAre("submit 1", "submit 2"));
  EXPECT_THAT(forgotten, ElementsAre(1, 2));
}

TEST_F(Intake, handsOnAGoalWhoseFileIsNotReadInTime) {
  cycle(1, "hangs.yaml");
  intake.advance(Instant(kFilePatience));
  EXPECT_THAT(told, ElementsAre("submit 1 without its file"));
}

TEST_F(Intake, endsACycleThatIsCancelledWhileItsFileIsRead) {
  cycle(1, "hangs.yaml");
  intake.cancel(1, 9);
  EXPECT_THAT(told, ElementsAre("end 1: cancelled"));
  EXPECT_FALSE(intake.isWaiting());
}

TEST_F(Intake, endsACycleThatFallsWhileItsFileIsRead) {
  cycle(1, "hangs.yaml");
  intake.fall(1, "stopped");
  EXPECT_THAT(told, ElementsAre("end 1: stopped"));
  EXPECT_THAT(forgotten, ElementsAre(1));
}

TEST_F(Intake, handsOnACancelOfAGoalThatTheCoreHasWhileOneWaitsHere) {
  move(1, "");
  move(2, "table");
  intake.cancel(1, 9);
  EXPECT_THAT(told, ElementsAre("submit 1", "cancel 1 with all until 9"));
  EXPECT_TRUE(intake.isWaiting());
}

TEST_F(Intake, endsAGoalWhoseCancelWasReceivedBeforeItsCallbackRan) {
  early_cancels = {1};
  move(1, "");
  EXPECT_THAT(told, ElementsAre("end 1: cancelled before it was started"));
  EXPECT_THAT(forgotten, ElementsAre(1));
}

TEST_F(Intake, endsAGoalThatIsCancelledWhileItsMessageIsRead) {
  submit(
      1,
      [this](const Lookups& /*lookups*/) -> blocks::Goal {
        intake.cancel(1, 9);  // from another thread: no lock is held here
        return blocks::MoveAbsoluteGoal{};
      },
      Instant(milliseconds(0)));
  EXPECT_THAT(told, ElementsAre("end 1: cancelled before it was started"));
}

TEST_F(Intake, endsAGoalThatIsCancelledWhileItsFrameIsLookedUpAgain) {
  move(1, "table");
  move(2, "");
  known = {"table"};
  on_look = [this] { intake.cancel(1, 9); };
  intake.advance(Instant(milliseconds(10)));
  EXPECT_THAT(told, ElementsAre("end 1: cancelled", "submit 2"));
  EXPECT_EQ(forgotten.count(1), 1U);
}

TEST_F(Intake, looksForNothingForAGoalThatFellBeforeItCame) {
  EXPECT_EQ(intake.fall(2, "stopped"), 0);
  move(1, "table");
  EXPECT_THAT(told, ElementsAre("end 1: stopped"));
  move(3, "table");
  EXPECT_TRUE(intake.isWaiting());
}

}  // namespace
}  // namespace cobot_command::ros_adapter
