#include "chain.h"

namespace cobot_command::runtime {
namespace {

using blocks::Ending;
using blocks::Phase;

constexpr double kQuick = 20;  ///< times real time
constexpr double kReal = 1;

struct Chain : ::testing::Test {
  void power(double time_scale) {
    robot.emplace(time_scale);
    commander.emplace(robot->ports().status);
    link = commander->connect(robot->ports());
  }

  std::optional<Robot> robot;
  std::optional<Commander> commander;
  blocks::GoalId link = 0;
};

void expectDone(const std::optional<blocks::Outcome>& outcome) {
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::Done) << outcome->error_id << " " << outcome->error_description;
}

void expectError(const std::optional<blocks::Outcome>& outcome, Ending ending, int error_id) {
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, ending) << outcome->error_description;
  EXPECT_EQ(outcome->error_id, error_id) << outcome->error_description;
  EXPECT_FALSE(outcome->remedy.empty());
}

/// Of the frames received until now, how many say that this tag is complete.
long completions(const Commander& commander, int tag) {
  const std::string report = "01,0" + std::to_string(tag) + ",true";
  const auto frames = commander.told<command::FrameTraced>();
  return std::count_if(frames.begin(), frames.end(), [&](const command::FrameTraced& frame) {
    return !frame.sent && frame.bytes.find(report) != std::string::npos;
  });
}

TEST_F(Chain, endsAPtpMoveWithTheArmAtTheTarget) {
  power(kQuick);
  const std::array<double, 6> target{20, -10, 100, 5, 80, -15};
  const auto outcome = commander->run(moveJoints(target));
  expectDone(outcome);
  EXPECT_TRUE(robot->state().joints.isApprox(arm::toJointVector(target), 1e-9));
  EXPECT_TRUE(outcome->final_joints_deg.has_value());
}

TEST_F(Chain, endsALineWithTheToolAtTheTarget) {
  power(kQuick);
  const auto line = moveLine(kStartJoints, {-50, 60, -40});
  const auto outcome = commander->run(line);
  expectDone(outcome);
  EXPECT_TRUE(robot->state().flange.isApprox(arm::toPose(line.target), 1e-6));
  EXPECT_TRUE(outcome->final_pose_mm_deg.has_value());
}

TEST_F(Chain, isDoneOnlyWithTheTagOfTheMove) {
  power(kQuick);
  for (int tag = 2; tag <= 9; ++tag) {
    auto goal = moveJoints({tag * 2.0, 0, 90, 0, 90, 0});
    goal.command_id = tag;
    const auto outcome = commander->run(goal);
    expectDone(outcome);
    EXPECT_EQ(outcome->command_id_ack, tag);
    EXPECT_EQ(completions(*commander, tag), 1);
  }
}

TEST_F(Chain, waitsForTheTagEvenWhereTheArmStandsAtTheTargetAlready) {
  power(kQuick);
  auto goal = moveJoints(kStartJoints);
  goal.command_id = 4;
  expectDone(commander->run(goal));
  EXPECT_EQ(completions(*commander, 4), 1);
}

TEST_F(Chain, tellsTheStatusOfTheRobotOnTheWay) {
  power(kQuick);
  expectDone(commander->run(moveJoints({30, 0, 90, 0, 90, 0})));
  EXPECT_TRUE(commander->waitFor<command::RobotStatusReceived>([](const auto& received) {
    const auto& joints = received.status.joints;
    return joints && (*joints)[0] > degToRad(1) && (*joints)[0] < degToRad(29);
  }));
  EXPECT_TRUE(commander->waitFor<command::RobotStatusReceived>([](const auto& received) {
    const auto& joints = received.status.joints;
    return joints && std::abs((*joints)[0] - degToRad(30)) < 1e-6;
  }));
}

TEST_F(Chain, refusesASecondMoveWhileOneIsBusy) {
  power(kReal);
  const auto first = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(first, Phase::Active));
  expectError(commander->run(moveJoints(kStartJoints)), Ending::Rejected, 0x11);
}

TEST_F(Chain, refusesWhatCannotBeReachedAndStaysReady) {
  power(kQuick);
  expectError(commander->run(moveLine(kStartJoints, {5000, 0, 0})), Ending::Rejected, 0x201);
  expectDone(commander->run(moveJoints({5, 0, 90, 0, 90, 0})));
}

TEST_F(Chain, refusesAMoveWithoutAConnection) {
  Commander lonely(0);
  expectError(lonely.run(moveJoints(kStartJoints)), Ending::Rejected, 0x10);
}

TEST_F(Chain, stopsTheArmWhenAMoveIsCancelledAndTakesTheNextOne) {
  power(kReal);
  const auto move = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(move, Phase::Active));
  commander->cancel(move);
  const auto outcome = commander->outcomeOf(move);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::CommandAborted) << outcome->error_description;
  expectDone(commander->run(moveJoints(kStartJoints, 100)));
}

TEST_F(Chain, endsTheConnectionNormallyWhenItIsCancelled) {
  power(kQuick);
  commander->cancel(link);
  expectDone(commander->outcomeOf(link));
  expectError(commander->run(moveJoints(kStartJoints)), Ending::Rejected, 0x10);
  link = commander->connect(robot->ports());
  expectDone(commander->run(moveJoints({5, 0, 90, 0, 90, 0})));
}

