#include "forecast/forecast.h"

#include "block_goals.h"
#include "motion_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

constexpr std::array<double, 6> kAside{60, 0, 90, 0, 90, 0};

class ForecastTest : public ::testing::Test {
 protected:
  explicit ForecastTest(bool has_model = true)
      : arm_(has_model ? std::make_shared<const arm::ArmModel>(*arm::ArmModel::named("tm5-900")) : nullptr) {}

  /// A frame of a robot that stands there, in known frames; with `velocity` it does not stand.
  void stream(const arm::JointVector& joints, double velocity = 0) {
    link::RobotStatus status;
    for (int frame = 0; frame < 3; ++frame) {
      now_ += 15ms;
      status.received = now_;
      status.joints = joints;
      status.joint_velocities = arm::JointVector::Constant(velocity);
      status.base = arm::Pose::Identity();
      status.tcp = arm::Pose::Identity();
      robot_.update(status);
      forecast_.robotChanged(1s, now_);
    }
  }

  [[nodiscard]] CommandOrder orderOf(const blocks::Goal& goal) const {
    CommandOrder order = forecast_.order(*blocks::GoalRules(goal).command()).value();
    const Origin origin = forecast_.origin(now_);
    const auto planned = forecast_.plan(order, origin);
    EXPECT_TRUE(planned->plan) << planned->plan.error().found;
    takePlan(order, *planned, origin);
    return order;
  }
  [[nodiscard]] static blocks::MoveAbsoluteGoal blended() {
    blocks::MoveAbsoluteGoal goal = testing::moveJoints(kAside);
    goal.blending_enable = true;
    return goal;
  }
  /// Sent and accepted.
  CommandOrder send(const blocks::Goal& goal) {
    const CommandOrder order = orderOf(goal);
    forecast_.sent(order, now_);
    forecast_.accepted(order, now_);
    return order;
  }

  const arm::JointVector home_ = arm::toJointVector({0, 0, 90, 0, 90, 0});
  std::shared_ptr<const arm::ArmModel> arm_;
  robot::RobotWatch robot_;
  std::vector<Action> actions_;
  tables::TableStore tables_;
  SpeedOverride speed_;
  Forecast forecast_{arm_, robot_, tables_, speed_, actions_};
  Instant now_{};
};

TEST_F(ForecastTest, startsWhereTheRobotIsSeenToStand) {
  EXPECT_FALSE(forecast_.origin(now_).start.joints) << "nothing was streamed";
  stream(home_);
  ASSERT_TRUE(forecast_.origin(now_).start.joints);
  EXPECT_TRUE(forecast_.origin(now_).start.joints->isApprox(home_));
  EXPECT_TRUE(forecast_.origin(now_).frames_told);
}

TEST_F(ForecastTest, doesNotKnowWhereAMotionOfOthersWillEnd) {
  stream(home_, 0.5);
  EXPECT_FALSE(forecast_.origin(now_).start.joints);
}

TEST_F(ForecastTest, startsAtTheEndOfABlendedMotionThatIsUnderWay) {
  stream(home_);
  send(blended());

  const Origin next = forecast_.origin(now_ + 10ms);
  ASSERT_TRUE(next.start.joints);
  EXPECT_TRUE(next.start.joints->isApprox(arm::toJointVector(kAside)));
  EXPECT_TRUE(next.behind) << "the next one may blend with it";
  EXPECT_TRUE(forecast_.loose().mayMove());
  EXPECT_FALSE(forecast_.loose().endsUnknown());
}

TEST_F(ForecastTest, startsAtTheTargetOfAMotionWhoseTagIsThere) {
  stream(home_);
  CommandOrder order = orderOf(testing::moveJoints(kAside));
  order.tag = 1;
  forecast_.sent(order, now_);
  forecast_.accepted(order, now_);
  EXPECT_FALSE(forecast_.loose().mayMove()) << "a goal waits for it";

  forecast_.arrived(order, now_ + order.plan->duration);

  EXPECT_TRUE(forecast_.origin(now_).start.joints->isApprox(arm::toJointVector(kAside)));
}

TEST_F(ForecastTest, forgetsThePathOfWhatWasStopped) {
  stream(home_);
  send(blended());
  forecast_.stopped();
  EXPECT_TRUE(forecast_.origin(now_).start.joints->isApprox(home_));
  EXPECT_FALSE(forecast_.loose().mayMove());
}

TEST_F(ForecastTest, holdsBackBehindAStopThatNobodyConfirmed) {
  stream(home_);
  const CommandOrder order = send(blended());
  forecast_.stopFailed("no answer", order.target, now_);
  EXPECT_TRUE(forecast_.loose().holdsBack());
  EXPECT_FALSE(forecast_.origin(now_).start.joints) << "it may move on";
}

TEST_F(ForecastTest, takesABaseThatWasCommandedUntilTheConnectionEnds) {
  stream(home_);
  blocks::ChangeBaseGoal change;
  change.transformation = {100, 0, 0, 0, 0, 0};
  send(change);
  ASSERT_TRUE(forecast_.frames().base);
  EXPECT_NEAR(forecast_.frames().base->translation().x(), 0.1, 1e-9);

  forecast_.disconnected();
  EXPECT_NEAR(forecast_.frames().base->translation().x(), 0, 1e-9) << "what is streamed counts";
}

TEST_F(ForecastTest, knowsNothingBehindAScriptThatSaysMoreThanThisLayerKnows) {
  stream(home_);
  send(blended());
  CommandOrder raw;
  raw.lines = {"SomethingNew(1)"};
  forecast_.sent(raw, now_);
  forecast_.accepted(raw, now_);
  EXPECT_FALSE(forecast_.origin(now_).behind);
}

TEST_F(ForecastTest, tellsThePathOfWhatGoesOut) {
  stream(home_);
  actions_.clear();
  send(testing::moveJoints(kAside));
  ASSERT_FALSE(actions_.empty());
  EXPECT_TRUE(std::holds_alternative<PathPlanned>(actions_.front()));
}

TEST_F(ForecastTest, refusesWhatTheArmCannotReach) {
  stream(home_);
  const blocks::Goal goal = testing::moveJoints({0, 0, 359, 0, 0, 0});
  const CommandOrder order = forecast_.order(*blocks::GoalRules(goal).command()).value();
  const auto planned = forecast_.plan(order, forecast_.origin(now_));
  ASSERT_FALSE(planned->plan);
  EXPECT_NE(planned->plan.error().error_id, 0);
}

class ForecastWithoutModel : public ForecastTest {
 protected:
  ForecastWithoutModel() : ForecastTest(false) {}
};

TEST_F(ForecastWithoutModel, plansNothingAndKnowsTheTargetOfJointsAllTheSame) {
  stream(home_);
  const CommandOrder order = orderOf(testing::moveJoints(kAside));
  EXPECT_FALSE(order.plan);
  ASSERT_TRUE(order.target);
  EXPECT_TRUE(order.target->joints.isApprox(arm::toJointVector(kAside)));
}

TEST_F(ForecastWithoutModel, answersACheckWithThat) {
  stream(home_);
  const blocks::Goal goal = testing::moveJoints(kAside);
  const auto dropped = std::make_shared<const std::atomic<bool>>(false);
  const auto origin = [this](Instant then) { return forecast_.origin(then); };
  const PlanAnswer answer = forecast_.workFor(goal, origin, {})(dropped, now_)();
  EXPECT_EQ(answer.outcome.ending, blocks::Ending::Rejected);
  EXPECT_EQ(answer.outcome.error_id, blocks::own_error::kNoModel);
}

}  // namespace
}  // namespace cobot_command::command