TEST_F(Chain, endsAMoveAndTheConnectionWhenTheRobotGoesAway) {
  power(kReal);
  const auto move = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(move, Phase::Active));
  robot->powerOff();
  expectError(commander->outcomeOf(move), Ending::Aborted, 0x99);
  expectError(commander->outcomeOf(link), Ending::Aborted, 0x90);
}

TEST_F(Chain, worksAgainAfterTheControllerWasRestarted) {
  power(kQuick);
  expectDone(commander->run(moveJoints({5, 0, 90, 0, 90, 0})));
  const auto ports = robot->ports();
  robot->powerOff();
  expectError(commander->outcomeOf(link), Ending::Aborted, 0x90);
  link = commander->submit(blocks::ConnectGoal{"127.0.0.1", ports.script, 60, {}});
  ASSERT_TRUE(commander->waitFor<command::GoalProgressed>([&](const command::GoalProgressed& progressed) {
    return progressed.goal == link && progressed.progress.text.find("refused") != std::string::npos;
  }));
  Robot restarted(kQuick, ports);
  ASSERT_TRUE(commander->reaches(link, Phase::Connected));
  expectDone(commander->run(moveJoints({-5, 0, 90, 0, 90, 0})));
}

TEST_F(Chain, losesTheConnectionWithTheProjectAndFindsTheNextOne) {
  power(kQuick);
  robot->operate([](auto& controller, Instant now) { controller.operate(simulator::StopProject{}, now); });
  expectError(commander->outcomeOf(link), Ending::Aborted, 0x90);
  robot->operate([](auto& controller, Instant now) { controller.operate(simulator::RunProject{}, now); });
  link = commander->connect(robot->ports());
  expectDone(commander->run(moveJoints({5, 0, 90, 0, 90, 0})));
}

TEST_F(Chain, endsAMoveWhenTheEmergencyStopIsPressed) {
  power(kReal);
  const auto move = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(move, Phase::Active));
  robot->operate(
      [](auto& controller, Instant now) { controller.operate(simulator::SetEmergencyStop{true}, now); });
  const auto outcome = commander->outcomeOf(move);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::Aborted);
}

TEST_F(Chain, endsEveryGoalWhenItIsStoppedAndIsSilentAfterwards) {
  power(kReal);
  const auto move = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(move, Phase::Active));
  commander->stop();
  const auto told = commander->toldCount();
  EXPECT_EQ(commander->told<command::GoalEnded>().size(), 2u);
  for (const auto& ended : commander->told<command::GoalEnded>()) {
    EXPECT_EQ(ended.outcome.ending, Ending::CommandAborted);
  }
  EXPECT_FALSE(commander->runtime().submit(99, moveJoints(kStartJoints)));
  commander->cancel(move);
  commander->stop();
  EXPECT_EQ(commander->toldCount(), told);
}

TEST_F(Chain, hasStoppedTheArmWhenItIsStopped) {
  power(kReal);
  const auto move = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(move, Phase::Active));
  commander->runtime().retire();
  const auto outcome = commander->outcomeOf(move);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::CommandAborted);
  EXPECT_LT(robot->state().velocities.cwiseAbs().maxCoeff(), degToRad(0.1));
  EXPECT_EQ(commander->told<command::GoalEnded>().size(), 1u);  // the link is kept until stop()
  commander->stop();
  EXPECT_EQ(commander->told<command::GoalEnded>().size(), 2u);
}

TEST_F(Chain, doesNotWaitLongForARobotThatDoesNotAnswerTheStop) {
  power(kReal);
  const auto move = commander->submit(endlessMove());
  ASSERT_TRUE(commander->reaches(move, Phase::Active));
  std::promise<void> silent;
  robot->operate([&](auto& controller, Instant now) {
    controller.operate(simulator::SetFault{"silence", true, 0, 0, ""}, now);
    silent.set_value();
  });
  silent.get_future().wait();
  const auto begun = std::chrono::steady_clock::now();
  commander->stop();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, 10 * kRetirement);  // on a loaded machine
  const auto outcome = commander->outcomeOf(move);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, Ending::CommandAborted);
  EXPECT_NE(outcome->error_description.find("may still move"), std::string::npos)
      << outcome->error_description;
}

TEST_F(Chain, mayBeCommandedFromWithinTheObserver) {
  robot.emplace(kQuick);
  link::LinkSettings settings;
  settings.status_port = robot->ports().status;
  testing::EventLog<blocks::GoalId> ended;
  std::unique_ptr<CommandRuntime> runtime;
  const auto observe = [&](const command::Action& action, Instant /*now*/) {
    if (const auto* const progressed = std::get_if<command::GoalProgressed>(&action)) {
      if (progressed->goal == 1 && progressed->progress.phase == Phase::Connected) {
        EXPECT_TRUE(runtime->submit(2, moveJoints({3, 0, 90, 0, 90, 0})));
      }
    } else if (const auto* const end = std::get_if<command::GoalEnded>(&action)) {
      ended.add(end->goal);
      if (end->goal == 2) {
        runtime->cancel(1);
      }
    }
  };
  runtime = std::make_unique<CommandRuntime>(testArm(), settings, observe);
  ASSERT_TRUE(runtime->submit(1, blocks::ConnectGoal{"127.0.0.1", robot->ports().script, 60, {}}));
  EXPECT_TRUE(ended.waitUntil([](const auto& goals) { return goals == std::vector<blocks::GoalId>{2, 1}; }));
  runtime->stop();
}

}  // namespace
}  // namespace cobot_command::runtime
